// animation.glb: the motion as glTF 2.0, a node a body, for Blender, browsers and game engines.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "base/shape.hpp"
#include "base/spatial.hpp"
#include "controle/results/physics_extensions.hpp"

namespace animado::controle {

struct AnimatedBody {
  std::string name = {};
  Shape shape = Sphere{1};
  Motion motion = Motion::dynamic;        // a fixed body has a place and no channels
  Vec3 color_srgb = Vec3::Constant(0.7);  // each in 0 … 1, as CSS means them
};

class AnimationGlb {
 public:
  // plane_extent_m: half the side of the square that stands for a half-space.
  explicit AnimationGlb(std::vector<AnimatedBody> bodies, double plane_extent_m = 50);

  // state: shape (13, bodies), rows as in base/state.hpp. The first frame's time becomes 0, as viewers
  // expect. Frames nearer than single precision tells apart are left out.
  void frame(double time_s, std::span<const double> state);
  // With physics, one a body, the drafts of physics_extensions.hpp too; their `start` is the first frame's.
  void with_physics(std::vector<BodyPhysics> physics, std::string restitution_combine);
  void write(const std::filesystem::path& file) const;

 private:
  std::vector<AnimatedBody> bodies_;
  double plane_extent_m_;
  std::vector<BodyPhysics> physics_;  // empty: without
  std::string restitution_combine_;
  double first_time_s_ = 0;
  std::vector<float> times_s_;
  std::vector<std::vector<float>> translations_m_, rotations_;  // a body: x, y, z and x, y, z, w a frame
};

}  // namespace animado::controle
