// How good a solution is, and one step to make it better.
//
//   backward error   η = ‖b − A x‖ / (‖A‖ ‖x‖ + ‖b‖) in the maximum norm: the smallest relative change of A
//   and b
//                    that makes x exact (Rigal and Gaches, J. ACM 14 (1967) 543)
//   condition        1/κ = 1 / (‖A‖₁ ‖A⁻¹‖₁), ‖A⁻¹‖₁ estimated from below by a few solutions with A and Aᵀ
//                    (Hager, SIAM J. Sci. Stat. Comput. 5 (1984) 311; Higham, Accuracy and Stability of
//                    Numerical Algorithms (2002), algorithm 15.4): rarely wrong by more than a factor of 3
//   refinement       r ← b − A x;  A d = r;  x ← x + d   (Higham 2002, chapter 12)
//
// Deviation: the residual of the refinement is summed in the 80-bit format of x87 and not in pairs of
// doubles; its 11 further bits are what one step can use.
#pragma once

#include "egesp/factored.hpp"

namespace animado::egesp {

// The largest over the m right-hand sides. b, x: (n, m), row-major.
double backward_error(const Factored& a, std::span<const double> b, std::span<const double> x, size_t m);

// One step for each right-hand side. One whose backward error would grow beyond a rounding is
// left as it was.
void refine(const Factored& a, std::span<const double> b, std::span<double> x, size_t m);

double reciprocal_condition(const Factored& a);

// 1/κ below which a solution may have no correct digit left.
inline constexpr double kIllConditioned = 0x1p-52;

}  // namespace animado::egesp
