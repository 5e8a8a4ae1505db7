// An integration that takes long, over a socket: its caller is told how far it is, and when the caller is
// gone it ends.
#include <gtest/gtest.h>

#include "raw_client.hpp"
#include "services.hpp"

namespace animado::suite {
namespace {

constexpr double kEnd = 1e12;  // far beyond what is reached

Json endless_integration(double limit_s) {
  return {{"equations", {"x' = v", "v' = -x"}},
          {"from", {{{"name", "x"}, {"value", 1}}, {{"name", "v"}, {"value", 0}}}},
          {"t1", kEnd},
          {"tolerance", 1e-9},
          {"max_steps", int64_t{1} << 60},
          {"max_time_s", limit_s},
          {"progress_s", 0.1}};
}

// [2, "progress", [how far]]
Json progress_in(const Json& message) {
  EXPECT_EQ(message.at(0), 2) << message.dump();
  EXPECT_EQ(message.at(1), "progress");
  return message.at(2).at(0);
}

TEST(LongIntegration, TellsItsCallerHowFarItIs) {
  Services services;
  RawClient caller(services.socket("fred"));
  caller.hello();
  caller.send(packed(7, "integrate", endless_integration(0.8)));
  std::vector<Json> told;
  auto message = caller.receive_message();
  for (; message && message->at(0) == 2; message = caller.receive_message())
    told.push_back(progress_in(*message));
  ASSERT_TRUE(message) << "the connection was closed";
  ASSERT_TRUE(message->at(2).is_null()) << message->dump();
  const Json reply = message->at(3);
  EXPECT_EQ(message->at(1), 7);
  EXPECT_EQ(reply.at("stop"), "time_limit");
  EXPECT_GE(told.size(), 2u);
  EXPECT_LE(told.size(), 8u);
  told.push_back({{"t", reply.at("t")}, {"t1", kEnd}, {"steps", reply.at("steps")}});
  for (size_t i = 1; i < told.size(); ++i) {
    EXPECT_LT(told[i - 1].at("t"), told[i].at("t"));
    EXPECT_LT(told[i - 1].at("steps"), told[i].at("steps"));
    EXPECT_EQ(told[i - 1].at("t1"), kEnd);
  }
}

// The service does one thing after the other: it answers another caller only when the integration is over.
TEST(LongIntegration, EndsWhenItsCallerIsGone) {
  Services services;
  {
    RawClient caller(services.socket("fred"));
    caller.hello();
    caller.send(packed(7, "integrate", endless_integration(3600)));
    const auto message = caller.receive_message();
    ASSERT_TRUE(message);
    progress_in(*message);
  }
  RawClient other(services.socket("fred"));
  other.hello();
  const auto answer = other.call("methods", Json::object());
  ASSERT_TRUE(answer);
  EXPECT_TRUE(answer->error.is_null());
}

}  // namespace
}  // namespace animado::suite
