#include "colisao/contact_solver.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "colisao/anderson.hpp"
#include "colisao/frame.hpp"
#include "colisao/impulse.hpp"
#include "colisao/response_tolerances.hpp"

namespace animado::colisao {

namespace {

using Vec2 = Eigen::Vector2d;
using Mat2 = Eigen::Matrix2d;

// Visits to the sliding contraction: it starts from the last iteration's friction and need not be finished in
// one visit.
constexpr int kSlidingVisits = 8;

// A jump this many times longer than the impulses themselves comes from steps that are all alike.
constexpr double kFarthestJump = 10;

// A contact in its collision frame: component 0 along the normal, 1 and 2 tangential.
struct Block {
  Moving *a, *b;
  Vec3 arm_a, arm_b;
  Mat3 to_frame, to_world;
  Mat3 K, inverse_K;
  Mat3 spin_a, spin_b;  // change of the bodies' spins by an impulse in the frame
  double stiffest;      // largest eigenvalue of K's tangential part
  double friction, allowed;
  Vec3 impulse;

  Vec3 velocity() const {
    return to_frame *
           (a->velocity_m_s + a->spin_rad_s.cross(arm_a) - b->velocity_m_s - b->spin_rad_s.cross(arm_b));
  }
  void push(const Vec3& change) {
    const Vec3 world = to_world * change;
    a->velocity_m_s += a->inverse_mass_1_kg * world;
    b->velocity_m_s -= b->inverse_mass_1_kg * world;
    a->spin_rad_s += spin_a * change;
    b->spin_rad_s -= spin_b * change;
  }
};

Block block(std::span<Moving> bodies, const ContactConstraint& c) {
  Block k;
  k.a = &bodies[static_cast<size_t>(c.a)];
  k.b = &bodies[static_cast<size_t>(c.b)];
  k.arm_a = c.point_m - k.a->center_m;
  k.arm_b = c.point_m - k.b->center_m;
  k.to_frame = collision_frame(c.normal);
  k.to_world = k.to_frame.transpose();
  k.K = k.to_frame * inverse_mass_at(*k.a, *k.b, c.point_m) * k.to_world;
  k.inverse_K = k.K.inverse();
  k.spin_a = k.a->inverse_inertia_1_kg_m2 * cross_matrix(k.arm_a) * k.to_world;
  k.spin_b = k.b->inverse_inertia_1_kg_m2 * cross_matrix(k.arm_b) * k.to_world;
  const double mean = (k.K(1, 1) + k.K(2, 2)) / 2;
  k.stiffest = mean + std::hypot((k.K(1, 1) - k.K(2, 2)) / 2, k.K(1, 2));
  k.friction = c.friction;
  k.allowed = c.allowed_m_s;
  k.impulse = k.to_frame * c.impulse_N_s;
  return k;
}

// The impulse of a sliding contact. free: its velocity without any impulse of its own. The step P_t ←
// disk(P_t − u_t / λ), λ the largest eigenvalue of K_tt, has u_t antiparallel to P_t as its fixed point.
Vec3 sliding(const Block& k, const Vec3& free) {
  const Vec2 coupling = k.K.block<2, 1>(1, 0);
  const Mat2 K_tt = k.K.block<2, 2>(1, 1);
  const auto push_back = [&](const Vec2& friction) {
    return std::max(0.0, (k.allowed - free[0] - coupling.dot(friction)) / k.K(0, 0));
  };
  const auto onto_disk = [&](const Vec2& friction, double normal) -> Vec2 {
    const double length = friction.norm(), most = k.friction * normal;
    return length > most ? friction * (most / length) : friction;
  };
  Vec2 friction = k.impulse.tail<2>();
  double normal = push_back(friction);
  for (int visit = 0; visit < kSlidingVisits; ++visit) {
    const Vec2 u = free.tail<2>() + coupling * normal + K_tt * friction;
    friction = onto_disk(friction - u / k.stiffest, normal);
    normal = push_back(friction);
  }
  friction = onto_disk(friction, normal);
  return {normal, friction[0], friction[1]};
}

Vec3 answer(const Block& k, const Vec3& free) {
  if (free[0] >= k.allowed) return Vec3::Zero();
  if (k.friction == 0) return {(k.allowed - free[0]) / k.K(0, 0), 0, 0};
  const Vec3 sticking = k.inverse_K * (Vec3(k.allowed, 0, 0) - free);
  if (sticking.tail<2>().norm() <= k.friction * sticking[0]) return sticking;
  return sliding(k, free);
}

// Solves one contact with the others held; returns the change of its relative velocity.
double visit(Block& k) {
  const Vec3 free = k.velocity() - k.K * k.impulse;
  const Vec3 change = answer(k, free) - k.impulse;
  k.push(change);
  k.impulse += change;
  return (k.K * change).norm();
}

// Visits all contacts, forwards and then backwards; returns the largest change.
double sweep(std::vector<Block>& blocks) {
  double largest = 0;
  for (auto k = blocks.begin(); k != blocks.end(); ++k) largest = std::max(largest, visit(*k));
  for (auto k = blocks.rbegin(); k != blocks.rend(); ++k) largest = std::max(largest, visit(*k));
  return largest;
}

// The iteration with what speeds it up near jamming. A jump whose sweep is clearly worse than the best one is
// taken back.
class Iteration {
 public:
  explicit Iteration(std::vector<Block>& blocks) : blocks_(blocks), anderson_(kAndersonWindow) {}

  // One sweep; returns the largest change of a relative velocity.
  double advance(bool accelerated) {
    const Anderson::Vector before = impulses();
    const double change = sweep(blocks_);
    if (jumped_ && !(change <= 2 * best_)) {
      restore();
      anderson_.forget();
      jumped_ = false;
      return last_;
    }
    best_ = std::min(best_, change);
    last_ = change;
    jumped_ = false;
    if (accelerated) try_jump(before);
    return change;
  }

  // Ends where the last sweep that counts did: every impulse in its cone.
  void settle() {
    if (jumped_) restore();
  }

 private:
  struct Saved {
    Vec3 impulse;
    Moving a, b;
  };

  Anderson::Vector impulses() const {
    Anderson::Vector all(3 * static_cast<Eigen::Index>(blocks_.size()));
    Eigen::Index row = 0;
    for (const Block& k : blocks_) all.segment<3>(3 * row++) = k.impulse;
    return all;
  }
  void try_jump(const Anderson::Vector& before) {
    const Anderson::Vector now = impulses();
    const Anderson::Vector target = anderson_.next(before, now);
    jumped_ = (target - now).norm() <= kFarthestJump * now.norm();
    if (!jumped_) return anderson_.forget();
    save();
    jump(target);
  }
  void jump(const Anderson::Vector& target) {
    Eigen::Index row = 0;
    for (Block& k : blocks_) {
      const Vec3 change = target.segment<3>(3 * row++) - k.impulse;
      k.push(change);
      k.impulse += change;
    }
  }
  void save() {
    saved_.clear();
    for (const Block& k : blocks_) saved_.push_back({k.impulse, *k.a, *k.b});
  }
  void restore() {
    for (size_t n = 0; n < blocks_.size(); ++n) {
      blocks_[n].impulse = saved_[n].impulse;
      *blocks_[n].a = saved_[n].a;
      *blocks_[n].b = saved_[n].b;
    }
  }

  std::vector<Block>& blocks_;
  Anderson anderson_;
  std::vector<Saved> saved_;
  bool jumped_ = false;
  double best_ = std::numeric_limits<double>::infinity(), last_ = 0;
};

}  // namespace

SolverReport solve_contacts(std::span<Moving> bodies, std::span<ContactConstraint> contacts,
                            double tolerance) {
  std::vector<Block> blocks;
  blocks.reserve(contacts.size());
  double scale = 0, fastest = 0;
  for (const ContactConstraint& c : contacts) {
    const Block& k = blocks.emplace_back(block(bodies, c));
    scale = std::max({scale, k.velocity().norm(), std::abs(c.allowed_m_s)});
    fastest = std::max({fastest, k.a->velocity_at(c.point_m).norm(), k.b->velocity_at(c.point_m).norm()});
  }
  const double small = std::max(tolerance * scale, kRounding * fastest);
  for (Block& k : blocks) k.push(k.impulse);

  SolverReport report;
  const int count = static_cast<int>(blocks.size());
  const int most = count == 0 ? 0 : std::clamp(kSolverVisits / count, kFewestIterations, kMostIterations);
  report.converged = count == 0;
  Iteration iteration(blocks);
  double milestone = std::numeric_limits<double>::infinity();
  int last_progress = 0;
  while (!report.converged && report.iterations < most && report.iterations < last_progress + kPatience) {
    ++report.iterations;
    const bool slow = report.iterations >= kPlainIterations && count <= kAndersonContacts;
    report.residual_m_s = iteration.advance(slow);
    report.converged = report.residual_m_s <= small;
    if (report.residual_m_s <= milestone / 2) {
      milestone = report.residual_m_s;
      last_progress = report.iterations;
    }
  }
  iteration.settle();
  for (size_t n = 0; n < blocks.size(); ++n) contacts[n].impulse_N_s = blocks[n].to_world * blocks[n].impulse;
  return report;
}

}  // namespace animado::colisao
