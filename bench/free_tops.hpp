// The scene free10k: boxes on a lattice that turn freely, angular velocities from a fixed generator (no
// gravity, no contact).
#pragma once

#include <cstdint>
#include <vector>

#include "base/spatial.hpp"
#include "controle/scene/scene.hpp"

namespace animado::bench {

inline const Vec3 kHalf_m(0.5, 0.3, 0.2);
inline constexpr double kStep_s = 1.0 / 60;

struct Top {
  Vec3 position_m, angular_velocity_rad_s;
};

std::vector<Top> free_tops(size_t count);

// Of a box of density 1.
double top_mass_kg();
Vec3 top_inertia_kg_m2();

// The same as a scene, with a fixed sub-step of kStep_s.
controle::Scene free_tops_scene(size_t count);

// Mean relative error of the angular momentum of each top, given orientation and world angular velocity now.
class AngularMomentumError {
 public:
  explicit AngularMomentumError(const std::vector<Top>& start);
  void add(size_t top, const Quat& orientation, const Vec3& angular_velocity_rad_s);
  double mean() const { return sum_ / static_cast<double>(count_); }

 private:
  std::vector<Vec3> start_;
  double sum_ = 0;
  size_t count_ = 0;
};

}  // namespace animado::bench
