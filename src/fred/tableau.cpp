#include "fred/tableau.hpp"

#include <algorithm>
#include <cassert>

#include "fred/state_sums.hpp"
#include "fred/tableaus/tableaus.hpp"

namespace animado::fred {
namespace {

std::vector<Tableau> all_tableaus() {
  std::vector<Tableau> all = classical_tableaus();
  for (Tableau& tableau : embedded_tableaus()) all.push_back(std::move(tableau));
  all.push_back(dop853_tableau());
  all.push_back(verner87_tableau());
  for (Tableau& tableau : all) tableau = with_sums(std::move(tableau));
  return all;
}

}  // namespace

Tableau with_sums(Tableau tableau) {
  tableau.places = {{Sum(), 0}};
  for (size_t s = 1; s < tableau.derivatives(); ++s) {
    tableau.places.push_back({sum_of(tableau.coefficients(s)), tableau.node(s)});
  }
  tableau.estimates.clear();
  for (const auto& weights : tableau.errors) tableau.estimates.push_back(sum_of(weights));
  assert(tableau.estimates.size() < 2 ||
         std::ranges::equal(tableau.estimates[0].rows, tableau.estimates[1].rows));
  return tableau;
}

const std::vector<Tableau>& tableaus() {
  static const std::vector<Tableau> kTableaus = all_tableaus();
  return kTableaus;
}

}  // namespace animado::fred
