// What sixteen rays from the eye see. Light that falls on a surface and the surface's colour are kept apart:
// light is smooth and may be averaged over neighbouring pixels (smooth_light), patterns and edges may not.
#pragma once

#include <array>

#include "visao/light.hpp"
#include "visao/solids.hpp"

namespace animado::visao {

struct Seen {
  int surface = kNothing;  // a body, or a plane after all bodies
  Vec3f normal = Vec3f::Zero();
  Vec3f albedo = Vec3f::Zero();  // part of the light that comes back
  Vec3f light = Vec3f::Zero();   // that falls on it
  Vec3f added = Vec3f::Zero();   // background, gloss

  static constexpr int kNothing = -1;
  Vec3f color() const { return added + albedo.cwiseProduct(light); }
};

using Bundle = std::array<Vec3f, kRays>;  // directions, unit
using SampleIndices = std::array<uint32_t, kRays>;

class Shader {
 public:
  Shader(const Stage& stage, const Solids& solids, const Camera& camera);

  // samples: which points of the sequence each ray takes for the lamp and for the sky.
  std::array<Seen, kRays> see(const Bundle& directions, const SampleIndices& samples) const;

 private:
  struct Hits;
  void find_surfaces(const Bundle& directions, Hits& hits) const;
  void meet_body(const Bundle& directions, const RTCRayHit16& rays, int ray, Hits& hits) const;
  void meet_planes(const Bundle& directions, int ray, float nearest_m, Hits& hits) const;
  void add_lamp(const Bundle& directions, const SampleIndices& samples, Hits& hits) const;
  void add_sky(const SampleIndices& samples, Hits& hits) const;
  bool meets_plane(const Vec3f& from_m, const Vec3f& direction) const;

  const Stage& stage_;
  const Solids& solids_;
  Light light_;
  Vec3f eye_m_;
  std::vector<StagedPlane> planes_;  // those that the eye is in front of
  float room_m_;
};

}  // namespace animado::visao
