// Memory for numbers that are passed over again and again: on pages of 2 MiB where the system has them, since
// a pass over 4 KiB pages waits for their addresses.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>

namespace animado::egesp {

class LargeMemory {
 public:
  LargeMemory() = default;
  // `count` doubles on a boundary of a cache line or of a large page; not initialised.
  explicit LargeMemory(size_t count) : count_(count) {
    constexpr size_t kLine = 64, kPage = size_t{2} << 20;
    const size_t bytes = count * sizeof(double), boundary = bytes < kPage ? kLine : kPage;
    numbers_.reset(
        static_cast<double*>(std::aligned_alloc(boundary, (bytes + boundary - 1) / boundary * boundary)));
    if (!numbers_ && bytes > 0) throw std::bad_alloc();
    // A hint: without large pages the numbers are the same.
    if (boundary == kPage) madvise(numbers_.get(), bytes, MADV_HUGEPAGE);
  }

  std::span<double> numbers() const { return {numbers_.get(), count_}; }

 private:
  struct Free {
    void operator()(double* p) const { std::free(p); }
  };
  std::unique_ptr<double[], Free> numbers_;
  size_t count_ = 0;
};

}  // namespace animado::egesp
