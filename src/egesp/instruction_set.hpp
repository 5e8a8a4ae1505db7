// Which of the kernels that were compiled for several instruction sets runs.
#pragma once

namespace animado::egesp {

enum class InstructionSet { scalar, sse2, avx2, avx512 };
InstructionSet widest_instruction_set();  // of this machine

}  // namespace animado::egesp
