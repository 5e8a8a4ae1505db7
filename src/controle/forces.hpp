// What pushes the bodies: gravity, damping, the expressions of the scene. Contact is not here.
#pragma once

#include <vector>

#include "controle/equations_of_motion.hpp"
#include "controle/pushes.hpp"

namespace animado::controle {

// The rate at which a drive's expressions do work, and that at which its damping takes energy away.
struct Power {
  double work_W = 0, damping_W = 0;
};

// Their integrals over a time.
struct Work {
  double done_J = 0, damped_J = 0;
};

class Forces {
 public:
  Forces(const Scene& scene, std::vector<Inertia> inertias, std::vector<Drive> drives);

  const Scene& scene() const { return scene_; }
  size_t driven() const { return drives_.size(); }
  size_t body_of(size_t drive) const { return drives_[drive].body; }

  void replace(std::vector<Drive> drives);  // after a live edit

  // Wrenches (6, N): force through the centre of mass and torque about it, world axes. powers: one a drive.
  // Throws Error diverged when an expression is not finite.
  void evaluate(const Moment& moment, double* wrenches, Power* powers) const;

  // Work of one drive along a given small motion, under its forces at the start.
  Work work(size_t drive, const Moment& start, const Vec3& center_displacement_m,
            const Vec3& rotation_rad) const;

 private:
  struct Load {
    Vec3 force, torque;  // world
  };
  Load damping(const Drive& drive, const BodyState& body) const;
  Power damp(const Drive& drive, const Moment& moment, double* wrenches) const;
  void work_rates(const Moment& moment) const;
  void check_finite(const Moment& moment, const double* wrenches) const;
  [[noreturn]] void refuse(const Body& body, double time_s) const;
  Vec3 center_velocity(size_t body, const BodyState& state) const;

  const Scene& scene_;
  std::vector<Inertia> inertias_;
  std::vector<double> falling_kg_;  // mass that gravity pulls: none of a body that is not dynamic
  std::vector<Drive> drives_;
  std::vector<double> centers_m_;  // of mass, (3, N), body frame
  mutable Pushes expressions_;
  mutable std::vector<double> pushes_, work_rates_W_;  // theirs: wrenches (6, N), powers (N)
};

}  // namespace animado::controle
