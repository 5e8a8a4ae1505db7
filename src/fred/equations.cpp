#include "fred/equations.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "base/error.hpp"
#include "base/fold.hpp"
#include "base/nearest_name.hpp"

namespace animado::fred {
namespace {

using interexpserv::MapScope;
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
                "a name is letters, digits and _, a letter first");
  }
  if (std::ranges::find(kReserved, folded) != std::end(kReserved)) {
    throw Error(Code::conflict, fmt::format("'{}' has a meaning of its own", name), where,
                "choose another name");
  }
  return folded;
}

struct Halves {
  std::string_view unknown, expression;
};

Halves split(std::string_view text, const std::string& where) {
  const size_t equals = text.find('=');
  const std::string_view left = trimmed(text.substr(0, equals));
  if (equals == text.npos || left.empty() || left.back() != '\'') {
    throw Error(Code::syntax, fmt::format("'{}' is not an equation", text), where, "write it as x' = v");
  }
  return {trimmed(left.substr(0, left.size() - 1)), text.substr(equals + 1)};
}

[[noreturn]] void refuse_twice(const std::string& name, const std::string& where) {
  throw Error(Code::conflict, fmt::format("'{}' is given twice", name), where, "give each name once");
}

interexpserv::Program compile_number(std::string_view expression, const MapScope& scope,
                                     const std::string& where) {
  interexpserv::Program program = interexpserv::compile(expression, scope, where);
  if (program.type() != Type::scalar) {
    throw Error(Code::type,
                fmt::format("'{}' is a {}, not a number", trimmed(expression), name_of(program.type())),
                where, "an unknown is one number: write an equation for each component");
  }
  return program;
}

}  // namespace

Equations::Equations(std::span<const std::string> texts, const NamedValues& constants) {
  MapScope scope;
  scope.input("t", Type::scalar);
  std::vector<std::string_view> expressions;
  for (size_t i = 0; i < texts.size(); ++i) {
    const std::string where = fmt::format("equations[{}]", i);
    const auto [unknown, expression] = split(texts[i], where);
    const std::string folded = checked_name(unknown, where);
    if (scope.find(folded)) refuse_twice(folded, where);
    scope.input(folded, Type::scalar);
    unknowns_.emplace_back(unknown);
    folded_.push_back(folded);
    expressions.push_back(expression);
  }
  for (size_t i = 0; i < constants.size(); ++i) {
    const std::string where = fmt::format("constants[{}]", i);
    const std::string folded = checked_name(constants[i].first, where);
    if (scope.find(folded)) refuse_twice(folded, where);
    scope.set(folded, Value::scalar(constants[i].second));
  }
  arguments_.resize(1 + size());
  for (size_t i = 0; i < size(); ++i) {
    right_sides_.push_back({compile_number(expressions[i], scope, fmt::format("equations[{}]", i)), {}});
    auto& [program, sources] = right_sides_.back();
    for (const auto& input : program.inputs()) sources.push_back(source_of(input.name));
    inputs_.resize(std::max(inputs_.size(), sources.size()));
  }
}

size_t Equations::source_of(const std::string& input) const {
  return input == "t" ? 0 : 1 + static_cast<size_t>(std::ranges::find(folded_, input) - folded_.begin());
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

void Equations::evaluate(double t, std::span<const double> y, std::span<double> rate) const {
  arguments_[0] = t;
  std::ranges::copy(y, arguments_.begin() + 1);
  for (size_t i = 0; i < right_sides_.size(); ++i) {
    const auto& [program, sources] = right_sides_[i];
    for (size_t k = 0; k < sources.size(); ++k) inputs_[k] = arguments_[sources[k]];
    program.evaluate(inputs_.data(), &rate[i]);
  }
}

}  // namespace animado::fred
