// Continuous contact through a step: finds the islands of bodies that touch and moves each of them
// (island_motion.hpp); every other body keeps the free result, to the last bit. So does a body of an island
// on which no contact acted.
//
// Ordinarily an island is made of pairs that touch at the start and do not part faster than the contact
// threshold; other pairs are left to the search for impacts. In a crowded scene it is made of all pairs that
// may meet within the step, impacts included.
#pragma once

#include <functional>

#include "colisao/island_motion.hpp"

namespace animado::colisao {

struct ContactFinder {
  using Pairs = std::vector<std::pair<int, int>>;  // first < second, sorted
  // Pairs that may be nearer than the margin in one state, and somewhere on the way between two.
  std::function<Pairs(const double* state, double margin_m)> pairs_at;
  std::function<Pairs(const double* from, const double* to, double step_s, double margin_m)> pairs_between;
  Manifold manifold;
};

struct AdvanceInput {
  const double* state = nullptr;          // shape (13, bodies), at the start
  const double* accelerations = nullptr;  // shape (6, bodies): of the origin (world), angular (body axes)
  const double* free = nullptr;           // shape (13, bodies): at the end, as if nothing touched
  double step_s = 0;                      // > 0
  int substeps = 1;                       // ≥ 1
  bool crowded = false;
};

struct AdvanceResult {
  std::vector<double> state;  // shape (13, bodies), at the end
  std::vector<int> moved;     // bodies on which contacts acted, ascending
  ContactAccount account;     // of all islands
  int islands = 0;
};

AdvanceResult advance(const Bodies& bodies, const ContactFinder& finder, const AdvanceInput& input);

}  // namespace animado::colisao
