#include "colisao/system15.hpp"

#include <cassert>

#include "colisao/frame.hpp"

namespace animado::colisao {

namespace {

constexpr int kSize = 15, kV1 = 0, kV2 = 3, kSpin1 = 6, kSpin2 = 9, kP = 12;
using Matrix15 = Eigen::Matrix<double, kSize, kSize, Eigen::RowMajor>;
using Vector15 = Eigen::Matrix<double, kSize, 1>;

// Rows of (3) for one body, `sign` +1 for object 1 and −1 for object 2.
void body_rows(const Moving& body, const Vec3& point_m, double sign, int velocity, int spin, Matrix15& A,
               Vector15& b) {
  A.block<3, 3>(velocity, velocity).setIdentity();
  A.block<3, 3>(velocity, kP) = -sign * body.inverse_mass_1_kg * Mat3::Identity();
  b.segment<3>(velocity) = body.velocity_m_s;
  A.block<3, 3>(spin, spin).setIdentity();
  A.block<3, 3>(spin, kP) = -sign * body.inverse_inertia_1_kg_m2 * cross_matrix(point_m - body.center_m);
  b.segment<3>(spin) = body.spin_rad_s;
}

// Row u'·direction = value.
void velocity_row(int row, const Vec3& direction, double value, const Vec3& arm_a, const Vec3& arm_b,
                  Matrix15& A, Vector15& b) {
  A.block<1, 3>(row, kV1) = direction.transpose();
  A.block<1, 3>(row, kV2) = -direction.transpose();
  A.block<1, 3>(row, kSpin1) = arm_a.cross(direction).transpose();
  A.block<1, 3>(row, kSpin2) = -arm_b.cross(direction).transpose();
  b[row] = value;
}

}  // namespace

System15 system15(const Moving& a, const Moving& b, const Contact& contact, double friction,
                  double rebound_m_s) {
  const Vec3& k = contact.normal;
  const Mat3 frame = collision_frame(k);
  const PointImpulse verdict = point_impulse(a, b, contact, friction, rebound_m_s);
  const Vec3 arm_a = contact.point_m - a.center_m, arm_b = contact.point_m - b.center_m;
  const Vec3 u = relative_velocity(a, b, contact.point_m);
  const Vec3 slip = u - u.dot(k) * k;

  Matrix15 A = Matrix15::Zero();
  Vector15 right = Vector15::Zero();
  body_rows(a, contact.point_m, +1, kV1, kSpin1, A, right);
  body_rows(b, contact.point_m, -1, kV2, kSpin2, A, right);
  for (int n = 0; n < 2; ++n) {
    const int row = kP + n;
    const Vec3 tangent = frame.row(1 + n);
    if (verdict.friction == Friction::sticks) {
      velocity_row(row, tangent, 0, arm_a, arm_b, A, right);
    } else if (verdict.friction == Friction::slides) {
      A.block<1, 3>(row, kP) = (tangent + friction * slip.normalized().dot(tangent) * k).transpose();
    } else {
      A.block<1, 3>(row, kP) = tangent.transpose();
      right[row] = verdict.impulse_N_s.dot(tangent);
    }
  }
  velocity_row(kP + 2, k, rebound_m_s, arm_a, arm_b, A, right);
  return {{A.data(), A.data() + A.size()}, {right.data(), right.data() + right.size()}};
}

PointImpulse point_impulse_by_system15(const Moving& a, const Moving& b, const Contact& contact,
                                       double friction, double rebound_m_s, const Solve15& solve) {
  const System15 system = system15(a, b, contact, friction, rebound_m_s);
  const std::vector<double> x = solve(system.matrix, system.right_side);
  assert(x.size() == kSize);
  return {{x[kP], x[kP + 1], x[kP + 2]}, point_impulse(a, b, contact, friction, rebound_m_s).friction};
}

}  // namespace animado::colisao
