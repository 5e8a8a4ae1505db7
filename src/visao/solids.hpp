// The bodies at one moment, for rays: Embree finds what sixteen rays meet at once. Spheres are exact, all
// else is triangles with the normals of the true surface.
#pragma once

#include <embree3/rtcore.h>

#include <memory>
#include <span>
#include <vector>

#include "visao/stage.hpp"

namespace animado::visao {

inline constexpr int kRays = 16;  // in a bundle: what AVX-512 takes at once

class Solids {
 public:
  Solids(const Stage& stage, std::span<const Pose> poses);  // poses: of all bodies of the run

  void meet(const int* valid, RTCRayHit16& rays) const;  // valid: −1 the ray counts, 0 it does not
  void block(const int* valid, RTCRay16& rays) const;    // tfar of those that meet something becomes −∞

  struct Surface {
    size_t body;     // in stage.bodies
    Vec3f normal;    // unit, smooth
    Vec3f inside_m;  // the point in the body's frame
  };
  Surface surface(const RTCHit16& hits, int ray, const Vec3f& point_m) const;

 private:
  void place(const StagedBody& body, const Pose& pose, uint32_t index);
  void add_triangles();
  void add_spheres();

  template <auto release>
  struct Release {
    void operator()(auto* object) const { release(object); }
  };
  std::unique_ptr<RTCDeviceTy, Release<rtcReleaseDevice>> device_;
  std::unique_ptr<RTCSceneTy, Release<rtcReleaseScene>> scene_;

  std::vector<Vec3f> corners_m_, normals_;
  std::vector<uint32_t> triangles_, body_of_triangle_;
  std::vector<Eigen::Vector4f> spheres_m_;  // centre, radius
  std::vector<uint32_t> body_of_sphere_;
  std::vector<Eigen::Isometry3f> to_body_;
};

}  // namespace animado::visao
