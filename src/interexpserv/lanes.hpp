// A program over many lanes at once: what lanes.cpp is asked to do, once compiled for each instruction set.
// Plain types only: it may share no inline function with the rest of the program.
#pragma once

#include <stddef.h>

#include "interexpserv/instruction.hpp"

namespace animado::interexpserv {

class Table;

inline constexpr size_t kLaneGroup = 8;  // lanes come in multiples of the widest register

struct LaneTape {
  const Instruction* instructions;
  size_t count;
  double* const* rows;  // of each register: `lanes` numbers
  size_t lanes;         // a multiple of kLaneGroup
  const Table* tables;
};

// The same bits in each lane, whatever the width, and those of value_of().
void run_lanes_sse2(const LaneTape& tape);
void run_lanes_avx2(const LaneTape& tape);
void run_lanes_avx512(const LaneTape& tape);

// What is done one by one.
double slow_sine(double x);
double slow_cosine(double x);
double slow_tangent(double x);
double floored_modulo(double a, double b);
double look_up(const Table* tables, double table, double x);

}  // namespace animado::interexpserv
