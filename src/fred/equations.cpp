#include "fred/equations.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "base/error.hpp"
#include "base/fold.hpp"
#include "base/nearest_name.hpp"
#include "interexpserv/functions.hpp"

namespace animado::fred {
namespace {

using interexpserv::MapScope;
using interexpserv::Symbol;
using interexpserv::Type;
using interexpserv::Value;

constexpr std::string_view kReserved[] = {"t", "pi", "e", "true", "false", "and", "or", "not"};

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

bool is_identifier(std::string_view folded) {
  const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; };
  const auto digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  return !folded.empty() && letter(folded[0]) &&
         std::ranges::all_of(folded, [&](char c) { return letter(c) || digit(c); });
}

std::string checked_name(std::string_view name, const std::string& where) {
  const std::string folded = fold(name);
  if (!is_identifier(folded)) {
    throw Error(Code::syntax, fmt::format("'{}' is not a name", name), where,
                name.ends_with('\'') ? "write an equation of second order as two: x' = v; v' = …"
                                     : "a name is letters, digits and _, a letter first");
  }
  if (std::ranges::find(kReserved, folded) != std::end(kReserved)) {
    throw Error(Code::conflict, fmt::format("'{}' has a meaning of its own", name), where,
                "choose another name");
  }
  return folded;
}

struct Statement {
  std::string_view name;
  bool is_equation;
  std::string_view text;  // what the name stands for; of a function "(x) = …"
};

Statement split(std::string_view text, const std::string& where) {
  const size_t equals = text.find('=');
  const std::string_view left = trimmed(text.substr(0, equals));
  if (equals == text.npos || left.empty()) {
    throw Error(Code::syntax, fmt::format("'{}' is neither an equation nor a definition", text), where,
                "write x' = v for an unknown, k = 2 or f(x) = x^2 for what equations use");
  }
  const std::string_view right = text.substr(equals + 1);
  if (left.back() == '\'') return {trimmed(left.substr(0, left.size() - 1)), true, right};
  const size_t open = text.find('(');
  if (open > equals) return {left, false, right};
  const std::string_view function = trimmed(text.substr(0, open));
  if (interexpserv::is_function(fold(function))) {
    throw Error(Code::conflict, fmt::format("'{}' is a function of the language", function), where,
                "choose another name");
  }
  return {function, false, text.substr(open)};
}

[[noreturn]] void refuse_twice(const std::string& name, const std::string& where) {
  throw Error(Code::conflict, fmt::format("'{}' is given twice", name), where, "give each name once");
}

// "a = b" as a difference; comparisons have other signs around theirs.
std::string as_difference(std::string_view text) {
  const size_t equals = text.find('=');
  const auto is_sign = [&](size_t at) {
    return at < text.size() && std::string_view("=<>!").find(text[at]) != std::string_view::npos;
  };
  if (equals == text.npos || is_sign(equals + 1) || (equals > 0 && is_sign(equals - 1)))
    return std::string(text);
  return fmt::format("({}) - ({})", text.substr(0, equals), text.substr(equals + 1));
}

}  // namespace

// What the equations know, and behind it what is looked up: once a name, so that it keeps one value.
class Equations::Names : public MapScope {
 public:
  explicit Names(Lookup lookup) : lookup_(std::move(lookup)) {}

  std::optional<Symbol> find(std::string_view name) const override {
    if (auto known = MapScope::find(name); known || !lookup_) return known;
    const auto [at, is_new] = found_.try_emplace(std::string(name));
    if (is_new) at->second = lookup_(name);
    if (!at->second) return {};
    return *at->second;
  }

 private:
  Lookup lookup_;
  mutable std::map<std::string, std::optional<Value>, std::less<>> found_;
};

Equations::Equations(std::span<const std::string> texts, const NamedValues& constants, Lookup lookup)
    : names_(std::make_unique<Names>(std::move(lookup))) {
  names_->input("t", Type::scalar);
  const auto refuse_known = [&](const std::string& folded, const std::string& where) {
    if (names_->MapScope::find(folded)) refuse_twice(folded, where);
  };
  std::vector<std::string_view> right_sides;
  std::vector<std::pair<std::string_view, std::string>> definitions;
  for (size_t i = 0; i < texts.size(); ++i) {
    const std::string where = fmt::format("equations[{}]", i);
    const Statement statement = split(texts[i], where);
    const std::string folded = checked_name(statement.name, where);
    refuse_known(folded, where);
    if (statement.is_equation) {
      names_->input(folded, Type::scalar);
      unknowns_.emplace_back(statement.name);
      folded_.push_back(folded);
      places_.push_back(where);
      right_sides.push_back(statement.text);
    } else {
      names_->define(folded, std::string(trimmed(statement.text)));
      definitions.emplace_back(statement.text, where);
    }
  }
  if (unknowns_.empty() && !texts.empty()) {
    throw Error(Code::syntax, "there are definitions, but no equation", "equations[0]",
                "write an equation for each unknown, as x' = v");
  }
  for (size_t i = 0; i < constants.size(); ++i) {
    const std::string where = fmt::format("constants[{}]", i);
    const std::string folded = checked_name(constants[i].first, where);
    refuse_known(folded, where);
    names_->set(folded, Value::scalar(constants[i].second));
  }
  for (const auto& [text, where] : definitions) interexpserv::compile(text, *names_, where);  // used or not
  inputs_.resize(1 + size());
  rates_.resize(1 + size());
  for (size_t i = 0; i < size(); ++i) {
    right_sides_.push_back(compiled(right_sides[i], places_[i],
                                    "an unknown is one number: write an equation for each component"));
  }
}

Equations::~Equations() = default;

Equations::Expression Equations::compiled(std::string_view text, const std::string& where,
                                          const char* remedy) const {
  Expression expression{interexpserv::compile(text, *names_, where), {}};
  if (expression.program.type() != Type::scalar) {
    throw Error(Code::type,
                fmt::format("'{}' is a {}, not a number", trimmed(text), name_of(expression.program.type())),
                where, remedy);
  }
  for (const auto& [name, type] : expression.program.inputs()) {
    const auto unknown = std::ranges::find(folded_, name) - folded_.begin();
    expression.sources.push_back(name == "t" ? 0 : 1 + static_cast<size_t>(unknown));
  }
  return expression;
}

std::vector<double> Equations::arranged(const NamedValues& from) const {
  std::vector<std::optional<double>> given(size());
  for (size_t i = 0; i < from.size(); ++i) {
    const std::string where = fmt::format("from[{}]", i), folded = fold(from[i].first);
    const auto found = std::ranges::find(folded_, folded);
    if (found == folded_.end()) {
      const std::string nearest = nearest_name(folded, folded_);
      throw Error(Code::unknown_name, fmt::format("no equation is given for '{}'", from[i].first), where,
                  nearest.empty() ? fmt::format("the unknowns are {}", fmt::join(unknowns_, ", "))
                                  : fmt::format("did you mean '{}'?", nearest));
    }
    auto& value = given[static_cast<size_t>(found - folded_.begin())];
    if (value) refuse_twice(folded, where);
    value = from[i].second;
  }
  std::vector<double> y;
  for (size_t i = 0; i < size(); ++i) {
    if (!given[i]) {
      throw Error(Code::bad_params, fmt::format("'{}' has no value at t0", unknowns_[i]), "from",
                  fmt::format("add {{name: \"{}\", value: …}} to from", unknowns_[i]));
    }
    y.push_back(*given[i]);
  }
  return y;
}

void Equations::load(const Expression& expression, double t, std::span<const double> y) const {
  double* next = inputs_.data();
  for (const size_t source : expression.sources) *next++ = source == 0 ? t : y[source - 1];
}

void Equations::evaluate(double t, std::span<const double> y, std::span<double> rate) const {
  for (size_t i = 0; i < right_sides_.size(); ++i) {
    load(right_sides_[i], t, y);
    right_sides_[i].program.evaluate(inputs_.data(), &rate[i]);
  }
}

void Equations::differentiate(double t, std::span<const double> y, std::span<double> jacobian) const {
  std::ranges::fill(jacobian, 0.0);
  for (size_t i = 0; i < size(); ++i) {
    const auto& [program, sources] = right_sides_[i];
    load(right_sides_[i], t, y);
    std::ranges::fill(rates_, 0.0);
    for (size_t k = 0; k < sources.size(); ++k) {
      if (sources[k] == 0) continue;
      double value = 0;
      rates_[k] = 1;
      program.evaluate_with_rate(inputs_.data(), rates_.data(), &value,
                                 &jacobian[i * size() + sources[k] - 1]);
      rates_[k] = 0;
    }
  }
}

std::vector<size_t> Equations::read_by(size_t i) const {
  std::vector<size_t> read;
  for (const size_t source : right_sides_[i].sources) {
    if (source > 0) read.push_back(source - 1);
  }
  return read;
}

std::function<double(double, std::span<const double>)> Equations::expression(std::string_view text,
                                                                             const std::string& where) const {
  return [this, expression = compiled(as_difference(text), where,
                                      "give a number that crosses zero, as x - 1, or write x = 1")](
             double t, std::span<const double> y) {
    load(expression, t, y);
    double value = 0;
    expression.program.evaluate(inputs_.data(), &value);
    return value;
  };
}

}  // namespace animado::fred
