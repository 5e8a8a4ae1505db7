// Memory for numbers that are passed over again and again, on the boundaries that vector registers like.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>

namespace animado::egesp {

class AlignedMemory {
 public:
  AlignedMemory() = default;
  // `count` doubles on the boundary of a cache line; not initialised.
  explicit AlignedMemory(size_t count) : count_(count) {
    constexpr size_t kLine = 64;
    const size_t bytes = (count * sizeof(double) + kLine - 1) / kLine * kLine;
    numbers_.reset(static_cast<double*>(std::aligned_alloc(kLine, bytes)));
    if (!numbers_ && bytes > 0) throw std::bad_alloc();
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
