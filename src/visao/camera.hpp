// Where the eye is. Seen in perspective, with a long lens: what is far stays nearly as large as what is near.
#pragma once

#include <span>

#include "base/spatial.hpp"

namespace animado::visao {

// A ball that is to be seen; a body at a moment is in one.
struct Ball {
  Vec3 center_m;
  double radius_m;
};

struct Camera {
  Vec3 eye_m;
  Mat3 axes;                       // columns: right, up, back (towards the eye), world, unit
  double half_width, half_height;  // of the picture, at distance 1: tangents of half the angles of view

  Vec3 direction(double across, double upwards) const {  // each −1 … 1 from edge to edge; not unit
    return axes * Vec3(across * half_width, upwards * half_height, -1);
  }
  // Where a point appears, x across and y upwards, −1 … 1; z: its distance along the view, negative behind.
  Vec3 seen(const Vec3& point_m) const;
};

inline constexpr double kHalfAngle = 0.14;  // of the picture's longer side, 8°: a long lens

Camera camera_at(const Vec3& eye_m, const Vec3& target_m, double aspect);  // aspect: width/height

// From the direction `towards_eye`, so near that all balls are just in the picture.
Camera fitted_camera(std::span<const Ball> balls, const Vec3& towards_eye, double aspect);

// How much wider than high the balls appear from there.
double apparent_aspect(std::span<const Ball> balls, const Vec3& towards_eye);

}  // namespace animado::visao
