// Where the numbers of the methods stand: classical.cpp those without an error estimate, embedded.cpp the
// pairs of low order, dop853.cpp and verner87.cpp the pairs of eighth order.
#pragma once

#include "fred/tableau.hpp"

namespace animado::fred {

std::vector<Tableau> classical_tableaus();
std::vector<Tableau> embedded_tableaus();
Tableau dop853_tableau();
Tableau verner87_tableau();

}  // namespace animado::fred
