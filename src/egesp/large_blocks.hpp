// Memory like malloc's for what is large, lives shortly and comes again, as the factors of sparse systems. A
// large block lies in huge pages where the system grants them, and is kept when it is free for who asks next:
// new memory is asked of the kernel page by page, and to look up small pages takes as long as some of the
// arithmetic (docs/performance.md). What is kept may be taken back by a system that is short of memory.
#pragma once

#include <cstddef>
#include <mutex>
#include <vector>

namespace animado::egesp {

class LargeBlocks {
 public:
  static constexpr size_t kPage = size_t{2} << 20;        // bytes; smaller pieces are malloc's
  static constexpr size_t kLargest = size_t{1} << 30;     // bytes; who asks for more gets nothing
  static constexpr size_t kMostKept = size_t{256} << 20;  // bytes of all blocks that are free

  LargeBlocks() = default;
  ~LargeBlocks();
  LargeBlocks(const LargeBlocks&) = delete;
  LargeBlocks& operator=(const LargeBlocks&) = delete;

  // As malloc, realloc and free: null when there is no memory.
  void* allocate(size_t bytes);
  void* resize(void* memory, size_t bytes);
  void release(void* memory);

  size_t kept() const;  // bytes

 private:
  struct Block {
    void* begin = nullptr;
    size_t bytes = 0;
  };
  static Block taken_from(std::vector<Block>& blocks, std::vector<Block>::iterator at);
  Block kept_for(size_t bytes);
  std::vector<Block>::iterator used(void* begin);
  void keep(Block block);

  mutable std::mutex mutex_;
  std::vector<Block> used_, kept_;  // the longest kept first
};

}  // namespace animado::egesp
