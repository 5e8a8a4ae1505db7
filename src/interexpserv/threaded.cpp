#include "interexpserv/threaded.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "interexpserv/builder.hpp"
#include "interexpserv/elementary.hpp"
#include "interexpserv/lane_exp.hpp"
#include "interexpserv/lane_trig.hpp"

namespace animado::interexpserv {
namespace {

static_assert(kWidth == 1);

using Run = decltype(Step::run);

double read(Location from, const Frame& frame) {
  return frame.numbers[static_cast<size_t>(from.place)][from.at];
}
template <Place place>
ANIMADO_INLINE double read(Location from, double last, const Frame& frame) {
  if constexpr (place == Place::last) {
    return last;
  } else {
    return frame.numbers[static_cast<size_t>(place)][from.at];
  }
}

// The end of every step. It is a jump, because all steps have the same parameters.
ANIMADO_INLINE void hand_on(double value, const Step* step, const Frame& frame) {
  frame.results[step->result] = value;
  return step[1].run(value, step + 1, frame);
}

// The step of an operation whose operands are in certain places.
template <auto operation, size_t operands, Place a, Place b, Place c>
void run(double last, const Step* step, const Frame& frame) {
  const double x = read<a>(step->a, last, frame);
  if constexpr (operands == 1) {
    return hand_on(operation(x), step, frame);
  } else {
    const double y = read<b>(step->b, last, frame);
    if constexpr (operands == 2) {
      return hand_on(operation(x, y), step, frame);
    } else {
      return hand_on(operation(x, y, read<c>(step->c, last, frame)), step, frame);
    }
  }
}

// Of an operation beside which it takes no time to find the operands.
void run_any(double, const Step* step, const Frame& frame) {
  const double a = read(step->a, frame), b = read(step->b, frame), c = read(step->c, frame);
  return hand_on(value_of(step->op, a, b, c, frame.tables), step, frame);
}

template <Place place>
void finish(double last, const Step* step, const Frame& frame) {
  *frame.out = read<place>(step->a, last, frame);
}
void finish_vector(double, const Step* step, const Frame& frame) {
  frame.out[0] = read(step->a, frame);
  frame.out[1] = read(step->b, frame);
  frame.out[2] = read(step->c, frame);
}

// The one of run<operation, …> for the places of the operands of `s`.
template <auto operation, size_t operands>
Run run_at(const Step& s) {
  constexpr size_t count = size_t{1} << (2 * operands);  // four places each
  constexpr auto all_places = []<size_t... i>(std::index_sequence<i...>) {
    return std::array{run<operation, operands, Place(i & 3), Place(i >> 2 & 3), Place(i >> 4)>...};
  }
  (std::make_index_sequence<count>());
  const auto digit = [](Location operand) { return static_cast<size_t>(operand.place); };
  return all_places[(digit(s.a) | digit(s.b) << 2 | digit(s.c) << 4) % count];
}

#define ONE(expression) run_at<[](double a) { return expression; }, 1>(s)
#define TWO(expression) run_at<[](double a, double b) { return expression; }, 2>(s)
#define THREE(expression) run_at<[](double a, double b, double c) { return expression; }, 3>(s)

// clang-format off
Run run_of(const Step& s) {
  switch (s.op) {
    case Op::add: return TWO(a + b);
    case Op::subtract: return TWO(a - b);
    case Op::multiply: return TWO(a * b);
    case Op::divide: return TWO(a / b);
    case Op::negate: return ONE(-a);
    case Op::less: return TWO(a < b ? 1.0 : 0.0);
    case Op::less_equal: return TWO(a <= b ? 1.0 : 0.0);
    case Op::both: return TWO(((a != 0) & (b != 0)) ? 1.0 : 0.0);
    case Op::select: return THREE(a != 0 ? b : c);
    case Op::sine: return ONE(sine(Lane{a})[0]);
    case Op::cosine: return ONE(cosine(Lane{a})[0]);
    case Op::exp: return ONE(exponential(Lane{a})[0]);
    case Op::sqrt: return ONE(std::sqrt(a));
    case Op::absolute: return ONE(std::fabs(a));
    default: return run_any;
  }
}

Run finish_of(Type result, Place place) {
  if (result == Type::vector) return finish_vector;
  switch (place) {
    case Place::constants: return finish<Place::constants>;
    case Place::inputs: return finish<Place::inputs>;
    case Place::results: return finish<Place::results>;
    default: return finish<Place::last>;
  }
}
// clang-format on

}  // namespace

std::vector<Step> threaded(const CompiledCode& code) {
  const size_t inputs = code.constants.size(), results = inputs + code.input_count;  // their first registers
  int last = -1;                                                                     // of the step before
  const auto located = [&](Register r) -> Location {
    if (r < inputs) return {Place::constants, r};
    if (r < results) return {Place::inputs, static_cast<Register>(r - inputs)};
    return {r == last ? Place::last : Place::results, static_cast<Register>(r - results)};
  };
  std::vector<Step> steps;
  steps.reserve(code.instructions.size() + 1);
  for (const Instruction& i : code.instructions) {
    Step step = {nullptr, i.op, located(i.out).at, located(i.a), located(i.b), located(i.c)};
    step.run = run_of(step);
    steps.push_back(step);
    last = i.out;
  }
  const auto& at = code.result.at;
  steps.push_back({finish_of(code.result.type, located(at[0]).place),
                   {},
                   0,
                   located(at[0]),
                   located(at[1]),
                   located(at[2])});
  return steps;
}

}  // namespace animado::interexpserv
