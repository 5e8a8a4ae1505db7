// src/rpc/socket_channel.cpp with server.cpp and registration.cpp: calls over real sockets.
#include <gmock/gmock.h>
#include <sys/resource.h>

#include <numeric>

#include "fixture.hpp"
#include "rpc/local_suite.hpp"
#include "rpc/one_core.hpp"

namespace animado::rpc::testing {
namespace {

std::string text(const Echo::Request& request) {
  return to_json(type_of<Echo::Request>(), &request);
}

class SocketChannelTest : public SocketTest {
 protected:
  std::optional<Served> names_{std::in_place, directory_, "interexpserv", fill_names};
  std::optional<Served> parrot_{std::in_place, directory_, "parrot", fill_parrot};
  SocketSuite suite_{options()};
};

TEST_F(SocketChannelTest, AnswersAsTheServiceInThisProcessDoes) {
  LocalSuite local;
  local.add("interexpserv", fill_names);
  local.add("parrot", fill_parrot);
  for (Suite* suite : {static_cast<Suite*>(&suite_), static_cast<Suite*>(&local)}) {
    Channel& parrot = suite->channel("parrot");
    EXPECT_EQ(text(parrot.call<Echo>(full_request())), text(full_request()));
    const Error refused = error_of([&] { parrot.call<Fail>({}); });
    EXPECT_EQ(refused.code(), Code::refused);
    EXPECT_EQ(refused.where(), "fail.bug");
    EXPECT_EQ(refused.remedy(), "do not ask");
    EXPECT_EQ(error_of([&] { parrot.call<Fail>({true}); }).code(), Code::internal);
    EXPECT_EQ(error_of([&] { parrot.call<Lookup>({"x"}); }).code(), Code::unknown_method);
    EXPECT_EQ(parrot.call<Statistics>({}).errors, 3);
  }
}

// How often this thread gave its core away because it had to wait.
int64_t times_asleep() {
  rusage use{};
  getrusage(RUSAGE_THREAD, &use);
  return use.ru_nvcsw;
}

class OneCoreChannelTest : public SocketTest {
 protected:
  OneCore core_;
  Served names_{directory_, "interexpserv", fill_names};
  Served parrot_{directory_, "parrot", fill_parrot};
  SocketSuite suite_{options()};
};

// Not also when the service has read the request: on one core that takes the core from it, while it works.
TEST_F(OneCoreChannelTest, WhoCallsSleepsOnceAndIsWokenByTheAnswer) {
  constexpr int kCalls = 200;
  const std::vector<int64_t> shape{50000};  // some 100 µs of work
  suite_.arrays().create("test/in", shape);
  suite_.arrays().create("test/out", shape);
  const Twice::Request request{Array::named("test/in", shape), Array::named("test/out", shape)};
  Channel& parrot = suite_.channel("parrot");
  parrot.call<Twice>(request);
  const int64_t before = times_asleep();
  for (int i = 0; i < kCalls; ++i) parrot.call<Twice>(request);
  EXPECT_LT(times_asleep() - before, kCalls + kCalls / 4);
}

TEST_F(SocketChannelTest, SharedArraysAreReadAndWrittenInPlace) {
  SharedArray& in = suite_.arrays().create("test/in.1", {3});
  SharedArray& out = suite_.arrays().create("test/out.1", {3});
  std::iota(in.values().begin(), in.values().end(), 1.0);
  suite_.channel("parrot").call<Twice>({Array::named("test/in.1", {3}), Array::named("test/out.1", {3})});
  EXPECT_THAT(std::vector<double>(out.values().begin(), out.values().end()), ::testing::ElementsAre(2, 4, 6));
}

TEST_F(SocketChannelTest, ARestartedServerIsFoundAgainAndTheRequestRepeated) {
  Channel& parrot = suite_.channel("parrot");
  EXPECT_EQ(parrot.call<Echo>(full_request()).count, -3);
  parrot_.reset();
  std::thread back([&] { parrot_.emplace(directory_, "parrot", fill_parrot); });
  EXPECT_EQ(parrot.call<Echo>(full_request()).count, -3);
  back.join();
}

TEST_F(SocketChannelTest, ARestartedInterexpservGetsServicesAndArraysBack) {
  SharedArray& in = suite_.arrays().create("test/in.2", {2});
  in.values()[0] = 21;
  names_.reset();
  names_.emplace(directory_, "interexpserv", fill_names);
  // The parrot has never seen the array: it asks the new interexpserv, which gets it from us.
  const auto reply = suite_.channel("parrot").call<Twice>({Array::named("test/in.2", {2}), {}});
  EXPECT_EQ(reply.out.values[0], 42);
}

TEST_F(SocketChannelTest, AServiceThatStaysAwayIsNamed) {
  SocketSuite suite({.directory = directory_, .client = "test", .reconnect_s = 0.05});
  const Error error = error_of([&] { suite.channel("nobody").call<Ping>({}); });
  EXPECT_EQ(error.code(), Code::unavailable);
  EXPECT_EQ(error.where(), "nobody");
  EXPECT_FALSE(error.remedy().empty());
}

TEST_F(SocketChannelTest, NotificationsArriveBetweenReplies) {
  Channel& parrot = suite_.channel("parrot");
  parrot.call<Twice>({Array::inlined({3}, {1, 2, 3}), {}});
  Told::Request told;
  EXPECT_TRUE(parrot.wait_notification<Told>(told, 5));
  EXPECT_EQ(told.count, 3);
  EXPECT_FALSE(parrot.wait_notification<Told>(told, 0));
}

}  // namespace
}  // namespace animado::rpc::testing
