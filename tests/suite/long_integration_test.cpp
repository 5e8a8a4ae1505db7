// An integration that takes long, over a socket: its caller is told how far it is, and when the caller is
// gone it ends.
#include <gtest/gtest.h>

#include "raw_client.hpp"
#include "services.hpp"

namespace animado::suite {
namespace {

constexpr double kEnd = 1e12;  // far beyond what is reached

Json endless_integration() {
  return {{"equations", {"x' = v", "v' = -x"}},
          {"from", {{{"name", "x"}, {"value", 1}}, {{"name", "v"}, {"value", 0}}}},
          {"t1", kEnd},
          {"tolerance", 1e-9},
          {"max_steps", int64_t{1} << 60},
          {"max_time_s", 3600},
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
  caller.send(packed(7, "integrate", endless_integration()));
  std::vector<Json> told;
  while (told.size() < 3) {
    const auto message = caller.receive_message();
    ASSERT_TRUE(message) << "the connection was closed";
    told.push_back(progress_in(*message));
    EXPECT_EQ(told.back().at("t1"), kEnd);
  }
  for (size_t i = 1; i < told.size(); ++i) {
    EXPECT_LT(told[i - 1].at("t"), told[i].at("t"));
    EXPECT_LT(told[i - 1].at("steps"), told[i].at("steps"));
  }
}

// The service does one thing after the other: it answers another caller only when the integration is over.
TEST(LongIntegration, EndsWhenItsCallerIsGone) {
  Services services;
  {
    RawClient caller(services.socket("fred"));
    caller.hello();
    caller.send(packed(7, "integrate", endless_integration()));
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
