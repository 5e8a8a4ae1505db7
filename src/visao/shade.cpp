#include "visao/shade.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace animado::visao {

namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

// Which way a body has turned shows on its eighths, alternately lighter and darker; less on what has edges.
float pattern(const Solids::Surface& surface, const StagedBody& body) {
  const float dark = body.sphere_radius_m > 0 ? 0.72f : 0.88f;
  return surface.inside_m.prod() > 0 ? 1.0f : dark;
}

// Thin lines on a floor, on the two axes of the world that it is most nearly along.
float grid(const StagedPlane& plane, const Vec3& point_world_m, float room_m) {
  if (plane.grid_m == 0) return 1;
  constexpr double kWidth = 0.006;  // of the room
  int steepest = 0;
  plane.normal.cwiseAbs().maxCoeff(&steepest);
  for (const int axis : {0, 1, 2}) {
    if (axis == steepest) continue;
    const double lines = point_world_m[axis] / plane.grid_m;
    if (std::abs(lines - std::round(lines)) * plane.grid_m < kWidth / 2 * room_m) return 0.82f;
  }
  return 1;
}

// Rays from points on surfaces towards where light may come from.
RTCRay16 shadow_rays() {
  RTCRay16 rays;
  std::fill_n(rays.tfar, kRays, kFar);
  std::fill_n(rays.mask, kRays, ~0u);
  std::fill_n(rays.flags, kRays, 0u);
  std::fill_n(rays.time, kRays, 0.0f);
  std::fill_n(rays.tnear, kRays, 0.0f);
  return rays;
}

void aim(RTCRay16& rays, int ray, const Vec3f& from_m, const Vec3f& direction) {
  rays.org_x[ray] = from_m.x(), rays.org_y[ray] = from_m.y(), rays.org_z[ray] = from_m.z();
  rays.dir_x[ray] = direction.x(), rays.dir_y[ray] = direction.y(), rays.dir_z[ray] = direction.z();
}

bool is_blocked(const RTCRay16& rays, int ray) {
  return rays.tfar[ray] < 0;
}

}  // namespace

struct Shader::Hits {
  std::array<Seen, kRays> seen;
  std::array<Vec3f, kRays> points_m;
  alignas(64) std::array<int, kRays> valid;  // something was met
};

Shader::Shader(const Stage& stage, const Solids& solids, const Camera& camera)
    : stage_(stage),
      solids_(solids),
      light_(camera),
      eye_m_((camera.eye_m - stage.origin_m).cast<float>()),
      room_m_(static_cast<float>(stage.radius_m)) {
  for (const StagedPlane& plane : stage.planes) {
    if (plane.normal.dot(eye_m_) > plane.offset_m) planes_.push_back(plane);
  }
}

std::array<Seen, kRays> Shader::see(const Bundle& directions, const SampleIndices& samples) const {
  Hits hits;
  find_surfaces(directions, hits);
  if (std::ranges::any_of(hits.valid, [](int v) { return v != 0; })) {
    add_lamp(directions, samples, hits);
    add_sky(samples, hits);
  }
  return hits.seen;
}

void Shader::find_surfaces(const Bundle& directions, Hits& hits) const {
  alignas(64) RTCRayHit16 rays;
  alignas(64) constexpr std::array<int, kRays> kAll = {-1, -1, -1, -1, -1, -1, -1, -1,
                                                       -1, -1, -1, -1, -1, -1, -1, -1};
  rays.ray = shadow_rays();
  for (int k = 0; k < kRays; ++k) {
    aim(rays.ray, k, eye_m_, directions[static_cast<size_t>(k)]);
    rays.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
    rays.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
  }
  solids_.meet(kAll.data(), rays);
  for (int k = 0; k < kRays; ++k) {
    const auto i = static_cast<size_t>(k);
    hits.seen[i].added = kBackground;
    const bool body = rays.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID;
    if (body) meet_body(directions, rays, k, hits);
    meet_planes(directions, k, body ? rays.ray.tfar[k] : kFar, hits);
    hits.valid[i] = hits.seen[i].surface == Seen::kNothing ? 0 : -1;
  }
}

void Shader::meet_body(const Bundle& directions, const RTCRayHit16& rays, int ray, Hits& hits) const {
  const auto i = static_cast<size_t>(ray);
  hits.points_m[i] = eye_m_ + rays.ray.tfar[ray] * directions[i];
  const Solids::Surface surface = solids_.surface(rays.hit, ray, hits.points_m[i]);
  Seen& seen = hits.seen[i];
  seen.surface = static_cast<int>(surface.body);
  seen.normal = surface.normal;
  const StagedBody& body = stage_.bodies[surface.body];
  seen.albedo = body.color * pattern(surface, body);
  seen.added.setZero();
}

void Shader::meet_planes(const Bundle& directions, int ray, float nearest_m, Hits& hits) const {
  const auto i = static_cast<size_t>(ray);
  for (size_t p = 0; p < planes_.size(); ++p) {
    const StagedPlane& plane = planes_[p];
    const float towards = plane.normal.dot(directions[i]);
    if (towards >= 0) continue;
    const float distance_m = (plane.offset_m - plane.normal.dot(eye_m_)) / towards;
    if (distance_m >= nearest_m) continue;
    nearest_m = distance_m;
    const Vec3f point_m = eye_m_ + distance_m * directions[i];
    // A floor fades into the background where nothing happens any more.
    const float away = std::clamp((point_m.norm() / room_m_ - 1.3f) / 2.5f, 0.0f, 1.0f);
    const float there = 1 - away * away * (3 - 2 * away);
    Seen& seen = hits.seen[i];
    hits.points_m[i] = point_m;
    seen.surface = static_cast<int>(stage_.bodies.size() + p);
    seen.normal = plane.normal;
    seen.albedo = there * grid(plane, point_m.cast<double>() + stage_.origin_m, room_m_) * plane.color;
    seen.added = (1 - there) * kBackground;
  }
}

bool Shader::meets_plane(const Vec3f& from_m, const Vec3f& direction) const {
  return std::ranges::any_of(planes_, [&](const StagedPlane& plane) {
    return plane.normal.dot(direction) < 0 && plane.normal.dot(from_m) > plane.offset_m;
  });
}

// Planes throw no shadow of the lamp: a wall that stands between would make night of the whole picture.
void Shader::add_lamp(const Bundle& directions, const SampleIndices& samples, Hits& hits) const {
  alignas(64) RTCRay16 rays = shadow_rays();
  alignas(64) std::array<int, kRays> valid;
  std::array<Vec3f, kRays> lamp;
  const float off_surface_m = 1e-4f * room_m_;
  for (int k = 0; k < kRays; ++k) {
    const auto i = static_cast<size_t>(k);
    lamp[i] = light_.towards_lamp(samples[i]);
    valid[i] = hits.valid[i] != 0 && hits.seen[i].normal.dot(lamp[i]) > 0 ? -1 : 0;
    if (valid[i] != 0) aim(rays, k, hits.points_m[i] + off_surface_m * hits.seen[i].normal, lamp[i]);
  }
  solids_.block(valid.data(), rays);
  for (int k = 0; k < kRays; ++k) {
    const auto i = static_cast<size_t>(k);
    if (valid[i] == 0 || is_blocked(rays, k)) continue;
    Seen& seen = hits.seen[i];
    seen.light += seen.normal.dot(lamp[i]) * kLampLight;
    const bool is_body = seen.surface < static_cast<int>(stage_.bodies.size());
    if (is_body) seen.added += gloss(seen.normal, lamp[i], -directions[i]) * kLampLight;
  }
}

void Shader::add_sky(const SampleIndices& samples, Hits& hits) const {
  alignas(64) RTCRay16 rays = shadow_rays();
  std::array<Vec3f, kRays> sky;
  const float off_surface_m = 1e-4f * room_m_;
  for (int k = 0; k < kRays; ++k) {
    const auto i = static_cast<size_t>(k);
    if (hits.valid[i] == 0) continue;
    sky[i] = light_.towards_sky(hits.seen[i].normal, samples[i]);
    aim(rays, k, hits.points_m[i] + off_surface_m * hits.seen[i].normal, sky[i]);
  }
  solids_.block(hits.valid.data(), rays);
  for (int k = 0; k < kRays; ++k) {
    const auto i = static_cast<size_t>(k);
    if (hits.valid[i] == 0) continue;
    const float part = is_blocked(rays, k) ? kReflected : 1;
    const bool from_plane = part == 1 && meets_plane(hits.points_m[i], sky[i]);
    hits.seen[i].light += from_plane ? Vec3f::Constant(0.42f) : (part * sky_light(sky[i])).eval();
  }
}

}  // namespace animado::visao
