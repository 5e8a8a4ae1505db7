// Tests of colisao/contact_solver.hpp: what several contacts with friction do to velocities.
#include "colisao/contact_solver.hpp"

#include <gtest/gtest.h>

#include "colisao/impulse.hpp"
#include "response_fixtures.hpp"

namespace animado::colisao {
namespace {

using namespace testing;

// A cube of edge 1 and mass 3 on the floor y = 0 (body 1), its four lower corners in contact.
std::vector<ContactConstraint> corners(double friction) {
  std::vector<ContactConstraint> all;
  for (double x : {-0.5, 0.5}) {
    for (double z : {-0.5, 0.5}) all.push_back({0, 1, {x, 0, z}, Vec3::UnitY(), friction, 0, Vec3::Zero()});
  }
  return all;
}

Moving cube(const Vec3& velocity_m_s, const Vec3& spin_rad_s = Vec3::Zero()) {
  return block(3, {0.5, 0.5, 0.5}, {0, 0.5, 0}, velocity_m_s, spin_rad_s);
}

// Gravity of one step on an incline, in the incline's axes: down the slope along x.
Vec3 on_incline(double tangent, double speed) {
  return Vec3(tangent, -1, 0).normalized() * speed;
}

TEST(ContactSolver, CubeSticksOnASlopeGentlerThanFriction) {
  std::vector<Moving> bodies = {cube(on_incline(0.49, 0.01)), immovable()};
  auto contacts = corners(0.5);
  const SolverReport report = solve_contacts(bodies, contacts, 1e-12);
  EXPECT_TRUE(report.converged) << report.iterations << " " << report.residual_m_s;
  EXPECT_LT(bodies[0].velocity_m_s.norm(), 1e-12);
  EXPECT_LT(bodies[0].spin_rad_s.norm(), 1e-12);
}

TEST(ContactSolver, CubeSlidesOnASteeperSlope) {  // g (sin θ − μ cos θ)
  std::vector<Moving> bodies = {cube(on_incline(0.8, 0.01)), immovable()};
  auto contacts = corners(0.5);
  const SolverReport report = solve_contacts(bodies, contacts, 1e-12);
  EXPECT_TRUE(report.converged) << report.iterations << " " << report.residual_m_s;
  const double cosine = 1 / std::sqrt(1.64);
  EXPECT_NEAR(bodies[0].velocity_m_s.x(), 0.01 * (0.8 - 0.5) * cosine, 1e-12);
  EXPECT_NEAR(bodies[0].velocity_m_s.y(), 0, 1e-12);
  EXPECT_LT(bodies[0].spin_rad_s.norm(), 1e-11);
}

TEST(ContactSolver, SlidingIsStoppedAgainstItsDirection) {
  std::vector<Moving> bodies = {cube({0.3, -0.01, 0.4}), immovable()};
  auto contacts = corners(0.5);
  EXPECT_TRUE(solve_contacts(bodies, contacts, 1e-12).converged);
  EXPECT_NEAR(bodies[0].velocity_m_s.x(), 0.3 * 0.99,
              1e-5);  // friction takes 0.005 m/s of 0.5 m/s, not counting the corners' tilt
  EXPECT_NEAR(bodies[0].velocity_m_s.x() / bodies[0].velocity_m_s.z(), 0.75, 1e-9);
}

TEST(ContactSolver, ConditionsHoldAtTheAnswer) {
  std::vector<Moving> bodies = {cube({1, -2, 0.5}, {0.4, 3, -2}), immovable()};
  auto contacts = corners(0.3);
  EXPECT_TRUE(solve_contacts(bodies, contacts, 1e-12).converged);
  for (const ContactConstraint& c : contacts) {
    const Vec3 u = relative_velocity(bodies[0], bodies[1], c.point_m);
    const double normal = c.impulse_N_s.y();
    const Vec3 friction = c.impulse_N_s - normal * c.normal;
    EXPECT_GE(u.y(), -1e-11);
    EXPECT_GE(normal, 0);
    EXPECT_NEAR(normal * u.y(), 0, 1e-10);
    EXPECT_LE(friction.norm(), 0.3 * normal * (1 + 1e-12) + 1e-15);
    const Vec3 slip = u - u.y() * c.normal;
    const bool slides = normal > 0 && slip.norm() > 1e-9;
    EXPECT_LT(slides ? (friction + 0.3 * normal * slip.normalized()).norm() : 0.0, 1e-8);
  }
}

TEST(ContactSolver, OpenGapMayClose) {
  std::vector<Moving> bodies = {ball(1, 1, {0, 1.5, 0}, {0, -3, 0}), immovable()};
  std::vector<ContactConstraint> contacts = {{0, 1, {0, 0.25, 0}, Vec3::UnitY(), 0, -2, Vec3::Zero()}};
  EXPECT_TRUE(solve_contacts(bodies, contacts, 1e-12).converged);
  EXPECT_NEAR(bodies[0].velocity_m_s.y(), -2, 1e-14);
}

TEST(ContactSolver, GoodGuessIsKept) {
  std::vector<Moving> bodies = {cube(on_incline(0.49, 0.01)), immovable()};
  auto contacts = corners(0.5);
  solve_contacts(bodies, contacts, 1e-12);
  bodies[0] = cube(on_incline(0.49, 0.01));
  EXPECT_LE(solve_contacts(bodies, contacts, 1e-12).iterations, 2);
}

TEST(ContactSolver, NothingToDo) {
  std::vector<Moving> bodies = {cube({0, 1, 0}), immovable()};
  auto contacts = corners(0.5);
  const SolverReport report = solve_contacts(bodies, contacts, 1e-12);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(bodies[0].velocity_m_s, Vec3(0, 1, 0));
  EXPECT_TRUE(solve_contacts(bodies, {}, 1e-12).converged);
}

}  // namespace
}  // namespace animado::colisao
