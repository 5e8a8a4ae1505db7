// The unknowns are the vertices of a graph, an edge for each that another's right-hand side reads. The
// problem is separable when two colours are enough.
#include "fred/separable.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "fred/equations.hpp"

namespace animado::fred {
namespace {

enum class Colour { none, position, momentum };

[[noreturn]] void refuse(const Equations& equations, size_t a, size_t b) {
  const auto& names = equations.unknowns();
  throw Error(
      Code::refused,
      a == b
          ? fmt::format("{}' depends on {} itself: the system is not separable", names[a], names[a])
          : fmt::format("{} and {} depend on each other in a way that is not separable", names[a], names[b]),
      equations.place(a),
      "symplectic methods need positions that move by momenta alone, and momenta by positions alone, as x' = "
      "v, "
      "v' = -x; use another method");
}

}  // namespace

std::vector<bool> positions_of(const Equations& equations) {
  const size_t n = equations.size();
  std::vector<std::vector<size_t>> linked(n);
  for (size_t i = 0; i < n; ++i) {
    for (size_t j : equations.read_by(i)) {
      linked[i].push_back(j);
      linked[j].push_back(i);
    }
  }
  std::vector<Colour> colours(n, Colour::none);
  for (size_t first = 0; first < n; ++first) {
    if (colours[first] != Colour::none) continue;
    colours[first] = Colour::position;
    std::vector<size_t> open = {first};
    while (!open.empty()) {
      const size_t i = open.back();
      open.pop_back();
      for (size_t j : linked[i]) {
        if (colours[j] == colours[i]) refuse(equations, i, j);
        if (colours[j] != Colour::none) continue;
        colours[j] = colours[i] == Colour::position ? Colour::momentum : Colour::position;
        open.push_back(j);
      }
    }
  }
  std::vector<bool> positions;
  for (const Colour colour : colours) positions.push_back(colour == Colour::position);
  return positions;
}

}  // namespace animado::fred
