#include "visao/color.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace animado::visao {

namespace {

float decoded(double srgb) {
  return static_cast<float>(srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4));
}

// A shoulder as a film has it: highlights keep their form instead of becoming flat white.
float softened(float linear) {
  constexpr float kShoulder = 0.7f, kRest = 1 - kShoulder;
  return linear < kShoulder ? linear : kShoulder + kRest * (1 - std::exp((kShoulder - linear) / kRest));
}

// 4096 steps tell apart more than eight bits of sRGB do, save in shadows that are darker than any here.
const std::array<uint8_t, 4097>& encoding() {
  static const std::array<uint8_t, 4097> table = [] {
    std::array<uint8_t, 4097> made{};
    for (size_t k = 0; k < made.size(); ++k) {
      const double linear = static_cast<double>(k) / 4096;
      const double srgb = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
      made[k] = static_cast<uint8_t>(std::lround(255 * srgb));
    }
    return made;
  }();
  return table;
}

uint8_t encoded(float linear) {
  return encoding()[static_cast<size_t>(std::clamp(softened(linear), 0.0f, 1.0f) * 4096 + 0.5f)];
}

}  // namespace

Vec3f linear_of(const Vec3& srgb) {
  return {decoded(srgb.x()), decoded(srgb.y()), decoded(srgb.z())};
}

Srgb8 srgb8_of(const Vec3f& linear) {
  return {encoded(linear.x()), encoded(linear.y()), encoded(linear.z())};
}

Vec3f lab_of(Srgb8 color) {
  const Vec3f rgb = linear_of(Vec3(color.red, color.green, color.blue) / 255);
  Eigen::Matrix3f xyz_of_rgb;  // rows divided by the white point
  xyz_of_rgb << 0.4338f, 0.3762f, 0.1899f, 0.2126f, 0.7152f, 0.0722f, 0.0177f, 0.1095f, 0.8730f;
  const Vec3f f = (xyz_of_rgb * rgb).unaryExpr([](float v) {
    return v > 0.008856f ? std::cbrt(v) : 7.787f * v + 16.0f / 116;
  });
  return {116 * f.y() - 16, 500 * (f.x() - f.y()), 200 * (f.y() - f.z())};
}

}  // namespace animado::visao
