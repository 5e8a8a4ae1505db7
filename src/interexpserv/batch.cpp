// One program for many: blocks of lanes short enough that all registers of a block stay in the L1 cache, an
// operation at a time over a block. Lanes that do not fill the widest register are evaluated in a block of
// their own, padded with copies of the last one.
#include <algorithm>
#include <array>

#include "interexpserv/lanes.hpp"
#include "interexpserv/program.hpp"

namespace animado::interexpserv {
namespace {

constexpr size_t kLongestBlock = 128;  // lanes: 1 KiB a register
constexpr size_t kScratch = kMaxRegisters * kLaneGroup;

using Kernel = void (*)(const LaneTape&);

Kernel kernel_for(InstructionSet instructions) {
  switch (instructions) {
    case InstructionSet::avx512:
      return run_lanes_avx512;
    case InstructionSet::avx2:
      return run_lanes_avx2;
    default:
      return run_lanes_sse2;
  }
}

class Batch {
 public:
  Batch(const CompiledCode& code, std::span<const Lanes> inputs, std::span<double* const> out, Kernel kernel)
      : code_(code), inputs_(inputs), out_(out), kernel_(kernel) {}

  void run(size_t count) {
    const size_t room = kScratch / std::max<size_t>(code_.registers, 1) / kLaneGroup * kLaneGroup;
    const size_t block = std::min(kLongestBlock, room), whole = count / kLaneGroup * kLaneGroup;
    lay_out(block);
    for (size_t first = 0; first < whole; first += block) run_block(first, std::min(block, whole - first));
    if (whole < count) run_rest(whole, count - whole);
  }

 private:
  double* scratch(size_t r, size_t lanes) { return scratch_ + r * lanes; }

  // Constants and what all lanes share are written once, into rows of their own.
  void lay_out(size_t lanes) {
    for (size_t r = 0; r < code_.registers; ++r) rows_[r] = scratch(r, lanes);
    for (size_t r = 0; r < code_.constants.size(); ++r) std::fill_n(rows_[r], lanes, code_.constants[r]);
    for (size_t i = 0; i < inputs_.size(); ++i) {
      if (inputs_[i].shared) std::fill_n(rows_[code_.constants.size() + i], lanes, *inputs_[i].values);
    }
  }

  // Whole blocks are read and written where they lie.
  void run_block(size_t first, size_t lanes) {
    const size_t constants = code_.constants.size();
    for (size_t i = 0; i < inputs_.size(); ++i) {
      if (!inputs_[i].shared) rows_[constants + i] = const_cast<double*>(inputs_[i].values) + first;
    }
    for (size_t k = 0; k < out_.size(); ++k) {
      const Register r = code_.result.at[k];
      if (r >= constants + inputs_.size()) rows_[r] = out_[k] + first;
    }
    run_kernel(lanes);
    for (size_t k = 0; k < out_.size(); ++k) {
      const double* const row = rows_[code_.result.at[k]];
      if (row != out_[k] + first) std::copy_n(row, lanes, out_[k] + first);
    }
  }

  void run_rest(size_t first, size_t count) {
    lay_out(kLaneGroup);
    for (size_t i = 0; i < inputs_.size(); ++i) {
      if (inputs_[i].shared) continue;
      double* const row = rows_[code_.constants.size() + i];
      std::copy_n(inputs_[i].values + first, count, row);
      std::fill_n(row + count, kLaneGroup - count, row[count - 1]);
    }
    run_kernel(kLaneGroup);
    for (size_t k = 0; k < out_.size(); ++k) std::copy_n(rows_[code_.result.at[k]], count, out_[k] + first);
  }

  void run_kernel(size_t lanes) {
    kernel_({code_.instructions.data(), code_.instructions.size(), rows_, lanes,
             code_.tables ? code_.tables->data() : nullptr});
  }

  const CompiledCode& code_;
  std::span<const Lanes> inputs_;
  std::span<double* const> out_;
  Kernel kernel_;
  double* rows_[kMaxRegisters];
  alignas(64) double scratch_[kScratch];  // touched as far as it is needed
};

}  // namespace

InstructionSet best_instruction_set() {
  static const InstructionSet best = [] {
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl")) {
      return InstructionSet::avx512;
    }
    return __builtin_cpu_supports("avx2") ? InstructionSet::avx2 : InstructionSet::sse2;
  }();
  return best;
}

void Program::evaluate_batch(std::span<const Lanes> inputs, size_t count, std::span<double* const> out,
                             InstructionSet instructions) const {
  assert(inputs.size() == input_count() && out.size() == width_of(type()));
  Batch(code_, inputs, out, kernel_for(instructions)).run(count);
}

}  // namespace animado::interexpserv
