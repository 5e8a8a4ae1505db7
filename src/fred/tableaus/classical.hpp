// Methods for steps of one length.
#pragma once

#include "fred/tableaus/coefficients.hpp"

namespace animado::fred {

// clang-format off
inline constexpr Coefficients<4> kRk4 = {
    "rk4", "the classical method: Kutta, Z. Math. Phys. 46 (1901); Hairer, Nørsett, Wanner, Solving ODE I (1993), II.1", 4,
    {0, 1. / 2, 1. / 2, 1},
    {1. / 6, 1. / 3, 1. / 3, 1. / 6},
    {{},
     {1. / 2},
     {0, 1. / 2},
     {0, 0, 1}}};

// Without Gill's running correction of rounding errors, which was made for fixed-point registers.
inline constexpr double kRoot2 = 1.41421356237309504880;
inline constexpr Coefficients<4> kGill = {
    "gill", "Gill, Proc. Camb. Phil. Soc. 47 (1951) 96–108", 4,
    {0, 1. / 2, 1. / 2, 1},
    {1. / 6, (2 - kRoot2) / 6, (2 + kRoot2) / 6, 1. / 6},
    {{},
     {1. / 2},
     {(kRoot2 - 1) / 2, 1 - kRoot2 / 2},
     {0, -kRoot2 / 2, 1 + kRoot2 / 2}}};

inline constexpr Coefficients<4> kRk38 = {
    "rk38", "the 3/8 rule: Kutta, Z. Math. Phys. 46 (1901); Hairer, Nørsett, Wanner, Solving ODE I (1993), II.1", 4,
    {0, 1. / 3, 2. / 3, 1},
    {1. / 8, 3. / 8, 3. / 8, 1. / 8},
    {{},
     {1. / 3},
     {-1. / 3, 1},
     {1, -1, 1}}};

inline constexpr Coefficients<3> kHeun3 = {
    "heun3", "Heun, Z. Math. Phys. 45 (1900) 23–38", 3,
    {0, 1. / 3, 2. / 3},
    {1. / 4, 0, 3. / 4},
    {{},
     {1. / 3},
     {0, 2. / 3}}};

inline constexpr Coefficients<2> kMidpoint = {
    "midpoint", "Runge, Math. Ann. 46 (1895) 167–178", 2,
    {0, 1. / 2},
    {0, 1},
    {{},
     {1. / 2}}};

inline constexpr Coefficients<2> kHeun = {
    "heun", "the trapezoidal rule made explicit: Heun, Z. Math. Phys. 45 (1900) 23–38", 2,
    {0, 1},
    {1. / 2, 1. / 2},
    {{},
     {1}}};

inline constexpr Coefficients<1> kEuler = {
    "euler", "Euler, Institutionum calculi integralis I (1768), 650", 1,
    {0},
    {1},
    {}};
// clang-format on

}  // namespace animado::fred
