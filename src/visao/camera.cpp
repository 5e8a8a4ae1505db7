// A picture is as wide as two planes through the eye. A ball (c, r) is inside the right one, which leans by
// the half angle a, when (c.x − e.x) cos a + (c.z − e.z) sin a ≤ −r, axes of the camera, z backwards; the
// same for the others. The largest c.x cos a + c.z sin a + r of all balls, and its like on the left, give two
// equations for e.x and e.z.
#include "visao/camera.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace animado::visao {

namespace {

constexpr double kMargin = 1.03;  // air around what is shown

Mat3 axes_looking_from(const Vec3& towards_eye) {
  const Vec3 back = towards_eye.normalized();
  // From straight above, north is −z, as on a map whose x points right.
  const Vec3 upright =
      std::abs(back.y()) < 0.9999 ? Vec3(0, 1, 0) : Vec3(0, 0, -std::copysign(1.0, back.y()));
  Mat3 axes;
  axes.col(0) = upright.cross(back).normalized();
  axes.col(1) = back.cross(axes.col(0));
  axes.col(2) = back;
  return axes;
}

struct Lens {
  double half_width, half_height;
};

Lens lens_of(double aspect) {
  const double longer = std::tan(kHalfAngle);
  return aspect >= 1 ? Lens{longer, longer / aspect} : Lens{longer * aspect, longer};
}

// Coordinates of the eye along one side of the picture and backwards.
struct Place {
  double along_m, back_m;
};

Place place(std::span<const Ball> balls, const Vec3& side, const Vec3& back, double half_side) {
  const double a = std::atan(half_side / kMargin), c = std::cos(a), s = std::sin(a);
  double right_m = -std::numeric_limits<double>::infinity(), left_m = right_m;
  for (const Ball& ball : balls) {
    const double along_m = side.dot(ball.center_m) * c, back_m = back.dot(ball.center_m) * s + ball.radius_m;
    right_m = std::max(right_m, along_m + back_m);
    left_m = std::max(left_m, -along_m + back_m);
  }
  return {(right_m - left_m) / (2 * c), (right_m + left_m) / (2 * s)};
}

// From as far as that, so that as much air is on one side as on the other: where the picture would be tight
// if it were narrower.
double centered_m(std::span<const Ball> balls, const Vec3& side, const Vec3& back, double half_side,
                  double back_m) {
  double narrow = 0, wide = half_side;
  constexpr int kHalvings = 16;  // to a fraction of a pixel
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = (narrow + wide) / 2;
    (place(balls, side, back, middle).back_m > back_m ? narrow : wide) = middle;
  }
  return place(balls, side, back, wide).along_m;
}

}  // namespace

Vec3 Camera::seen(const Vec3& point_m) const {
  const Vec3 p = axes.transpose() * (point_m - eye_m);
  return {p.x() / (-p.z() * half_width), p.y() / (-p.z() * half_height), -p.z()};
}

Camera camera_at(const Vec3& eye_m, const Vec3& target_m, double aspect) {
  const Lens lens = lens_of(aspect);
  return {eye_m, axes_looking_from(eye_m - target_m), lens.half_width, lens.half_height};
}

Camera fitted_camera(std::span<const Ball> balls, const Vec3& towards_eye, double aspect) {
  assert(!balls.empty());
  const Lens lens = lens_of(aspect);
  const Mat3 axes = axes_looking_from(towards_eye);
  const Place across = place(balls, axes.col(0), axes.col(2), lens.half_width);
  const Place upwards = place(balls, axes.col(1), axes.col(2), lens.half_height);
  Vec3 eye(across.along_m, upwards.along_m, std::max(across.back_m, upwards.back_m));
  if (across.back_m < upwards.back_m) {
    eye.x() = centered_m(balls, axes.col(0), axes.col(2), lens.half_width, eye.z());
  } else {
    eye.y() = centered_m(balls, axes.col(1), axes.col(2), lens.half_height, eye.z());
  }
  return {axes * eye, axes, lens.half_width, lens.half_height};
}

double apparent_aspect(std::span<const Ball> balls, const Vec3& towards_eye) {
  const Mat3 axes = axes_looking_from(towards_eye);
  Eigen::AlignedBox2d page;
  for (const Ball& ball : balls) {
    const Eigen::Vector2d at = (axes.transpose() * ball.center_m).head<2>();
    const Eigen::Vector2d reach = Eigen::Vector2d::Constant(ball.radius_m);
    page.extend(at - reach).extend(at + reach);
  }
  return page.sizes().x() / page.sizes().y();
}

}  // namespace animado::visao
