#include "fred/tableau.hpp"

#include "fred/tableaus/tableaus.hpp"

namespace animado::fred {
namespace {

std::vector<Tableau> all_tableaus() {
  std::vector<Tableau> all = classical_tableaus();
  for (Tableau& tableau : embedded_tableaus()) all.push_back(std::move(tableau));
  all.push_back(dop853_tableau());
  all.push_back(verner87_tableau());
  return all;
}

}  // namespace

const std::vector<Tableau>& tableaus() {
  static const std::vector<Tableau> kTableaus = all_tableaus();
  return kTableaus;
}

}  // namespace animado::fred
