// Substitution with the two triangles that an elimination leaves in A (echelon.hpp): the plain loops for
// small matrices, the blocked ones (substitute.cpp) for others, with the same bits.
#pragma once

#include <span>

#include "egesp/instruction_set.hpp"

namespace animado::egesp {

// Row-major: reduced (n, n), b (n, m), which becomes X.
void substitute_downward(std::span<const double> reduced, size_t n, std::span<double> b, size_t m,
                         InstructionSet instructions = widest_instruction_set());  // L X = B
void substitute_upward(std::span<const double> reduced, size_t n, std::span<double> b, size_t m,
                       InstructionSet instructions = widest_instruction_set());  // U X = B

// The same with the transposed triangles, for one right-hand side: L is applied as Lᵀ, U as Uᵀ.
void substitute_transposed_downward(std::span<const double> reduced, size_t n,
                                    std::span<double> b);  // Uᵀ x = b
void substitute_transposed_upward(std::span<const double> reduced, size_t n,
                                  std::span<double> b);  // Lᵀ x = b

}  // namespace animado::egesp
