// src/rpc/pipeline.cpp, and what a server does with requests that come together.
#include <gmock/gmock.h>

#include "fixture.hpp"
#include "rpc/local_suite.hpp"

namespace animado::rpc::testing {
namespace {

class PipelineTest : public SocketTest {
 protected:
  std::vector<Echo::Request> requests(int64_t count, const std::string& label = {}) {
    std::vector<Echo::Request> requests(static_cast<size_t>(count));
    for (int64_t i = 0; i < count; ++i) {
      requests[static_cast<size_t>(i)].count = i;
      requests[static_cast<size_t>(i)].label = label;
    }
    return requests;
  }
  void expect_echo(const std::vector<Channel::Answer<Echo>>& answers, int64_t count) {
    ASSERT_EQ(answers.size(), static_cast<size_t>(count));
    for (int64_t i = 0; i < count; ++i) {
      ASSERT_FALSE(answers[static_cast<size_t>(i)].error);
      ASSERT_EQ(answers[static_cast<size_t>(i)].reply.count, i);
    }
  }

  std::optional<Served> names_{std::in_place, directory_, "interexpserv", fill_names};
  std::optional<Served> parrot_{std::in_place, directory_, "parrot", fill_parrot};
  SocketSuite suite_{options()};
};

TEST_F(PipelineTest, RepliesComeInTheOrderOfTheRequests) {
  Channel& parrot = suite_.channel("parrot");
  expect_echo(parrot.call_all<Echo>(requests(5000)), 5000);
  expect_echo(parrot.call_all<Echo>(requests(0)), 0);
  EXPECT_EQ(parrot.call<Echo>(full_request()).count, -3);  // the connection is as it was
  LocalSuite local;
  local.add("parrot", fill_parrot);
  expect_echo(local.channel("parrot").call_all<Echo>(requests(10)), 10);
}

// Far more than the sockets hold in both directions: neither end may wait for the other.
TEST_F(PipelineTest, MoreThanTheSocketsHold) {
  expect_echo(suite_.channel("parrot").call_all<Echo>(requests(2000, std::string(20'000, 'x'))), 2000);
}

TEST_F(PipelineTest, AnErrorStopsNoneOfTheOthers) {
  Channel& parrot = suite_.channel("parrot");
  const auto failed = parrot.call_all<Fail>(std::vector<Fail::Request>(3));
  for (const auto& answer : failed) EXPECT_EQ(answer.error->code(), Code::refused);
  std::vector<Twice::Request> mixed(3, Twice::Request{Array::inlined({1}, {21}), {}});
  mixed[1].in.shape = {7};
  const auto answers = parrot.call_all<Twice>(mixed);
  EXPECT_EQ(answers[0].reply.out.values.at(0), 42);
  EXPECT_EQ(answers[1].error->code(), Code::bad_shape);
  EXPECT_EQ(answers[2].reply.out.values.at(0), 42);
  Told::Request told;
  EXPECT_TRUE(parrot.wait_notification<Told>(told, 5));  // notifications between replies are kept
}

TEST_F(PipelineTest, GoesOnWithARestartedServer) {
  Channel& parrot = suite_.channel("parrot");
  parrot.call<Ping>({});
  std::thread restart([&] {
    parrot_.reset();
    parrot_.emplace(directory_, "parrot", fill_parrot);
  });
  expect_echo(parrot.call_all<Echo>(requests(50'000)), 50'000);
  restart.join();
}

TEST_F(PipelineTest, ARestartedInterexpservGetsTheArraysBack) {
  SharedArray& in = suite_.arrays().create("test/in.3", {1});
  in.values()[0] = 21;
  names_.reset();
  names_.emplace(directory_, "interexpserv", fill_names);
  const std::vector<Twice::Request> two(2, Twice::Request{Array::named("test/in.3", {1}), {}});
  const auto answers = suite_.channel("parrot").call_all<Twice>(two);
  EXPECT_EQ(answers[1].reply.out.values.at(0), 42);
}

TEST_F(PipelineTest, StatisticsTellHowLongAndHowBusy) {
  Channel& parrot = suite_.channel("parrot");
  parrot.call_all<Echo>(requests(1000, std::string(1000, 'x')));
  const Statistics::Reply s = parrot.call<Statistics>({});
  int64_t counted = 0;
  for (const auto& row : s.latency) counted += row.requests;
  EXPECT_EQ(counted, s.requests);
  EXPECT_GE(counted, 1000);
  EXPECT_GT(s.busy_s, 0);
  EXPECT_LT(s.busy_s, s.up_s);
  EXPECT_EQ(s.connections, 1);
  EXPECT_GE(s.waiting, 0);
  const auto echo = std::ranges::find(s.messages, "echo", &Statistics::Count::message);
  EXPECT_GT(echo->time_s, 0);
}

TEST_F(PipelineTest, AServerOfSeveralIsReachedByItsSocket) {
  Served other(directory_, "parrot2", fill_parrot);
  SocketChannel& first = suite_.server("parrot", parrot_->socket());
  SocketChannel& second = suite_.server("parrot", other.socket());
  first.call<Echo>(full_request());
  EXPECT_EQ(first.call<Statistics>({}).requests, 2);  // hello, echo
  EXPECT_EQ(second.call<Statistics>({}).service, "parrot2");
}

}  // namespace
}  // namespace animado::rpc::testing
