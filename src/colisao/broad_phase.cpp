// Bodies of like size go into the cells of a uniform grid as wide as the largest of them, each into the cell
// of its middle, so that two that meet are in the same cell or in neighbours. The cells are numbered by a
// hash and the bodies laid out by a counting sort; the hash decides only where to look: a pair is found
// whatever the hash, and the pairs are sorted at the end. Bodies much larger than the median, and
// half-spaces, are tested against all.
#include "colisao/broad_phase.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/state.hpp"

namespace animado::colisao {
namespace {

constexpr double kLarge =
    4;  // times the median width: more bodies a cell would cost more than the separate list
constexpr size_t kSample = 500;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Bounds {
  Vec3 low, high;

  bool meets(const Bounds& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
  double width() const { return (high - low).maxCoeff(); }
};

Bounds all_space() {
  return {Vec3::Constant(-kInfinity), Vec3::Constant(kInfinity)};
}

Bounds of_ball(const Vec3& centre, double radius) {
  return {centre - Vec3::Constant(radius), centre + Vec3::Constant(radius)};
}

// A body that stays needs no ball: its box is exact, however long and thin it is.
Bounds of_resting(const Solid& solid, const Pose& pose, double margin) {
  Bounds box;
  const Mat3 rotation = pose.orientation.toRotationMatrix();
  for (int k = 0; k < 3; ++k) {
    const Vec3 axis = rotation.row(k).transpose();
    box.low[k] = pose.position_m[k] + axis.dot(solid.support(-axis)) - margin;
    box.high[k] = pose.position_m[k] + axis.dot(solid.support(axis)) + margin;
  }
  return box;
}

// The four control points of the path of the origin hold it in their hull.
std::array<Vec3, 4> control_points(size_t n, const double* from, const double* to, double step_s, size_t i) {
  const auto row = [&](const double* state, StateRow first) {
    return Vec3(state[first * n + i], state[(first + 1) * n + i], state[(first + 2) * n + i]);
  };
  const Vec3 start = row(from, kPx), end = row(to, kPx);
  return {start, start + step_s / 3 * row(from, kVx), end - step_s / 3 * row(to, kVx), end};
}

Bounds swept(size_t n, const double* from, const double* to, double step_s, size_t i, double radius) {
  const auto control = control_points(n, from, to, step_s, i);
  Bounds box = of_ball(control[0], radius);
  for (size_t k = 1; k < 4; ++k) {
    const Bounds other = of_ball(control[k], radius);
    box = {box.low.cwiseMin(other.low), box.high.cwiseMax(other.high)};
  }
  return box;
}

class Grid {
 public:
  Grid(const std::vector<Bounds>& boxes, const std::vector<int>& members, double cell_m)
      : boxes_(boxes), members_(members), per_cell_(1 / cell_m) {
    mask_ = static_cast<uint32_t>(std::bit_ceil(4 * members.size())) - 1;
    first_.assign(mask_ + 2, 0);
    keys_.reserve(members.size());
    for (int i : members) {
      keys_.push_back(key(cell_of(boxes[static_cast<size_t>(i)])));
      ++first_[bucket(keys_.back()) + 1];
    }
    for (size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
    sorted_.resize(members.size());
    std::vector<int> next(first_.begin(), first_.end() - 1);
    for (size_t m = 0; m < members.size(); ++m) {
      sorted_[static_cast<size_t>(next[bucket(keys_[m])]++)] = static_cast<int>(m);
    }
  }

  // Calls meet(i, j) for each pair of members whose boxes meet, i and j in any order.
  template <class Meet>
  void each_pair(Meet meet) const {
    for (int x = -1; x <= 1; ++x) {
      for (int y = -1; y <= 1; ++y) {
        for (int z = -1; z <= 1; ++z) {
          // Half of the neighbours: the other half sees the pair from its own side.
          if (9 * x + 3 * y + z >= 0) each_pair_at({x, y, z}, meet);
        }
      }
    }
  }

 private:
  using Cell = std::array<int64_t, 3>;

  Cell cell_of(const Bounds& box) const {
    Cell cell;
    for (size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      cell[k] = static_cast<int64_t>(std::floor(0.5 * (box.low[axis] + box.high[axis]) * per_cell_));
    }
    return cell;
  }

  // Linear, so that a neighbour's key is the sum of the cell's and the offset's.
  static uint64_t key(const Cell& c) {
    return static_cast<uint64_t>(c[0]) * 0x9E3779B97F4A7C15u +
           static_cast<uint64_t>(c[1]) * 0xC2B2AE3D27D4EB4Fu +
           static_cast<uint64_t>(c[2]) * 0x165667B19E3779F9u;
  }
  uint32_t bucket(uint64_t key) const { return static_cast<uint32_t>(key >> 40) & mask_; }

  template <class Meet>
  void each_pair_at(const Cell& offset, Meet& meet) const {
    const uint64_t shift = key(offset);
    for (size_t m = 0; m < members_.size(); ++m) {
      const uint32_t b = bucket(keys_[m] + shift);
      for (int k = first_[b]; k < first_[b + 1]; ++k) {
        const auto other = static_cast<size_t>(sorted_[static_cast<size_t>(k)]);
        if (keys_[other] != keys_[m] + shift || (shift == 0 && other <= m)) continue;
        const int i = members_[m], j = members_[other];
        if (boxes_[static_cast<size_t>(i)].meets(boxes_[static_cast<size_t>(j)])) meet(i, j);
      }
    }
  }

  const std::vector<Bounds>& boxes_;
  const std::vector<int>& members_;
  double per_cell_;
  uint32_t mask_ = 0;
  std::vector<int> first_, sorted_;
  std::vector<uint64_t> keys_;
};

// Of an even sample: it only decides which list a body goes to.
double median_width(const std::vector<Bounds>& boxes) {
  std::vector<double> widths;
  const size_t stride = boxes.size() / kSample + 1;
  for (size_t i = 0; i < boxes.size(); i += stride) {
    if (std::isfinite(boxes[i].width())) widths.push_back(boxes[i].width());
  }
  if (widths.empty()) return kInfinity;
  const auto middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
  std::nth_element(widths.begin(), middle, widths.end());
  return *middle;
}

}  // namespace

std::vector<Pair> candidate_pairs(std::span<const Collider> bodies, const double* from, const double* to,
                                  double step_s, double margin_m) {
  const size_t n = bodies.size();
  std::vector<Bounds> boxes;
  boxes.reserve(n);
  for (size_t i = 0; i < n; ++i) {
    const Solid& solid = bodies[i].solid;
    if (solid.half_space()) {
      boxes.push_back(all_space());
    } else if (bodies[i].motion == Motion::fixed) {
      boxes.push_back(of_resting(solid, load_body(from, n, i).pose, 0.5 * margin_m));
    } else {
      boxes.push_back(swept(n, from, to, step_s, i, solid.radius_m() + 0.5 * margin_m));
    }
  }

  const double widest = kLarge * median_width(boxes);
  std::vector<int> small, large;
  double cell_m = 0;
  for (size_t i = 0; i < n; ++i) {
    const double width = boxes[i].width();
    const bool is_small = std::isfinite(width) && width <= widest;
    (is_small ? small : large).push_back(static_cast<int>(i));
    if (is_small) cell_m = std::max(cell_m, width);
  }

  std::vector<Pair> pairs;
  const auto meet = [&](int i, int j) {
    if (!may_meet(bodies[static_cast<size_t>(i)], bodies[static_cast<size_t>(j)])) return;
    pairs.emplace_back(std::min(i, j), std::max(i, j));
  };
  if (!small.empty()) Grid(boxes, small, cell_m).each_pair(meet);

  const auto below = [&](const HalfSpace& plane, size_t of_plane, size_t body) {
    const Pose pose = load_body(from, n, of_plane).pose;
    const Vec3 normal = pose.orientation * plane.normal;
    double lowest = kInfinity;
    for (const Vec3& point : control_points(n, from, to, step_s, body)) {
      lowest = std::min(lowest, normal.dot(point - pose.position_m));
    }
    return lowest - plane.offset_m <= bodies[body].solid.radius_m() + margin_m;
  };
  for (size_t k = 0; k < large.size(); ++k) {
    const auto i = static_cast<size_t>(large[k]);
    const HalfSpace* plane = bodies[i].solid.half_space();
    const auto test = [&](int j) {
      const auto other = static_cast<size_t>(j);
      if (plane ? below(*plane, i, other) : boxes[i].meets(boxes[other])) meet(large[k], j);
    };
    for (int j : small) test(j);
    for (size_t l = k + 1; l < large.size(); ++l) test(large[l]);
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()),
              pairs.end());  // cells whose keys are equal are searched twice
  return pairs;
}

std::vector<Pair> candidate_pairs(std::span<const Collider> bodies, const double* state, double margin_m) {
  return candidate_pairs(bodies, state, state, 0, margin_m);
}

}  // namespace animado::colisao
