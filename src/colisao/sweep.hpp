// The first time at which any two bodies meet between two states.
#pragma once

#include <cstdint>
#include <span>

#include "colisao/broad_phase.hpp"

namespace animado::colisao {

struct SweepResult {
  bool hit = false;      // two bodies met
  bool near = false;     // two bodies are nearer than kNear_m at the end, or met
  bool sinking = false;  // a pair that touched from the start overlaps at the end
  double time_s = 0;     // when they met; step_s when nothing did
  int a = -1, b = -1;    // who met; the first pair of equals
  int64_t candidates = 0;
};

// So near that the contacts are worth asking for.
constexpr double kNear_m = 1e-3;

// States of shape (13, bodies), rows as in base/state.hpp, step_s apart. broad_phase: of the same bodies.
SweepResult sweep(std::span<const Collider> bodies, const BroadPhase& broad_phase, const double* from,
                  const double* to, double step_s);

}  // namespace animado::colisao
