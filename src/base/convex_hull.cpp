// The incremental algorithm: starting from a tetrahedron, each point outside replaces the faces that see it
// by a fan from it to their horizon. Points far from the middle come first, so that corners are in before
// what lies between them. A face that holds the point counts as seeing it: no sliver is ever made. At the end
// the triangles of one plane become one polygon.
#include "base/convex_hull.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "base/error.hpp"

namespace animado {
namespace {

struct Triangle {
  std::array<int, 3> corners;
  Vec3 normal;
  double offset;
  bool alive = true;
};

class Builder {
 public:
  explicit Builder(std::span<const Vec3> points) : points_(points) {
    for (const Vec3& p : points) {
      if (!p.allFinite())
        throw Error(Code::not_finite, "a vertex is not finite", "hull", "give finite coordinates");
      middle_ += p / static_cast<double>(points.size());
    }
    for (const Vec3& p : points) extent_ = std::max(extent_, (p - middle_).norm());
    tolerance_ = 1e-10 * extent_;
  }

  Hull hull() {
    start();
    std::vector<int> order(points_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int i, int j) {
      return (point(i) - middle_).squaredNorm() > (point(j) - middle_).squaredNorm();
    });
    for (int i : order) add(i);
    return polygons();
  }

 private:
  const Vec3& point(int i) const { return points_[static_cast<size_t>(i)]; }
  double height(const Triangle& t, int i) const { return t.normal.dot(point(i)) - t.offset; }

  template <class Measure>
  int farthest(Measure measure) const {
    int best = 0;
    for (int i = 1; i < static_cast<int>(points_.size()); ++i) {
      if (measure(point(i)) > measure(point(best))) best = i;
    }
    return best;
  }

  void start() {
    const auto flat = [] {
      return Error(Code::refused, "the vertices of a hull lie in one plane", "hull",
                   "give at least four vertices that enclose a volume");
    };
    if (points_.size() < 4) throw flat();
    const int a = farthest([&](const Vec3& p) { return (p - middle_).squaredNorm(); });
    const int b = farthest([&](const Vec3& p) { return (p - point(a)).squaredNorm(); });
    const Vec3 line = (point(b) - point(a)).normalized();
    const int c = farthest([&](const Vec3& p) { return line.cross(p - point(a)).squaredNorm(); });
    if (!(line.cross(point(c) - point(a)).norm() > tolerance_)) throw flat();
    const Vec3 across = line.cross(point(c) - point(a)).normalized();
    const int d = farthest([&](const Vec3& p) { return std::abs(across.dot(p - point(a))); });
    const double height_of_d = across.dot(point(d) - point(a));
    if (!(std::abs(height_of_d) > tolerance_)) throw flat();
    const std::array<int, 3> base = height_of_d < 0 ? std::array{a, b, c} : std::array{a, c, b};
    put(base);
    for (size_t k = 0; k < 3; ++k) put({base[(k + 1) % 3], base[k], d});
  }

  void put(const std::array<int, 3>& corners) {
    const Vec3 &p = point(corners[0]), &q = point(corners[1]), &r = point(corners[2]);
    const Vec3 normal = (q - p).cross(r - p).normalized();
    for (size_t k = 0; k < 3; ++k) {
      across_[{corners[k], corners[(k + 1) % 3]}] = static_cast<int>(triangles_.size());
    }
    triangles_.push_back({corners, normal, normal.dot((p + q + r) / 3)});
  }

  void add(int i) {
    std::vector<int> seen;
    double highest = tolerance_;
    for (size_t f = 0; f < triangles_.size(); ++f) {
      const double h = triangles_[f].alive ? height(triangles_[f], i) : 0;
      if (h > highest) {
        highest = h;
        seen.assign(1, static_cast<int>(f));
      }
    }
    if (seen.empty()) return;
    triangles_[static_cast<size_t>(seen[0])].alive = false;
    std::vector<std::pair<int, int>> horizon;
    for (size_t k = 0; k < seen.size(); ++k) {
      const std::array<int, 3> corners = triangles_[static_cast<size_t>(seen[k])].corners;
      for (size_t e = 0; e < 3; ++e) {
        const int from = corners[e], to = corners[(e + 1) % 3];
        const int beyond = across_.at({to, from});
        Triangle& other = triangles_[static_cast<size_t>(beyond)];
        if (other.alive && height(other, i) > -tolerance_) {
          other.alive = false;
          seen.push_back(beyond);
        } else if (other.alive) {
          horizon.emplace_back(from, to);
        }
      }
    }
    // A face reached later may have swallowed what was horizon before.
    std::erase_if(horizon, [&](const auto& edge) {
      return !triangles_[static_cast<size_t>(across_.at({edge.second, edge.first}))].alive;
    });
    for (const auto& [from, to] : horizon) put({from, to, i});
  }

  Hull polygons() const {
    std::vector<bool> done(triangles_.size(), false), corner(points_.size(), false);
    std::vector<int> used;
    for (const Triangle& t : triangles_) {
      if (t.alive) used.insert(used.end(), t.corners.begin(), t.corners.end());
    }
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());

    Hull hull;
    for (size_t f = 0; f < triangles_.size(); ++f) {
      const Triangle& t = triangles_[f];
      if (!t.alive || done[f]) continue;
      const auto in_plane = [&](int i) { return std::abs(height(t, i)) <= 10 * tolerance_; };
      for (size_t g = f; g < triangles_.size(); ++g) {
        done[g] =
            done[g] || std::all_of(triangles_[g].corners.begin(), triangles_[g].corners.end(), in_plane);
      }
      std::vector<int> members;
      std::copy_if(used.begin(), used.end(), std::back_inserter(members), in_plane);
      hull.faces.push_back(loop(members, t.normal));
      for (int i : hull.faces.back()) corner[static_cast<size_t>(i)] = true;
    }
    std::vector<int> renamed(points_.size(), -1);
    for (size_t i = 0; i < points_.size(); ++i) {
      if (!corner[i]) continue;
      renamed[i] = static_cast<int>(hull.vertices_m.size());
      hull.vertices_m.push_back(points_[i]);
    }
    for (auto& face : hull.faces) {
      for (int& i : face) i = renamed[static_cast<size_t>(i)];
    }
    return hull;
  }

  // Points of a plane as the corners of their convex hull, counter-clockwise about the normal (Andrew's
  // monotone chain).
  std::vector<int> loop(std::vector<int> members, const Vec3& normal) const {
    const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u);
    std::sort(members.begin(), members.end(), [&](int i, int j) {
      const double ui = u.dot(point(i)), uj = u.dot(point(j));
      return ui != uj ? ui < uj : v.dot(point(i)) < v.dot(point(j));
    });
    const auto left_turn = [&](int i, int j, int k) {
      const Vec3 along = point(k) - point(i);
      return normal.dot((point(j) - point(i)).cross(along)) > tolerance_ * along.norm();
    };
    std::vector<int> chain;
    const auto extend = [&](auto first, auto last) {
      const size_t base = chain.size();
      for (; first != last; ++first) {
        while (chain.size() >= base + 2 && !left_turn(chain[chain.size() - 2], chain.back(), *first))
          chain.pop_back();
        chain.push_back(*first);
      }
      chain.pop_back();
    };
    extend(members.begin(), members.end());
    extend(members.rbegin(), members.rend());
    return chain;
  }

  std::span<const Vec3> points_;
  Vec3 middle_ = Vec3::Zero();
  double extent_ = 0, tolerance_ = 0;
  std::vector<Triangle> triangles_;
  std::map<std::pair<int, int>, int> across_;  // directed edge → the living triangle that runs along it
};

}  // namespace

Hull convex_hull(std::span<const Vec3> points_m) {
  return Builder(points_m).hull();
}

}  // namespace animado
