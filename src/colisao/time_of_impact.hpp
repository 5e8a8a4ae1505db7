// The first time at which two moving solids meet.
#pragma once

#include "colisao/path.hpp"
#include "colisao/solid.hpp"

namespace animado::colisao {

// Nearer than this at the start, a pair is touching already: it meets again only after it has parted.
constexpr double kTouching_m = 1e-7;
// A pair that touched has parted once its gap is larger than this: above what rounding and a contact solver
// leave behind.
constexpr double kParted_m = 1e-6;
// A pair that sinks deeper than this without having parted is for the contact solver to mend.
constexpr double kSinking_m = 1e-6;

struct Impact {
  bool hit = false;
  bool sinking = false;  // touched from the start and overlaps at the end
  double time_s = 0;     // of the hit; the gap there lies between 0 and about 1e-12 m
  double end_gap_m = 0;  // a lower bound of the gap at `until`; meaningless after a hit
};

// Searches (0, until]. No impact is missed between pairs that were apart, however fast: each advance is
// proven by bounds on the motion.
Impact time_of_impact(const Solid& a, const Path& path_a, const Solid& b, const Path& path_b, double until_s);

}  // namespace animado::colisao
