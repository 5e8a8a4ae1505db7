#include "visao/light.hpp"

#include <cmath>
#include <numbers>

namespace animado::visao {

namespace {

constexpr float kLampRadius = 0.16f;  // tangent of half its apparent size: as soft as a window

// The unit disc, areas kept: rings of equal angle (Shirley & Chiu 1997 without its corners).
Eigen::Vector2f on_disc(const SquarePoint& sample) {
  const float radius = std::sqrt(sample.x), angle = 2 * std::numbers::pi_v<float> * sample.y;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

// Any two axes that make a right-handed frame with a unit normal (Duff et al., Building an Orthonormal Basis,
// Revisited, 2017).
std::pair<Vec3f, Vec3f> axes_about(const Vec3f& n) {
  const float sign = std::copysign(1.0f, n.z()), a = -1 / (sign + n.z()), b = n.x() * n.y() * a;
  return {{1 + sign * n.x() * n.x() * a, sign * b, -sign * n.x()}, {b, sign + n.y() * n.y() * a, -n.y()}};
}

// Over the viewer's left shoulder, high as seen from the ground wherever the camera is.
Vec3 middle_of_lamp(const Camera& camera) {
  Vec3 level_back = camera.axes.col(2);
  level_back.y() = 0;
  if (level_back.norm() < 1e-3) level_back = -camera.axes.col(1);
  level_back.normalize();
  const Vec3 right = Vec3(0, 1, 0).cross(level_back);
  return (1.3 * Vec3(0, 1, 0) - 0.75 * right + 0.5 * level_back).normalized();
}

}  // namespace

Light::Light(const Camera& camera) {
  const Vec3f lamp = middle_of_lamp(camera).cast<float>();
  const auto [across, along] = axes_about(lamp);
  for (uint32_t k = 0; k < kPoints; ++k) {
    const SquarePoint point = sequence_point(k);
    const Eigen::Vector2f disc = on_disc(point), on_lamp = kLampRadius * disc;
    lamp_[k] = (lamp + on_lamp.x() * across + on_lamp.y() * along).normalized();
    sky_[k] = {disc.x(), disc.y(), std::sqrt(1 - point.x)};
  }
}

Vec3f Light::towards_sky(const Vec3f& normal, uint32_t sample) const {
  const auto [across, along] = axes_about(normal);
  const Vec3f& over = sky_[sample];
  return over.x() * across + over.y() * along + over.z() * normal;
}

Vec3f sky_light(const Vec3f& direction) {
  const float height = 0.5f + 0.5f * direction.y();
  return Vec3f(0.30f, 0.29f, 0.28f) + height * Vec3f(0.26f, 0.29f, 0.33f);
}

float gloss(const Vec3f& normal, const Vec3f& towards_lamp, const Vec3f& towards_eye) {
  constexpr float kStrength = 0.22f, kSharpness = 40;
  const float cosine = normal.dot((towards_lamp + towards_eye).normalized());
  return cosine > 0 ? kStrength * std::pow(cosine, kSharpness) : 0;
}

}  // namespace animado::visao
