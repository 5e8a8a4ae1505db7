#include "egesp/large_blocks.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace animado::egesp {
namespace {

size_t whole_pages(size_t bytes) {
  return (bytes + LargeBlocks::kPage - 1) / LargeBlocks::kPage * LargeBlocks::kPage;
}

}  // namespace

LargeBlocks::~LargeBlocks() {
  for (const Block& block : kept_) std::free(block.begin);
}

void* LargeBlocks::allocate(size_t bytes) {
  if (bytes > kLargest) return nullptr;
  if (bytes < kPage) return std::malloc(bytes);
  const std::scoped_lock lock(mutex_);
  Block block = kept_for(bytes);
  if (!block.begin) {
    block = {std::aligned_alloc(kPage, whole_pages(bytes)), whole_pages(bytes)};
    if (!block.begin) return nullptr;
    madvise(block.begin, block.bytes, MADV_HUGEPAGE);  // a hint: refused, its pages are small ones
  }
  used_.push_back(block);
  return block.begin;
}

// What begins small stays malloc's, which alone knows how large it is.
void* LargeBlocks::resize(void* memory, size_t bytes) {
  if (!memory) return allocate(bytes);
  if (bytes > kLargest) return nullptr;
  size_t before;
  {
    const std::scoped_lock lock(mutex_);
    const auto block = used(memory);
    if (block == used_.end()) return std::realloc(memory, bytes);
    before = block->bytes;
  }
  if (bytes <= before) return memory;
  void* const moved = allocate(bytes);
  if (!moved) return nullptr;
  std::memcpy(moved, memory, before);
  release(memory);
  return moved;
}

void LargeBlocks::release(void* memory) {
  const std::scoped_lock lock(mutex_);
  const auto block = used(memory);
  if (block == used_.end()) return std::free(memory);
  keep(taken_from(used_, block));
}

size_t LargeBlocks::kept() const {
  const std::scoped_lock lock(mutex_);
  size_t sum = 0;
  for (const Block& block : kept_) sum += block.bytes;
  return sum;
}

LargeBlocks::Block LargeBlocks::taken_from(std::vector<Block>& blocks, std::vector<Block>::iterator at) {
  const Block block = *at;
  blocks.erase(at);
  return block;
}

// The smallest that is large enough, and not twice as large; an empty one when there is none.
LargeBlocks::Block LargeBlocks::kept_for(size_t bytes) {
  auto best = kept_.end();
  for (auto block = kept_.begin(); block != kept_.end(); ++block) {
    const bool fits = block->bytes >= bytes && block->bytes <= 2 * whole_pages(bytes);
    if (fits && (best == kept_.end() || block->bytes < best->bytes)) best = block;
  }
  return best == kept_.end() ? Block{} : taken_from(kept_, best);
}

std::vector<LargeBlocks::Block>::iterator LargeBlocks::used(void* begin) {
  return std::ranges::find(used_, begin, &Block::begin);
}

void LargeBlocks::keep(Block block) {
  if (block.bytes > kMostKept) return std::free(block.begin);
  size_t room = kMostKept;
  for (const Block& kept : kept_) room -= kept.bytes;
  for (; room < block.bytes; room += kept_.front().bytes, kept_.erase(kept_.begin()))
    std::free(kept_.front().begin);
  madvise(block.begin, block.bytes, MADV_FREE);  // the system's where it needs it
  kept_.push_back(block);
}

}  // namespace animado::egesp
