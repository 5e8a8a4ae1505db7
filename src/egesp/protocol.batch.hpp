// What the messages about batches of systems share.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace animado::egesp {

using namespace std::string_view_literals;

enum class Pivoting { partial, complete };
constexpr auto names(const Pivoting*) {
  return std::array{"partial"sv, "complete"sv};
}

// How a batch lies in memory. systems: one system after the other, shape (count, n, n). lanes: element by
// element, shape (n, n, count), so that neighbouring numbers belong to neighbouring systems and one
// instruction serves several.
enum class Layout { systems, lanes };
constexpr auto names(const Layout*) {
  return std::array{"systems"sv, "lanes"sv};
}

// What a system without a solution does to its batch. error: the request is refused, by code singular or
// not_finite. report: the reply lists it and its solution is NaN; the others are solved.
enum class OnSingular { error, report };
constexpr auto names(const OnSingular*) {
  return std::array{"error"sv, "report"sv};
}

struct RefusedSystem {
  int64_t system = 0, pivot = 0;
  template <class Self, class F>
  static void fields(Self& s, F&& field) {
    field("system", s.system, "its index in the batch");
    field("pivot", s.pivot,
          "the index of the pivot that was refused; n when all were accepted and the solution is not finite");
  }
};

}  // namespace animado::egesp
