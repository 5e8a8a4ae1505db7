// src/controle/results/states_csv.cpp
#include "controle/results/states_csv.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <sstream>

#include "base/state.hpp"
#include "tests/temporary_directory.hpp"

namespace animado::controle {
namespace {

using Row = std::vector<std::string>;

std::vector<Row> rows_of(const std::string& text) {
  std::vector<Row> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    Row& row = rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
  }
  return rows;
}

std::vector<double> state_of(const std::vector<BodyState>& bodies) {
  std::vector<double> state(bodies.size() * kStateRows);
  for (size_t i = 0; i < bodies.size(); ++i) store_body(state.data(), bodies.size(), i, bodies[i]);
  return state;
}

std::vector<Row> table_of(const std::vector<StatesCsv::Body>& bodies, const std::vector<BodyState>& states) {
  const TemporaryDirectory directory;
  StatesCsv csv(directory.path() / "states.csv", bodies);
  csv.frame(0, 0.5, state_of(states));
  csv.close();
  return rows_of(text_of(directory.path() / "states.csv"));
}

BodyState awkward_body() {
  BodyState body;
  body.pose.position_m = {0.1, -1e-300, 123456789.123456789};
  body.pose.orientation = orientation_of({0.1, 0.2, 0.3}, {0, 1, 2});
  body.velocity_m_s = {1.0 / 3, 5e-324, -0.0};
  body.angular_velocity_body_rad_s = {1, 2, 3};
  return body;
}

TEST(StatesCsv, HeaderIsTheContract) {
  const TemporaryDirectory directory;
  StatesCsv csv(directory.path() / "states.csv", {});
  csv.close();
  EXPECT_EQ(text_of(directory.path() / "states.csv"),
            "frame,time_s,body,px_m,py_m,pz_m,qw,qx,qy,qz,ex_rad,ey_rad,ez_rad,"
            "vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_s,wz_rad_s\n");
}

TEST(StatesCsv, ARowABodyAFrame) {
  const TemporaryDirectory directory;
  StatesCsv csv(directory.path() / "states.csv", {{"esfera", {0, 1, 2}}, {"cubo", {0, 1, 2}}});
  const std::vector<double> state = state_of({BodyState{}, BodyState{}});
  for (int frame = 0; frame < 12; ++frame) csv.frame(frame, 0.3 * frame, state);
  csv.close();
  const std::vector<Row> rows = rows_of(text_of(directory.path() / "states.csv"));
  ASSERT_EQ(rows.size(), 25u);
  for (const Row& row : rows) EXPECT_EQ(row.size(), 19u);
  EXPECT_EQ(rows[6][0], "2");
  EXPECT_EQ(rows[6][1], "0.59999999999999998");
  EXPECT_EQ(rows[6][2], "cubo");
}

TEST(StatesCsv, NumbersReadBackToTheSameBits) {
  const BodyState body = awkward_body();
  const Row row = table_of({{"a", {0, 1, 2}}}, {body})[1];
  const Quat& q = body.pose.orientation;
  const Vec3 &p = body.pose.position_m, &v = body.velocity_m_s, w = body.angular_velocity_rad_s();
  const std::vector<std::pair<size_t, double>> expected = {
      {3, p.x()},  {4, p.y()},  {5, p.z()},  {6, q.w()},  {7, q.x()},  {8, q.y()}, {9, q.z()},
      {13, v.x()}, {14, v.y()}, {15, v.z()}, {16, w.x()}, {17, w.y()}, {18, w.z()}};
  for (const auto& [column, value] : expected) {
    EXPECT_EQ(std::bit_cast<uint64_t>(std::strtod(row[column].c_str(), nullptr)),
              std::bit_cast<uint64_t>(value))
        << column;
  }
}

TEST(StatesCsv, FormatIsThatOfPrintf) {
  for (const double value :
       {0.1, 1.0, 100000.0, 1e16, 1e17, 1e-4, 1e-5, 2.5e-308, 1.7976931348623157e308, -0.0, 1.0 / 3}) {
    BodyState body;
    body.pose.position_m.x() = value;
    char expected[40];
    std::snprintf(expected, sizeof expected, "%.17g", value);
    EXPECT_EQ(table_of({{"a", {0, 1, 2}}}, {body})[1][3], expected);
  }
}

// The state holds angular velocity in body axes; a quarter turn about z takes the body's x to the world's y.
TEST(StatesCsv, AngularVelocityIsInWorldAxes) {
  BodyState body;
  body.pose.orientation = orientation_of({0, 0, std::numbers::pi / 2}, {0, 1, 2});
  body.angular_velocity_body_rad_s = {2, 0, 0};
  const Row row = table_of({{"a", {0, 1, 2}}}, {body})[1];
  EXPECT_NEAR(std::stod(row[16]), 0, 1e-15);
  EXPECT_NEAR(std::stod(row[17]), 2, 1e-15);
}

TEST(StatesCsv, EulerAnglesFollowTheOrderOfEachBody) {
  const Vec3 angles_rad(0.4, -0.5, 0.6);
  const std::vector<StatesCsv::Body> bodies = {{"a", {0, 1, 2}}, {"b", {2, 0, 1}}};
  std::vector<BodyState> states(2);
  for (size_t i = 0; i < 2; ++i)
    states[i].pose.orientation = orientation_of(angles_rad, bodies[i].rotation_order);
  const std::vector<Row> rows = table_of(bodies, states);
  for (size_t i = 1; i <= 2; ++i) {
    for (size_t axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(std::stod(rows[i][10 + axis]), angles_rad[axis], 1e-14);
  }
}

}  // namespace
}  // namespace animado::controle
