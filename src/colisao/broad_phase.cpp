// Bodies of like size go through a grid. Bodies much larger than the median, and half-spaces, are tested
// against all.
#include "colisao/broad_phase.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/state.hpp"
#include "colisao/bounding_boxes.hpp"
#include "colisao/grid.hpp"

namespace animado::colisao {
namespace {

constexpr double kLarge =
    4;  // times the median width: more bodies a cell would cost more than the separate list
constexpr size_t kSample = 500;

// A body that stays needs no ball: its box is exact, however long and thin it is.
void put_resting(BoundingBoxes& boxes, size_t i, const Solid& solid, const Pose& pose, double margin_m) {
  const Mat3 rotation = pose.orientation.toRotationMatrix();
  for (size_t axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<Eigen::Index>(axis);
    const Vec3 along = rotation.row(k).transpose();
    boxes.low(axis)[i] = pose.position_m[k] + along.dot(solid.support(-along)) - 0.5 * margin_m;
    boxes.high(axis)[i] = pose.position_m[k] + along.dot(solid.support(along)) + 0.5 * margin_m;
  }
}

// Of an even sample: it only decides which list a body goes to.
double median_of_finite(const std::vector<double>& widths) {
  std::vector<double> sample;
  for (size_t i = 0; i < widths.size(); i += widths.size() / kSample + 1) {
    if (std::isfinite(widths[i])) sample.push_back(widths[i]);
  }
  if (sample.empty()) return std::numeric_limits<double>::infinity();
  const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
  std::nth_element(sample.begin(), middle, sample.end());
  return *middle;
}

// Whether the ball of a body comes near the half-space of a resting one.
class Below {
 public:
  Below(const HalfSpace& plane, const Pose& pose)
      : normal_(pose.orientation * plane.normal), offset_m_(plane.offset_m + normal_.dot(pose.position_m)) {}

  bool operator()(const BodyState& from, const BodyState& to, double step_s, double reach_m) const {
    const Vec3 &a = from.pose.position_m, &d = to.pose.position_m;
    const Vec3 b = a + step_s / 3 * from.velocity_m_s, c = d - step_s / 3 * to.velocity_m_s;
    return std::min({normal_.dot(a), normal_.dot(b), normal_.dot(c), normal_.dot(d)}) - offset_m_ <= reach_m;
  }

 private:
  Vec3 normal_;
  double offset_m_;
};

}  // namespace

BroadPhase::BroadPhase(std::span<const Collider> bodies) : bodies_(bodies) {
  for (size_t i = 0; i < bodies.size(); ++i) {
    radius_m_.push_back(bodies[i].solid.radius_m());
    if (bodies[i].motion == Motion::fixed && !bodies[i].solid.half_space())
      resting_.push_back(static_cast<int>(i));
  }
}

std::vector<Pair> BroadPhase::pairs_between(const double* from, const double* to, double step_s,
                                            double margin_m) const {
  const size_t n = bodies_.size();
  BoundingBoxes boxes = swept_boxes(radius_m_, from, to, step_s, margin_m);
  for (const int resting : resting_) {
    const auto i = static_cast<size_t>(resting);
    put_resting(boxes, i, bodies_[i].solid, load_body(from, n, i).pose, margin_m);
  }

  const std::vector<double> widths = boxes.widths();
  const double widest = kLarge * median_of_finite(widths);
  std::vector<int> small, large;
  double cell_m = 0;
  for (size_t i = 0; i < n; ++i) {
    const bool is_small = std::isfinite(widths[i]) && widths[i] <= widest;
    (is_small ? small : large).push_back(static_cast<int>(i));
    if (is_small) cell_m = std::max(cell_m, widths[i]);
  }

  std::vector<Pair> pairs;
  const auto meet = [&](int i, int j) {
    if (!may_meet(bodies_[static_cast<size_t>(i)], bodies_[static_cast<size_t>(j)])) return;
    pairs.emplace_back(std::min(i, j), std::max(i, j));
  };
  if (!small.empty()) Grid(boxes, small, cell_m).each_pair(meet);
  for (size_t k = 0; k < large.size(); ++k) {
    const auto i = static_cast<size_t>(large[k]);
    std::optional<Below> below;
    if (const HalfSpace* plane = bodies_[i].solid.half_space())
      below.emplace(*plane, load_body(from, n, i).pose);
    const auto test = [&](int other) {
      const auto j = static_cast<size_t>(other);
      const bool near =
          below ? (*below)(load_body(from, n, j), load_body(to, n, j), step_s, radius_m_[j] + margin_m)
                : boxes.meet(i, j);
      if (near) meet(large[k], other);
    };
    for (int j : small) test(j);
    for (size_t l = k + 1; l < large.size(); ++l) test(large[l]);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace animado::colisao
