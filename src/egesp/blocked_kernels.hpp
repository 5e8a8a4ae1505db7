// Which of the blocked kernels runs, and the room that it works in.
#pragma once

#include <memory>
#include <new>

#include "egesp/blocked.hpp"
#include "egesp/instruction_set.hpp"

namespace animado::egesp {

// Rows or columns up to which plain loops are as fast as the blocked ones.
inline constexpr size_t kPlain = 48;

constexpr const BlockedKernels& blocked_kernels(InstructionSet instructions) {
  switch (instructions) {
    case InstructionSet::avx512:
      return avx512::kKernels;
    case InstructionSet::avx2:
      return avx2::kKernels;
    default:
      return sse2::kKernels;
  }
}

// Numbers on a boundary of the widest register.
class AlignedNumbers {
 public:
  explicit AlignedNumbers(size_t count) : numbers_(new (kBoundary) double[count]) {}
  double* data() const { return numbers_.get(); }

 private:
  static constexpr std::align_val_t kBoundary{64};
  struct Delete {
    void operator()(double* numbers) const { operator delete[](numbers, kBoundary); }
  };
  std::unique_ptr<double, Delete> numbers_;
};

}  // namespace animado::egesp
