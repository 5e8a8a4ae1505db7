#include "fred/tableau.hpp"

#include <algorithm>
#include <cassert>

#include "fred/state_sums.hpp"
#include "fred/tableaus/tableaus.hpp"

namespace animado::fred {
namespace {

std::vector<double> copy(const double* numbers, size_t count) {
  return {numbers, numbers + count};
}

// The first numbers of the first rows, `longer` more in each row than in the one before.
template <size_t n, size_t columns>
std::vector<std::vector<double>> copy(const double (&rows)[n][columns], size_t count, size_t length,
                                      size_t longer = 0) {
  std::vector<std::vector<double>> copies;
  for (size_t i = 0; i < count; ++i) copies.push_back(copy(rows[i], length + i * longer));
  return copies;
}

template <class C>
Tableau tableau_of(const C& method, size_t number) {
  constexpr size_t kStages = C::kStages;
  return {method.name,
          method.reference,
          number,
          method.order,
          copy(method.nodes, kStages),
          copy(method.weights, kStages),
          copy(method.matrix[0], kStages * kStages),
          method.error_order,
          copy(method.errors, C::kEstimates, kStages + 1),
          method.dense_order,
          copy(method.extra_nodes, C::kExtra),
          copy(method.extra_matrix, C::kExtra, kStages + 1, 1),
          copy(method.dense, C::kDense, C::kDerivatives),
          {},
          {}};
}

void add_sums(Tableau& tableau) {
  tableau.places = {{Sum(), 0}};
  for (size_t s = 1; s < tableau.derivatives(); ++s) {
    Sum sum = sum_of(tableau.coefficients(s));
    sum.takes_step = s != tableau.stages() && are_small(sum.coefficients, sum.count);
    tableau.places.push_back({sum, tableau.node(s)});
  }
  for (const auto& weights : tableau.errors) tableau.estimates.push_back(sum_of(weights));
  assert(tableau.estimates.size() < 2 ||
         std::ranges::equal(tableau.estimates[0].rows, tableau.estimates[1].rows));
}

template <const auto&... kMethods>
std::vector<Tableau> tableaus_of(ListOf<kMethods...>) {
  std::vector<Tableau> all;
  (all.push_back(tableau_of(kMethods, all.size())), ...);
  for (Tableau& tableau : all) add_sums(tableau);
  return all;
}

}  // namespace

const std::vector<Tableau>& tableaus() {
  static const std::vector<Tableau> kTableaus = tableaus_of(EveryMethod());
  return kTableaus;
}

}  // namespace animado::fred
