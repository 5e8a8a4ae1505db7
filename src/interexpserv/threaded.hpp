// A program for one evaluation as threaded code ([BEL73]): each step holds the address of what carries it
// out, which ends in a jump to what carries out the next. What a step yields is handed on in a register, and
// written down for steps further on.
#pragma once

#include <vector>

#include "interexpserv/instruction.hpp"

namespace animado::interexpserv {

struct CompiledCode;
class Table;

// Where an operand lies. `last` is what the step before yielded, which lies among the results as well.
enum class Place : uint8_t { constants, inputs, results, last };
struct Location {
  Place place;
  Register at;
};

// One evaluation.
struct Frame {
  const double* numbers[4];  // by Place
  double *results, *out;
  const Table* tables;
};

struct Step {
  void (*run)(double last, const Step* step, const Frame& frame);
  Op op;
  Register result;  // its place among the results
  Location a, b, c;
};

// The steps of `code`; one more writes what it yields to `out`.
std::vector<Step> threaded(const CompiledCode& code);

}  // namespace animado::interexpserv
