#include "interexpserv/functions.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <numbers>

namespace animado::interexpserv {
namespace {

using Arguments = std::span<const Operand>;

template <Op op>
Operand scalar_of(Builder& b, Arguments a) {
  Register result = a[0].at[0];
  if (a.size() == 1) return Operand::scalar(b.apply(op, result));
  for (size_t i = 1; i < a.size(); ++i) result = b.apply(op, result, a[i].at[0]);
  return Operand::scalar(result);
}

template <Op op>
Operand boolean_of(Builder& b, Arguments a) {
  return Operand::boolean(a.size() == 1 ? b.apply(op, a[0].at[0]) : b.apply(op, a[0].at[0], a[1].at[0]));
}

// a > b as b < a
template <Op op>
Operand reversed(Builder& b, Arguments a) {
  return Operand::boolean(b.apply(op, a[1].at[0], a[0].at[0]));
}

template <Op op>
Operand vector_of(Builder& b, Arguments a) {
  Operand result{Type::vector, {}, kPlain};
  for (size_t i = 0; i < 3; ++i) {
    const Register left = a[0].at[a[0].type == Type::vector ? i : 0];
    result.at[i] =
        a.size() == 1 ? b.apply(op, left) : b.apply(op, left, a[1].at[a[1].type == Type::vector ? i : 0]);
  }
  return result;
}

Operand same(Builder&, Arguments a) {
  return a[0];
}

Operand equal(Builder& b, Arguments a) {
  Register all = b.apply(Op::equal, a[0].at[0], a[1].at[0]);
  for (size_t i = 1; i < width_of(a[0].type); ++i) {
    all = b.apply(Op::both, all, b.apply(Op::equal, a[0].at[i], a[1].at[i]));
  }
  return Operand::boolean(all);
}

Operand differs(Builder& b, Arguments a) {
  return Operand::boolean(b.apply(Op::invert, equal(b, a).at[0]));
}

Operand choose(Builder& b, Arguments a) {
  Operand result{a[1].type, {}, kPlain};
  for (size_t i = 0; i < width_of(result.type); ++i) {
    result.at[i] = b.apply(Op::select, a[0].at[0], a[1].at[i], a[2].at[i]);
  }
  return result;
}

template <size_t i>
Operand component(Builder&, Arguments a) {
  return Operand::scalar(a[0].at[i]);
}

Operand make_vector(Builder&, Arguments a) {
  return Operand::vector(a[0].at[0], a[1].at[0], a[2].at[0]);
}

Register dot_product(Builder& b, const Operand& u, const Operand& v) {
  Register sum = b.apply(Op::multiply, u.at[0], v.at[0]);
  for (size_t i = 1; i < 3; ++i) sum = b.apply(Op::add, sum, b.apply(Op::multiply, u.at[i], v.at[i]));
  return sum;
}

Operand dot(Builder& b, Arguments a) {
  return Operand::scalar(dot_product(b, a[0], a[1]));
}

Operand cross(Builder& b, Arguments a) {
  Operand result{Type::vector, {}, kPlain};
  for (size_t i = 0; i < 3; ++i) {
    const size_t j = (i + 1) % 3, k = (i + 2) % 3;
    result.at[i] = b.apply(Op::subtract, b.apply(Op::multiply, a[0].at[j], a[1].at[k]),
                           b.apply(Op::multiply, a[0].at[k], a[1].at[j]));
  }
  return result;
}

Operand norm(Builder& b, Arguments a) {
  return Operand::scalar(b.apply(Op::sqrt, dot_product(b, a[0], a[0])));
}

Operand normalize(Builder& b, Arguments a) {
  const std::array<Operand, 2> quotient = {a[0], norm(b, a)};
  return vector_of<Op::divide>(b, quotient);
}

Operand clamp(Builder& b, Arguments a) {
  return Operand::scalar(b.apply(Op::minimum, b.apply(Op::maximum, a[0].at[0], a[1].at[0]), a[2].at[0]));
}

Operand step(Builder& b, Arguments a) {
  const Register before = b.apply(Op::less, a[1].at[0], a[0].at[0]);
  return Operand::scalar(b.apply(Op::select, before, b.constant(0.0), b.constant(1.0)));
}

// s² (3 − 2 s) with s = (x − e0) / (e1 − e0) kept in 0…1
Operand smoothstep(Builder& b, Arguments a) {
  const Register span = b.apply(Op::subtract, a[1].at[0], a[0].at[0]);
  const Register way = b.apply(Op::divide, b.apply(Op::subtract, a[2].at[0], a[0].at[0]), span);
  const Register s = b.apply(Op::minimum, b.apply(Op::maximum, way, b.constant(0.0)), b.constant(1.0));
  const Register fall = b.apply(Op::subtract, b.constant(3.0), b.apply(Op::multiply, b.constant(2.0), s));
  return Operand::scalar(b.apply(Op::multiply, b.apply(Op::multiply, s, s), fall));
}

Operand random(Builder& b, Arguments a) {
  return Operand::scalar(b.apply(Op::random, a[0].at[0], a[1].at[0], b.constant(0.0)));
}

// Box and Muller: √(−2 log(1 − u)) cos(2π w), u and w of two streams
Operand gauss(Builder& b, Arguments a) {
  const Register u = b.apply(Op::random, a[0].at[0], a[1].at[0], b.constant(1.0));
  const Register w = b.apply(Op::random, a[0].at[0], a[1].at[0], b.constant(2.0));
  const Register log = b.apply(Op::log, b.apply(Op::subtract, b.constant(1.0), u));
  const Register radius = b.apply(Op::sqrt, b.apply(Op::multiply, b.constant(-2.0), log));
  const Register angle = b.apply(Op::multiply, b.constant(2 * std::numbers::pi), w);
  return Operand::scalar(b.apply(Op::multiply, radius, b.apply(Op::cosine, angle)));
}

// From one random number at ⌊x⌋ to that at ⌊x⌋ + 1 by s³ (10 − 15 s + 6 s²): twice differentiable
Operand noise(Builder& b, Arguments a) {
  const Register x = a[1].at[0], floor = b.apply(Op::floor, x), s = b.apply(Op::subtract, x, floor);
  const auto value = [&](Register at) {
    const Register u = b.apply(Op::random, a[0].at[0], at, b.constant(3.0));
    return b.apply(Op::subtract, b.apply(Op::multiply, b.constant(2.0), u), b.constant(1.0));
  };
  const Register from = value(floor), to = value(b.apply(Op::add, floor, b.constant(1.0)));
  const Register inner =
      b.apply(Op::add, b.constant(10.0),
              b.apply(Op::multiply, s,
                      b.apply(Op::subtract, b.apply(Op::multiply, b.constant(6.0), s), b.constant(15.0))));
  const Register cube = b.apply(Op::multiply, b.apply(Op::multiply, s, s), s);
  const Register way = b.apply(Op::multiply, cube, inner);
  return Operand::scalar(b.apply(Op::add, from, b.apply(Op::multiply, way, b.apply(Op::subtract, to, from))));
}

constexpr Type kB = Type::boolean, kS = Type::scalar, kV = Type::vector;

constexpr Function kFunctions[] = {
    {"+", "ss", kS, Rule::same, scalar_of<Op::add>, "sum"},
    {"+", "vv", kV, Rule::same, vector_of<Op::add>, "sum"},
    {"-", "ss", kS, Rule::same, scalar_of<Op::subtract>, "difference"},
    {"-", "vv", kV, Rule::same, vector_of<Op::subtract>, "difference"},
    {"*", "ss", kS, Rule::product, scalar_of<Op::multiply>, "product"},
    {"*", "sv", kV, Rule::product, vector_of<Op::multiply>, "multiple of a vector"},
    {"*", "vs", kV, Rule::product, vector_of<Op::multiply>, "multiple of a vector"},
    {"/", "ss", kS, Rule::quotient, scalar_of<Op::divide>, "quotient; x / 0 is infinite, 0 / 0 is NaN"},
    {"/", "vs", kV, Rule::quotient, vector_of<Op::divide>, "a vector divided by a number"},
    {"^", "ss", kS, Rule::power, scalar_of<Op::power>, "power; a^b^c is a^(b^c), -a^b is -(a^b)"},
    {"-", "s", kS, Rule::same, scalar_of<Op::negate>, "sign changed"},
    {"-", "v", kV, Rule::same, vector_of<Op::negate>, "turned round"},
    {"+", "s", kS, Rule::same, same, "itself"},
    {"+", "v", kV, Rule::same, same, "itself"},
    {"<", "ss", kB, Rule::compared, boolean_of<Op::less>, "less"},
    {"<=", "ss", kB, Rule::compared, boolean_of<Op::less_equal>, "less or equal"},
    {">", "ss", kB, Rule::compared, reversed<Op::less>, "greater"},
    {">=", "ss", kB, Rule::compared, reversed<Op::less_equal>, "greater or equal"},
    {"==", "bb", kB, Rule::compared, equal, "both or neither"},
    {"==", "ss", kB, Rule::compared, equal, "equal"},
    {"==", "vv", kB, Rule::compared, equal, "equal in all components"},
    {"!=", "bb", kB, Rule::compared, differs, "one of them alone"},
    {"!=", "ss", kB, Rule::compared, differs, "different"},
    {"!=", "vv", kB, Rule::compared, differs, "different in a component"},
    {"not", "b", kB, Rule::any, boolean_of<Op::invert>, "the contrary"},
    {"and", "bb", kB, Rule::any, boolean_of<Op::both>, "both"},
    {"or", "bb", kB, Rule::any, boolean_of<Op::either>, "one of them, or both"},
    {"?:", "bbb", kB, Rule::choice, choose, "c ? a : b is a where c holds, else b"},
    {"?:", "bss", kS, Rule::choice, choose, "c ? a : b is a where c holds, else b"},
    {"?:", "bvv", kV, Rule::choice, choose, "c ? a : b is a where c holds, else b"},
    {"(,,)", "sss", kV, Rule::same, make_vector, "the vector (x, y, z)"},
    {".x", "v", kS, Rule::first, component<0>, "first component"},
    {".y", "v", kS, Rule::first, component<1>, "second component"},
    {".z", "v", kS, Rule::first, component<2>, "third component"},
    {"if", "bbb", kB, Rule::choice, choose, "if(c, a, b) is c ? a : b"},
    {"if", "bss", kS, Rule::choice, choose, "if(c, a, b) is c ? a : b"},
    {"if", "bvv", kV, Rule::choice, choose, "if(c, a, b) is c ? a : b"},
    {"sin", "s", kS, Rule::number, scalar_of<Op::sine>, "sine of an angle in radians"},
    {"cos", "s", kS, Rule::number, scalar_of<Op::cosine>, "cosine"},
    {"tan", "s", kS, Rule::number, scalar_of<Op::tangent>, "tangent"},
    {"asin", "s", kS, Rule::number, scalar_of<Op::arcsine>, "angle in -pi/2 … pi/2 with this sine"},
    {"acos", "s", kS, Rule::number, scalar_of<Op::arccosine>, "angle in 0 … pi with this cosine"},
    {"atan", "s", kS, Rule::number, scalar_of<Op::arctangent>, "angle in -pi/2 … pi/2 with this tangent"},
    {"atan2", "ss", kS, Rule::compared, scalar_of<Op::arctangent2>,
     "atan2(y, x): angle of the point (x, y), in -pi … pi"},
    {"sinh", "s", kS, Rule::number, scalar_of<Op::sinh>, "hyperbolic sine"},
    {"cosh", "s", kS, Rule::number, scalar_of<Op::cosh>, "hyperbolic cosine"},
    {"tanh", "s", kS, Rule::number, scalar_of<Op::tanh>, "hyperbolic tangent"},
    {"exp", "s", kS, Rule::number, scalar_of<Op::exp>, "e^x"},
    {"log", "s", kS, Rule::number, scalar_of<Op::log>, "natural logarithm"},
    {"log10", "s", kS, Rule::number, scalar_of<Op::log10>, "decimal logarithm"},
    {"sqrt", "s", kS, Rule::root, scalar_of<Op::sqrt>, "square root"},
    {"cbrt", "s", kS, Rule::cube_root, scalar_of<Op::cbrt>, "cube root, of negative numbers too"},
    {"abs", "s", kS, Rule::same, scalar_of<Op::absolute>, "absolute value"},
    {"sign", "s", kS, Rule::any, scalar_of<Op::sign>, "-1, 0 or 1"},
    {"floor", "s", kS, Rule::same, scalar_of<Op::floor>, "largest integer not above"},
    {"ceil", "s", kS, Rule::same, scalar_of<Op::ceil>, "smallest integer not below"},
    {"round", "s", kS, Rule::same, scalar_of<Op::round>, "nearest integer; halves away from zero"},
    {"min", "ss*", kS, Rule::same, scalar_of<Op::minimum>, "smallest of two or more"},
    {"max", "ss*", kS, Rule::same, scalar_of<Op::maximum>, "largest of two or more"},
    {"clamp", "sss", kS, Rule::same, clamp, "clamp(x, low, high): x kept in low … high"},
    {"mod", "ss", kS, Rule::same, scalar_of<Op::modulo>, "remainder a - b floor(a/b): it has the sign of b"},
    {"hypot", "ss*", kS, Rule::same, scalar_of<Op::hypot>,
     "square root of the sum of the squares, without overflow"},
    {"step", "ss", kS, Rule::compared, step, "step(edge, x): 0 where x < edge, else 1"},
    {"smoothstep", "sss", kS, Rule::compared, smoothstep,
     "smoothstep(e0, e1, x): 0 before e0, 1 after e1, s^2 (3 - 2 s) between"},
    {"dot", "vv", kS, Rule::product, dot, "scalar product"},
    {"cross", "vv", kV, Rule::product, cross, "vector product"},
    {"norm", "v", kS, Rule::first, norm, "length"},
    {"normalize", "v", kV, Rule::any, normalize, "vector of length 1; NaN for the zero vector"},
    {"random", "ss", kS, Rule::any, random, "random(seed, k): even in 0 … 1, of its arguments alone"},
    {"gauss", "ss", kS, Rule::any, gauss, "gauss(seed, k): normal, mean 0, standard deviation 1"},
    {"noise", "ss", kS, Rule::any, noise,
     "noise(seed, x): smooth, in -1 … 1, with a new random value at every integer x"},
    {"table", "ts", kS, Rule::any, nullptr,
     "table(\"file.csv\", x): y of a file of x, y; straight between its points"},
    {"table", "tst", kS, Rule::any, nullptr, "table(\"file.csv\", x, cubic): smooth, without overshoot"},
    {"d", "ss", kS, Rule::quotient, nullptr, "d(f, x): derivative of f after x, a variable"},
    {"d", "vs", kV, Rule::quotient, nullptr, "derivative of a vector"},
    {"d", "sv", kV, Rule::quotient, nullptr, "d(f, v): gradient of f after the vector v"},
};

bool is_type(char letter, Type type) {
  return letter == name_of(type)[0];
}

bool takes(const Function& function, Arguments arguments) {
  std::string_view letters = function.parameters;
  const bool repeats = letters.ends_with('*');
  if (repeats) letters.remove_suffix(1);
  if (repeats ? arguments.size() < letters.size() : arguments.size() != letters.size()) return false;
  for (size_t i = 0; i < arguments.size(); ++i) {
    if (!is_type(letters[std::min(i, letters.size() - 1)], arguments[i].type)) return false;
  }
  return true;
}

}  // namespace

std::span<const Function> functions() {
  return kFunctions;
}

const Function* find_function(std::string_view name, std::span<const Operand> arguments) {
  const auto found = std::find_if(std::begin(kFunctions), std::end(kFunctions),
                                  [&](const Function& f) { return f.name == name && takes(f, arguments); });
  return found == std::end(kFunctions) ? nullptr : found;
}

bool is_function(std::string_view name) {
  return std::any_of(std::begin(kFunctions), std::end(kFunctions),
                     [&](const Function& f) { return f.name == name; });
}

std::string signature_of(const Function& function) {
  std::string text = "(";
  for (const char letter : function.parameters) {
    if (text.size() > 1) text += ", ";
    text += letter == 'b'   ? "boolean"
            : letter == 's' ? "scalar"
            : letter == 'v' ? "vector"
            : letter == 't' ? "text"
                            : "…";
  }
  return text + ")";
}

}  // namespace animado::interexpserv
