// Tests of colisao/system15.hpp: the paper's fifteen equations give what the closed form gives.
#include "colisao/system15.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

#include "response_fixtures.hpp"

namespace animado::colisao {
namespace {

using namespace testing;

std::vector<double> solved(const std::vector<double>& matrix, const std::vector<double>& right_side) {
  using Matrix15 = Eigen::Matrix<double, 15, 15, Eigen::RowMajor>;
  using Vector15 = Eigen::Matrix<double, 15, 1>;
  const Vector15 x = Eigen::Map<const Matrix15>(matrix.data())
                         .partialPivLu()
                         .solve(Eigen::Map<const Vector15>(right_side.data()));
  return {x.data(), x.data() + 15};
}

TEST(System15, AgreesWithTheClosedFormForRandomImpacts) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> r(-1, 1);
  const auto vector = [&] { return Vec3(r(random), r(random), r(random)); };
  int seen[3] = {};
  for (int n = 0; n < 2000; ++n) {
    Moving a = block(1.5 + r(random), {0.1 + std::abs(r(random)), 1, 0.3}, vector(), vector(), 3 * vector());
    Moving b = n % 3 == 0 ? immovable(vector())
                          : block(1.5 + r(random), {1, 0.1, 0.3}, vector(), vector(), 3 * vector());
    if (n % 2 == 0) std::swap(a, b);
    Contact c = contact(0, 1, vector(), vector().normalized());
    if (relative_velocity(a, b, c.point_m).dot(c.normal) > 0) c.normal = -c.normal;
    const double rebound =
        rebound_m_s(relative_velocity(a, b, c.point_m).dot(c.normal), std::abs(r(random)), 0.01);
    const double mu = n % 5 == 0 ? 0 : 1.5 * std::abs(r(random));
    const PointImpulse closed = point_impulse(a, b, c, mu, rebound);
    ++seen[static_cast<int>(closed.friction)];
    const Vec3 P = point_impulse_by_system15(a, b, c, mu, rebound, solved).impulse_N_s;
    ASSERT_LT((P - closed.impulse_N_s).norm(), 1e-9 * closed.impulse_N_s.norm()) << n;

    const System15 system = system15(a, b, c, mu, rebound);
    const std::vector<double> x = solved(system.matrix, system.right_side);
    a.push(closed.impulse_N_s, c.point_m);
    b.push(-closed.impulse_N_s, c.point_m);
    const Vec3 expected[] = {a.velocity_m_s, b.velocity_m_s, a.spin_rad_s, b.spin_rad_s};
    for (int k = 0; k < 4; ++k) {
      const Vec3 given(x[3 * k], x[3 * k + 1], x[3 * k + 2]);
      ASSERT_LT((given - expected[k]).norm(), 1e-9 * (1 + expected[k].norm())) << n << " unknown " << k;
    }
  }
  for (int count : seen) EXPECT_GT(count, 50);
}

TEST(System15, ImmovableRowsSayThatNothingChanges) {
  const System15 system = system15(ball(2, 0.5, {0, 0.5, 0}, {0, -1, 0}), immovable({0, 0.25, 0}),
                                   contact(0, 1, {0, 0, 0}, Vec3::UnitY()), 0, 0);
  for (int row = 3; row < 6; ++row) {
    for (int column = 0; column < 15; ++column)
      EXPECT_EQ(system.matrix[15 * row + column], row == column ? 1 : 0);
  }
  EXPECT_EQ(system.right_side[4], 0.25);
}

TEST(System15, PaperInelasticRows) {  // equation (4): P·i = 0, P·j = 0, u'·k = 0
  const System15 system = system15(ball(2, 0.5, {0, 0.5, 0}, {0, -1, 0}), immovable(),
                                   contact(0, 1, {0, 0, 0}, Vec3::UnitY()), 0, 0);
  for (int row = 12; row < 14; ++row) {
    for (int column = 0; column < 12; ++column) EXPECT_EQ(system.matrix[15 * row + column], 0);
    EXPECT_EQ(system.matrix[15 * row + 13], 0);  // no normal component
    EXPECT_EQ(system.right_side[row], 0);
  }
  EXPECT_EQ(system.matrix[15 * 14 + 1], 1);
  EXPECT_EQ(system.matrix[15 * 14 + 4], -1);
  EXPECT_EQ(system.right_side[14], 0);
}

}  // namespace
}  // namespace animado::colisao
