#include "egesp/server.checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/finite.hpp"
#include "base/number_text.hpp"
#include "egesp/accuracy.hpp"
#include "egesp/batch_shape.hpp"

namespace animado::egesp {
namespace {

[[noreturn]] void refuse_system(const Refusal& refusal, size_t refused, size_t count, size_t n,
                                const PivotRule& rule) {
  const std::string where = fmt::format("matrices[{}]", refusal.system);
  const std::string others = refused > 1 ? fmt::format("; {} more are refused", refused - 1) : "";
  if (refusal.pivot == n) {
    throw Error(Code::not_finite,
                fmt::format("the solution of system {} of {} overflows{}", refusal.system, count, others),
                where, "scale its equations");
  }
  throw Error(Code::singular,
              fmt::format("system {} of {} is singular: pivot {} of size {} is not larger than {:.3g} times "
                          "its largest element{}",
                          refusal.system, count, refusal.pivot, n, rule.tolerance(n), others),
              where,
              "look for equations that depend on each other; a smaller threshold accepts smaller pivots");
}

}  // namespace

PivotRule checked_rule(Pivoting pivoting, double threshold) {
  return {pivoting == Pivoting::complete, checked_threshold(threshold)};
}

std::vector<RefusedSystem> reported(const std::vector<Refusal>& refusals, OnSingular on_singular,
                                    size_t count, size_t n, const PivotRule& rule) {
  if (!refusals.empty() && on_singular == OnSingular::error)
    refuse_system(refusals.front(), refusals.size(), count, n, rule);
  std::vector<RefusedSystem> systems;
  for (const Refusal& refusal : refusals)
    systems.push_back({static_cast<int64_t>(refusal.system), static_cast<int64_t>(refusal.pivot)});
  return systems;
}

double checked_threshold(double threshold) {
  if (threshold >= 0 && threshold < 1) return threshold;
  throw Error(Code::bad_params, fmt::format("the threshold is {}", threshold), "threshold",
              "T is a fraction of the largest element: at least 0, less than 1");
}

void refuse_infinite(std::span<const double> numbers, const char* where) {
  if (all_finite(numbers)) return;
  const auto found = std::ranges::find_if_not(numbers, [](double v) { return std::isfinite(v); });
  if (found == numbers.end()) return;  // who shares the memory wrote meanwhile
  throw Error(Code::not_finite, fmt::format("element {} is {}", found - numbers.begin(), number_text(*found)),
              fmt::format("{}[{}]", where, found - numbers.begin()), "send finite numbers only");
}

size_t right_sides_of(std::span<const int64_t> shape, int64_t n) {
  const bool fits = (shape.size() == 1 || shape.size() == 2) && shape[0] == n && shape.back() >= 1;
  if (!fits) {
    throw Error(Code::bad_shape,
                fmt::format("shape ({}) is not ({}) or ({}, m)", fmt::join(shape, ", "), n, n), "right_sides",
                "send a row of right_sides for each row of the matrix");
  }
  if (shape.size() == 2 && shape[1] > kLargestSize) {
    throw Error(Code::limit, fmt::format("{} right-hand sides are more than {}", shape[1], kLargestSize),
                "right_sides", "send fewer at a time");
  }
  return shape.size() == 2 ? static_cast<size_t>(shape[1]) : 1;
}

void refuse_overflow(std::span<const double> solutions) {
  if (all_finite(solutions)) return;
  throw Error(Code::not_finite, "the solution overflows", "right_sides", "scale the equations");
}

Accuracy accuracy_of(std::vector<double> backward_errors, std::vector<double> reciprocal_conditions) {
  Accuracy accuracy{std::move(backward_errors), std::move(reciprocal_conditions), {}};
  const auto& conditions = accuracy.reciprocal_conditions;
  const auto worst = std::ranges::min_element(conditions);
  if (worst != conditions.end() && *worst < kIllConditioned) {
    const auto ill = std::ranges::count_if(conditions, [](double v) { return v < kIllConditioned; });
    accuracy.warning = fmt::format(
        "system {} of {} is ill-conditioned: 1/κ is about {:.2g}, so that no digit of x may be right{}",
        worst - conditions.begin(), conditions.size(), *worst,
        ill > 1 ? fmt::format("; {} more are ill-conditioned", ill - 1) : "");
  }
  return accuracy;
}

}  // namespace animado::egesp
