// Colours: light is added up in linear RGB, screens are fed sRGB (IEC 61966-2-1).
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "base/spatial.hpp"

namespace animado::visao {

using Vec3f = Eigen::Vector3f;

struct Srgb8 {
  uint8_t red, green, blue;
  bool operator==(const Srgb8&) const = default;
};

Vec3f linear_of(const Vec3& srgb);    // each in 0 … 1
Srgb8 srgb8_of(const Vec3f& linear);  // brighter than white becomes white, gradually
Vec3f lab_of(Srgb8 color);            // CIE L*a*b*, white point D65: equal distances look equally different

}  // namespace animado::visao
