// Tests of colisao/server.cpp: the messages, through the client, with egesp in the same process.
#include "colisao/server.hpp"

#include <gtest/gtest.h>

#include "base/state.hpp"
#include "colisao/client.hpp"
#include "egesp/server.hpp"
#include "rpc/local_suite.hpp"
#include "tests/error_of.hpp"

namespace animado::colisao {
namespace {

BodyRecord ball(const char* name, double mass_kg, double radius_m) {
  BodyRecord record;
  record.name = name;
  record.size_m = {radius_m};
  record.mass_kg = mass_kg;
  const double inertia = 0.4 * mass_kg * radius_m * radius_m;
  record.inertia_kg_m2 = {inertia, 0, 0, 0, inertia, 0, 0, 0, inertia};
  return record;
}

BodyRecord floor_record() {
  BodyRecord record;
  record.name = "floor";
  record.shape = ShapeKind::plane;
  record.size_m = {0, 1, 0, 0};
  record.motion = MotionKind::fixed;
  record.restitution = 1;
  record.friction = 0.3;
  return record;
}

Array packed(const std::vector<BodyState>& states) {
  std::vector<double> values(kStateRows * states.size());
  for (size_t i = 0; i < states.size(); ++i) store_body(values.data(), states.size(), i, states[i]);
  return Array::inlined({kStateRows, static_cast<int64_t>(states.size())}, std::move(values));
}

BodyState at(const Vec3& position_m, const Vec3& velocity_m_s = Vec3::Zero(),
             const Vec3& spin_rad_s = Vec3::Zero()) {
  BodyState state;
  state.pose.position_m = position_m;
  state.velocity_m_s = velocity_m_s;
  state.angular_velocity_body_rad_s = spin_rad_s;
  return state;
}

struct Server : ::testing::Test {
  rpc::LocalSuite suite;
  std::optional<Client> client;

  Server() {
    suite.add("egesp", egesp::fill_table);
    suite.add("colisao", fill_table);
    client.emplace(suite.channel("colisao"));
  }
  void prepare(std::vector<BodyRecord> bodies) {
    Prepare::Request request;
    request.bodies = std::move(bodies);
    client->prepare(request);
  }
  Prepare::Reply prepare_directly(double mass_kg) {
    Prepare::Request request;
    request.bodies = {ball("ball", mass_kg, 1)};
    return suite.channel("colisao").call<Prepare>(request);
  }
};

TEST_F(Server, HandleNamesTheContent) {
  EXPECT_EQ(prepare_directly(2).handle, prepare_directly(2).handle);
  EXPECT_NE(prepare_directly(2).handle, prepare_directly(3).handle);
}

TEST_F(Server, UnknownHandleSaysWhatToDo) {
  Contacts::Request request;
  request.handle = "none";
  const Error error = error_of([&] { suite.channel("colisao").call<Contacts>(request); });
  EXPECT_EQ(error.code(), Code::unknown_handle);
  EXPECT_NE(error.remedy().find("prepare"), std::string::npos);
}

TEST_F(Server, ClientPreparesAgainWhenItsBodiesWereForgotten) {
  prepare({floor_record(), ball("ball", 2, 1)});
  for (int mass = 1; mass <= 20; ++mass) prepare_directly(mass);
  Contacts::Request request;
  request.state = packed({at({0, 0, 0}), at({0, 1, 0}, {0, -2, 0})});
  const auto contacts = client->contacts(request).contacts;
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_NEAR(contacts[0].approach_m_s, 2, 1e-14);
  EXPECT_NEAR(contacts[0].gap_m, 0, 1e-14);
}

TEST_F(Server, SweepFindsTheTimeOfTheMeeting) {
  prepare({ball("a", 2, 1), ball("b", 1, 0.5)});
  Sweep::Request request;
  request.from = packed({at({0, 0, 0}, {1, 0, 0}), at({4, 0, 0}, {-1, 0, 0})});
  request.to = packed({at({2, 0, 0}, {1, 0, 0}), at({2, 0, 0}, {-1, 0, 0})});
  request.step_s = 2;
  const auto found = client->sweep(request);
  EXPECT_TRUE(found.hit);
  EXPECT_NEAR(found.time_s, 1.25, 1e-11);
  EXPECT_EQ(found.a, 0);
  EXPECT_EQ(found.b, 1);
}

TEST_F(Server, ImpulseAndSystem15Agree) {
  BodyRecord a = ball("a", 2, 1), b = ball("b", 1.7, 0.5);
  a.friction = b.friction = 0.2;
  a.center_of_mass_m = {0.1, 0.05, -0.1};
  prepare({a, b});
  Respond::Request request;
  request.state = packed({at({0, 0, 0}, {1, 0.4, 0}, {1, 2, 3}), at({1.5, 0, 0}, {-1, 0, 0.2}, {0, -2, 1})});
  const auto closed = client->respond(request);
  request.response = Response::system15;
  const auto solved = client->respond(request);
  ASSERT_EQ(closed.impacts.size(), 1u);
  EXPECT_EQ(solved.impacts.size(), 1u);
  for (size_t n = 0; n < closed.state.values.size(); ++n) {
    EXPECT_NEAR(solved.state.values[n], closed.state.values[n], 1e-9);
  }
  EXPECT_NEAR(closed.impacts[0].separation_m_s, 0.25 * closed.impacts[0].approach_m_s, 1e-12);
  EXPECT_GT(closed.dissipated_impact_J, 0);
}

TEST_F(Server, RespondLeavesOthersToTheLastBit) {
  prepare({floor_record(), ball("falls", 2, 1), ball("flies", 2, 1)});
  Respond::Request request;
  request.state = packed(
      {at({0, 0, 0}), at({0, 1, 0}, {0, -2, 0}), at({9.1, 7.3, 0.1}, {0.1, 0.2, 0.3}, {0.7, 0.1, 0.3})});
  const auto after = client->respond(request).state.values;
  for (size_t row = 0; row < kStateRows; ++row) {
    EXPECT_EQ(after[3 * row + 2], request.state.values[3 * row + 2]);
    EXPECT_EQ(after[3 * row], request.state.values[3 * row]);
  }
  EXPECT_NEAR(after[3 * kVy + 1], 1, 1e-14);  // restitution 1 · 0.5
}

TEST_F(Server, AdvanceHoldsWhatRests) {
  prepare({floor_record(), ball("rests", 2, 1)});
  Advance::Request request;
  request.state = packed({at({0, 0, 0}), at({0, 1, 0})});
  request.free = packed({at({0, 0, 0}), at({0, 1 - 9.81 * 5e-5, 0}, {0, -0.0981, 0})});
  std::vector<double> accelerations(12, 0.0);
  accelerations[3] = -9.81;
  request.accelerations = Array::inlined({6, 2}, accelerations);
  request.step_s = 0.01;
  request.substeps = 4;
  const auto reply = client->advance(request);
  EXPECT_EQ(reply.moved, std::vector<int64_t>{1});
  EXPECT_EQ(reply.islands, 1);
  EXPECT_EQ(reply.contacts, 1);
  EXPECT_NEAR(reply.state.values[2 * kPy + 1], 1, 1e-15);
  EXPECT_NEAR(reply.state.values[2 * kVy + 1], 0, 1e-15);
}

TEST_F(Server, BoxSticksOnATiltedPlane) {  // with the geometry's contacts: tan 20° < μ
  const Quat tilt(Eigen::AngleAxisd(20 * M_PI / 180, Vec3(0.3, 0, 1).normalized()));
  const Vec3 normal = tilt * Vec3::UnitY();
  BodyRecord plane = floor_record(), box = ball("box", 3, 1);
  plane.size_m = {normal.x(), normal.y(), normal.z(), 0};
  box.shape = ShapeKind::box;
  box.size_m = {0.5, 0.3, 0.4};
  plane.friction = box.friction = 0.5;
  prepare({plane, box});
  BodyState start = at(0.3 * normal);
  start.pose.orientation = tilt;
  std::vector<BodyState> states = {at({0, 0, 0}), start};
  std::vector<double> accelerations(12, 0.0);
  accelerations[3] = -9.81;
  Advance::Request request;
  request.accelerations = Array::inlined({6, 2}, accelerations);
  request.step_s = 1.0 / 240;
  request.substeps = 2;
  for (int n = 0; n < 240; ++n) {
    request.state = packed(states);
    BodyState free = states[1];
    free.pose.position_m += request.step_s * free.velocity_m_s;
    request.free = packed({states[0], free});
    const auto reply = client->advance(request);
    ASSERT_EQ(reply.moved.size(), 1u);
    states[1] = load_body(reply.state.values.data(), 2, 1);
  }
  EXPECT_LT((states[1].pose.position_m - start.pose.position_m).norm(), 1e-7);
  EXPECT_LT(states[1].velocity_m_s.norm(), 1e-9);
}

TEST_F(Server, SpringsPushOverlappingBodiesApart) {
  prepare({floor_record(), ball("sinks", 2, 1)});
  Springs::Request request;
  request.state = packed({at({0, 0, 0}), at({0, 0.99, 0})});
  request.stiffness_N_m = 1000;
  const auto reply = client->springs(request);
  EXPECT_EQ(reply.wrenches.shape, (std::vector<int64_t>{6, 2}));
  EXPECT_NEAR(reply.wrenches.values[3], 10, 1e-10);
  EXPECT_NEAR(reply.stored_J, 0.05, 1e-12);
  EXPECT_EQ(reply.contacts.size(), 1u);
}

TEST_F(Server, BadRequestsAreRefusedWithTheField) {
  prepare({floor_record(), ball("ball", 2, 1)});
  Contacts::Request contacts;
  contacts.state = packed({at({0, 0, 0})});
  EXPECT_EQ(error_of([&] { client->contacts(contacts); }).code(), Code::bad_shape);
  contacts.state = packed({at({0, 0, 0}), at({0, NAN, 0})});
  EXPECT_EQ(error_of([&] { client->contacts(contacts); }).code(), Code::not_finite);

  Respond::Request respond;
  respond.state = packed({at({0, 0, 0}), at({0, 1, 0})});
  respond.response = Response::spring;
  EXPECT_EQ(error_of([&] { client->respond(respond); }).code(), Code::bad_params);

  Advance::Request advance;
  advance.state = advance.free = respond.state;
  advance.accelerations = Array::inlined({6, 2}, std::vector<double>(12, 0.0));
  EXPECT_EQ(error_of([&] { client->advance(advance); }).where(), "step_s");
  advance.step_s = 0.1;
  advance.substeps = 0;
  EXPECT_EQ(error_of([&] { client->advance(advance); }).code(), Code::limit);
}

TEST_F(Server, BadBodiesAreRefusedByName) {
  BodyRecord light = ball("feather", 0, 1);
  const Error error = error_of([&] { prepare({light}); });
  EXPECT_EQ(error.code(), Code::refused);
  EXPECT_NE(error.message().find("feather"), std::string::npos);

  BodyRecord sizeless = ball("sizeless", 1, 1);
  sizeless.size_m.clear();
  EXPECT_EQ(error_of([&] { prepare({sizeless}); }).where(), "size_m");

  BodyRecord bouncy = ball("bouncy", 1, 1);
  bouncy.restitution = 1.5;
  EXPECT_EQ(error_of([&] { prepare({bouncy}); }).where(), "restitution");

  BodyRecord hull = ball("hull", 1, 1);
  hull.shape = ShapeKind::hull;
  hull.size_m.clear();
  hull.vertices_m = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  hull.faces = {{0, 1, 7}};
  EXPECT_EQ(error_of([&] { prepare({hull}); }).where(), "faces");
}

}  // namespace
}  // namespace animado::colisao
