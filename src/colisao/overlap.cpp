// Seen along the normal both features are convex and flat. Every corner of their common region is a corner of
// one that the other holds, or a point where their borders cross. A disc is held exactly: the eight points of
// its rim stand for its corners, its border is the circle.
#include "colisao/overlap.hpp"

#include <algorithm>
#include <cmath>

namespace animado::colisao {
namespace {

using Vec2 = Eigen::Vector2d;
using Points2 = boost::container::small_vector<Vec2, 16>;

double cross(const Vec2& u, const Vec2& v) {
  return u.x() * v.y() - u.y() * v.x();
}

// A feature as it looks along the normal, and its height over every point of the plane.
class Shadow {
 public:
  Shadow(const Feature& f, const Vec3& origin, const Vec3& u, const Vec3& v, const Vec3& normal)
      : feature_(f) {
    const auto flat = [&](const Vec3& p) { return Vec2(u.dot(p - origin), v.dot(p - origin)); };
    for (const Vec3& p : f.points_m) {
      corners_.push_back(flat(p));
      heights_.push_back(normal.dot(p - origin));
    }
    if (f.is_face()) {
      const double up = f.normal.dot(normal);
      slope_ = Vec2(-f.normal.dot(u), -f.normal.dot(v)) / up;
      if (up < 0) std::reverse(corners_.begin(), corners_.end());  // counter-clockwise in the plane
      if (up < 0) std::reverse(heights_.begin(), heights_.end());
    } else if (corners_.size() == 2) {
      const Vec2 along = corners_[1] - corners_[0];
      slope_ = (heights_[1] - heights_[0]) / along.squaredNorm() * along;
    }
    if (f.disc) centre_ = flat(f.centre_m);
  }

  const Points2& corners() const { return corners_; }
  bool is_face() const { return feature_.is_face(); }
  bool is_line() const { return corners_.size() == 2; }
  bool is_disc() const { return feature_.disc; }
  const Vec2& centre() const { return centre_; }
  double radius() const { return feature_.radius_m; }
  double height(const Vec2& p) const { return heights_[0] + slope_.dot(p - corners_[0]); }
  size_t borders() const { return is_disc() ? 1 : is_face() ? corners_.size() : corners_.size() - 1; }
  const Vec2& border_start(size_t k) const { return corners_[k]; }
  const Vec2& border_end(size_t k) const { return corners_[(k + 1) % corners_.size()]; }

  bool holds(const Vec2& p, double tolerance) const {
    if (is_disc()) return (p - centre_).norm() <= feature_.radius_m + tolerance;
    if (corners_.size() == 1) return (p - corners_[0]).norm() <= tolerance;
    for (size_t k = 0; k < borders(); ++k) {
      const Vec2 along = (border_end(k) - border_start(k)).normalized();
      const double left = cross(along, p - border_start(k));
      if (is_face() ? left < -tolerance : std::abs(left) > tolerance) return false;
      const double on = along.dot(p - border_start(k));
      if (is_line() && (on < -tolerance || on > (corners_[1] - corners_[0]).norm() + tolerance)) return false;
    }
    return true;
  }

 private:
  const Feature& feature_;
  Points2 corners_;
  boost::container::small_vector<double, 16> heights_;
  Vec2 slope_ = Vec2::Zero(), centre_ = Vec2::Zero();
};

class Collector {
 public:
  Collector(const Shadow& a, const Shadow& b, double tolerance) : a_(a), b_(b), tolerance_(tolerance) {}

  void add(const Vec2& p, size_t code) {
    for (const auto& [point, known] : found_) {
      if ((point - p).norm() <= tolerance_) return;
    }
    found_.emplace_back(p, static_cast<int>(code));
  }

  void corners() {
    const size_t of_a = a_.corners().size(), of_b = b_.corners().size();
    for (size_t i = 0; i < of_a; ++i) {
      if (b_.holds(a_.corners()[i], tolerance_)) add(a_.corners()[i], i);
    }
    for (size_t j = 0; j < of_b; ++j) {
      if (a_.holds(b_.corners()[j], tolerance_)) add(b_.corners()[j], of_a + j);
    }
  }

  void crossings(double tolerance_rad) {
    size_t code = a_.corners().size() + b_.corners().size();
    for (size_t i = 0; i < a_.borders(); ++i) {
      for (size_t j = 0; j < b_.borders(); ++j, code += 2) {
        if (a_.is_disc() && b_.is_disc()) {
          circles(code);
        } else if (a_.is_disc()) {
          circle_and_line(a_, b_.border_start(j), b_.border_end(j), code);
        } else if (b_.is_disc()) {
          circle_and_line(b_, a_.border_start(i), a_.border_end(i), code);
        } else {
          lines(i, j, tolerance_rad, code);
        }
      }
    }
  }

  Corners lifted(const Vec3& origin, const Vec3& u, const Vec3& v, const Vec3& normal) const {
    Corners corners;
    for (const auto& [p, code] : found_) {
      const double above = a_.height(p), below = b_.height(p);
      corners.push_back(
          {origin + p.x() * u + p.y() * v + 0.5 * (above + below) * normal, above - below, code});
    }
    return corners;
  }

 private:
  void lines(size_t i, size_t j, double tolerance_rad, size_t code) {
    const Vec2 &p = a_.border_start(i), &q = b_.border_start(j);
    const Vec2 along_a = a_.border_end(i) - p, along_b = b_.border_end(j) - q;
    const double turn = cross(along_a, along_b);
    if (std::abs(turn) <= tolerance_rad * along_a.norm() * along_b.norm()) return;
    const double s = cross(q - p, along_b) / turn, t = cross(q - p, along_a) / turn;
    if (s < 0 || s > 1 || t < 0 || t > 1) return;
    add(p + s * along_a, code);
  }

  void circle_and_line(const Shadow& disc, const Vec2& from, const Vec2& to, size_t code) {
    const Vec2 along = (to - from).normalized(), start = from - disc.centre();
    const double middle = -along.dot(start), length = (to - from).norm();
    const double half2 = disc.radius() * disc.radius() - std::pow(cross(along, start), 2);
    if (half2 < 0) return;
    const double half = std::sqrt(half2);
    for (const double on : {middle - half, middle + half}) {
      if (on >= 0 && on <= length) add(from + on * along, code);
      ++code;
    }
  }

  void circles(size_t code) {
    const Vec2 line = b_.centre() - a_.centre();
    const double distance = line.norm();
    if (distance <= tolerance_ || distance >= a_.radius() + b_.radius() ||
        distance <= std::abs(a_.radius() - b_.radius())) {
      return;
    }
    const double ra2 = a_.radius() * a_.radius(), rb2 = b_.radius() * b_.radius();
    const double on = (distance * distance + ra2 - rb2) / (2 * distance);
    const double across = std::sqrt(std::max(0.0, ra2 - on * on));
    const Vec2 along = line / distance, side(-along.y(), along.x());
    add(a_.centre() + on * along + across * side, code);
    add(a_.centre() + on * along - across * side, code + 1);
  }

  const Shadow &a_, &b_;
  double tolerance_;
  boost::container::small_vector<std::pair<Vec2, int>, 24> found_;
};

// Lines that run along each other at some distance sideways (the ridge of a lying cylinder over an edge that
// it is tilted against by less than the tolerance) still share a stretch.
void share_stretch(const Shadow& a, const Shadow& b, Collector& out) {
  const Vec2 start = a.corners()[0], along = (a.corners()[1] - start).normalized();
  const auto on = [&](const Vec2& p) { return along.dot(p - start); };
  const double b0 = on(b.corners()[0]), b1 = on(b.corners()[1]);
  const double from = std::max(0.0, std::min(b0, b1)), to = std::min(on(a.corners()[1]), std::max(b0, b1));
  if (from > to) return;
  out.add(start + from * along, 0);
  out.add(start + to * along, 1);
}

}  // namespace

Corners overlap(const Feature& a, const Feature& b, const Vec3& normal, double tolerance_m,
                double tolerance_rad) {
  const Vec3 origin = a.points_m[0], u = normal.unitOrthogonal(), v = normal.cross(u);
  const Shadow shadow_a(a, origin, u, v, normal), shadow_b(b, origin, u, v, normal);
  Collector collector(shadow_a, shadow_b, tolerance_m);
  if (shadow_a.is_line() && shadow_b.is_line()) {
    const Vec2 along_a = (shadow_a.corners()[1] - shadow_a.corners()[0]).normalized();
    const Vec2 along_b = (shadow_b.corners()[1] - shadow_b.corners()[0]).normalized();
    if (std::abs(cross(along_a, along_b)) <= tolerance_rad) {
      share_stretch(shadow_a, shadow_b, collector);
    } else {
      collector.crossings(tolerance_rad);
    }
    return collector.lifted(origin, u, v, normal);
  }
  collector.corners();
  if (shadow_a.borders() > 0 && shadow_b.borders() > 0) collector.crossings(1e-12);
  return collector.lifted(origin, u, v, normal);
}

}  // namespace animado::colisao
