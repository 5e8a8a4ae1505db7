#include "colisao/slices.hpp"

#include <boost/container/static_vector.hpp>
#include <cmath>

#include "colisao/gjk_loop.hpp"

namespace animado::colisao {
namespace {

constexpr int kMostTurns = 12;
constexpr double kAngleStep = 1e-5;  // of the difference quotients: Newton needs few digits of the slope

using Vec2 = Eigen::Vector2d;
using Mat2 = Eigen::Matrix2d;

// A core as the minimisation sees it: with an angle to choose if it is a cylinder or a cone, whole if it is
// not.
class Sliced {
 public:
  Sliced(const Placed& placed, const Vec3& shift) : placed_(placed), shift_(shift) {
    if (const auto* c = std::get_if<Cylinder>(&placed.solid.shape())) {
      profile_ = {{0, -c->half_height_m},
                  {c->radius_m, -c->half_height_m},
                  {c->radius_m, c->half_height_m},
                  {0, c->half_height_m}};
    } else if (const auto* k = std::get_if<Cone>(&placed.solid.shape())) {
      profile_ = {{0, -0.25 * k->height_m}, {k->radius_m, -0.25 * k->height_m}, {0, 0.75 * k->height_m}};
    }
  }

  bool turns() const { return !profile_.empty(); }

  double angle_of(const Vec3& point) const {
    const Vec3 p = placed_.rotation.transpose() * (point - shift_ - placed_.position_m);
    return std::atan2(p.z(), p.x());
  }

  // Support function of the slice at an angle.
  auto support(double angle) const {
    boost::container::static_vector<Vec3, 4> corners;
    for (const Vec2& p : profile_) {
      corners.push_back(placed_.to_world({p.x() * std::cos(angle), p.y(), p.x() * std::sin(angle)}) + shift_);
    }
    return [corners, this](const Vec3& d) {
      if (corners.empty()) return Vec3(placed_.core_support(d) + shift_);
      size_t best = 0;
      for (size_t i = 1; i < corners.size(); ++i) {
        if (d.dot(corners[i]) > d.dot(corners[best])) best = i;
      }
      return corners[best];
    };
  }

  // n · ∂x/∂θ for a point of the slice.
  double slope(const Vec3& point, const Vec3& n) const {
    if (!turns()) return 0;
    const Vec3 p = placed_.rotation.transpose() * (point - shift_ - placed_.position_m);
    return n.dot(placed_.rotation * Vec3(-p.z(), 0, p.x()));
  }

 private:
  const Placed& placed_;
  Vec3 shift_;
  boost::container::static_vector<Vec2, 4> profile_;  // distance from the axis, height
};

struct Trial {
  CoreDistance distance;
  Vec2 slope;
};

Trial at(const Sliced& a, const Sliced& b, const Vec2& angles, const Vec3& guess) {
  Trial t{gjk(a.support(angles[0]), b.support(angles[1]), guess), Vec2::Zero()};
  const Vec3 n = t.distance.separation.normalized();
  t.slope = {a.slope(t.distance.point_a_m, n), -b.slope(t.distance.point_b_m, n)};
  return t;
}

// Newton's step; an angle that is not there, or that the slope does not depend on, stays.
Vec2 step_from(const Sliced& a, const Sliced& b, const Vec2& angles, const Trial& here, const Vec3& guess) {
  Mat2 slopes = Mat2::Identity();
  for (int k = 0; k < 2; ++k) {
    if (!(k == 0 ? a : b).turns()) continue;
    slopes.col(k) = (at(a, b, angles + kAngleStep * Vec2::Unit(k), guess).slope - here.slope) / kAngleStep;
  }
  const double determinant = slopes.determinant();
  if (std::abs(determinant) > 1e-9 * slopes.squaredNorm()) return -slopes.inverse() * here.slope;
  Vec2 step = Vec2::Zero();
  for (int k = 0; k < 2; ++k) {
    if (slopes(k, k) > 1e-9) step[k] = -here.slope[k] / slopes(k, k);
  }
  return step;
}

}  // namespace

CoreDistance refine_by_slices(const Placed& a, const Placed& b, const Vec3& shift, const CoreDistance& near) {
  const Sliced sliced_a(a, shift), sliced_b(b, Vec3::Zero());
  if (!sliced_a.turns() && !sliced_b.turns()) return near;
  CoreDistance best = near;
  Vec2 angles(sliced_a.turns() ? sliced_a.angle_of(near.point_a_m) : 0,
              sliced_b.turns() ? sliced_b.angle_of(near.point_b_m) : 0);
  Trial here = at(sliced_a, sliced_b, angles, near.separation);
  for (int k = 0; k < kMostTurns && !here.distance.overlap; ++k) {
    if (here.distance.separation.norm() <= best.separation.norm()) best = here.distance;
    Vec2 step = step_from(sliced_a, sliced_b, angles, here, near.separation);
    if (step.norm() > 0.1) step *= 0.1 / step.norm();
    const Trial next = at(sliced_a, sliced_b, angles + step, near.separation);
    if (!(next.slope.norm() < here.slope.norm())) break;
    angles += step;
    here = next;
  }
  return best;
}

}  // namespace animado::colisao
