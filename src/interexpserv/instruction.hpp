// The machine that programs run on. It knows plain numbers only: a vector is three of them, a boolean is 0
// or 1. Registers hold the constants, then the inputs, then what instructions write.
//
// No standard header with inline functions: lanes.cpp reads this for every instruction set.
#pragma once

#include <stdint.h>

namespace animado::interexpserv {

using Register = uint16_t;

// IEEE 754 throughout: nothing is refused, NaN and infinity pass through.
// clang-format off
enum class Op : uint8_t {
  add, subtract, multiply, divide, negate, power,
  less, less_equal, equal, both, either, invert,  // yield booleans
  select,                                         // a ? b : c
  sine, cosine, tangent, arcsine, arccosine, arctangent, arctangent2,
  sinh, cosh, tanh, exp, log, log10, sqrt, cbrt,
  absolute, sign, floor, ceil, round, minimum, maximum, modulo, hypot,
  random,  // of seed a, place b, stream c
  table,   // number b of the program's tables, at a
};
// clang-format on

struct Instruction {
  Op op;
  Register out, a, b, c;  // operands that the operation does not have repeat a
};

}  // namespace animado::interexpserv
