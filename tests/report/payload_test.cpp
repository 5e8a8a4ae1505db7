// src/report/payload.cpp: the header says what the run was, and its arrays hold its motion.
#include "report/payload.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "tests/report/sample_run.hpp"

namespace animado::report {
namespace {

using controle::RecordedRun;
using Json = nlohmann::json;

// A payload taken apart by the rules of docs/report.md.
struct Unpacked {
  explicit Unpacked(const std::string& bytes) {
    uint32_t length = 0;
    std::memcpy(&length, bytes.data(), 4);
    header = Json::parse(bytes.substr(4, length));
    binary = bytes.substr(4 + length);
    EXPECT_EQ((4 + length) % 8, 0u);
  }
  template <class Number>
  Number number(const std::string& array, size_t at) const {
    const Json& entry = header.at("arrays").at(array);
    EXPECT_LT(at, entry.at("count").get<size_t>()) << array;
    Number value;
    std::memcpy(&value, binary.data() + entry.at("offset").get<size_t>() + at * sizeof value, sizeof value);
    return value;
  }
  // A component of a vector that is coded between its body's lowest and highest.
  double component(const std::string& array, size_t body, size_t at, size_t k) const {
    const Json& entry = header.at("arrays").at(array);
    const double low = entry.at("low").at(3 * body + k), high = entry.at("high").at(3 * body + k);
    return low + number<uint16_t>(array, 3 * at + k) / 65535.0 * (high - low);
  }
  Quat rotation(size_t at) const {
    const auto part = [&](size_t c) { return number<int16_t>("rotation", 4 * at + c) / 32767.0; };
    return Quat(part(0), part(1), part(2), part(3)).normalized();
  }

  Json header;
  std::string binary;
};

TEST(Payload, SaysWhatTheRunWas) {
  const RecordedRun run = sample_run(3, 90);
  const Traffic traffic{
      .time_s = 0.5, .step = 7, .span_us = 20, .messages = {{1.5, 4.5, "controle", "fred", "stage"}}};
  const Json header = Unpacked(payload(run, traffic)).header;
  EXPECT_EQ(header.at("format"), kPayloadFormat);
  EXPECT_EQ(header.at("version"), ANIMADO_VERSION);
  EXPECT_EQ(header.at("scene"), "sample.animado");
  EXPECT_EQ(header.at("scene_text"), run.scene_text);
  EXPECT_EQ(header.at("summary"), Json::parse(run.summary_json));
  EXPECT_EQ(header.at("frames"), 90);
  EXPECT_EQ(header.at("bodies").size(), 4u);
  EXPECT_EQ(header.at("bodies").at(1).at("name"), "body1");
  EXPECT_EQ(header.at("bodies").at(1).at("shape").at("kind"), "box");
  EXPECT_EQ(header.at("bodies").at(1).at("frames"), 90);
  EXPECT_EQ(header.at("bodies").at(3).at("frames"), 1);  // the floor stays where it is
  ASSERT_FALSE(run.events.empty());
  EXPECT_EQ(header.at("events").size(), run.events.size());
  EXPECT_EQ(header.at("events").at(0), Json::parse(event_line(run.events[0])));
  EXPECT_EQ(header.at("traffic"), Json::parse(R"({"time_s": 0.5, "step": 7, "span_us": 20.0, "messages": [
                {"at_us": 1.5, "took_us": 4.5, "from": "controle", "to": "fred", "method": "stage"}]})"));
}

TEST(Payload, HasTheMotionBodyAfterBody) {
  const RecordedRun run = sample_run(3, 5);
  const Unpacked page(payload(run, {}));
  EXPECT_TRUE(page.header.at("traffic").is_null());
  EXPECT_EQ(page.number<double>("time_s", 4), run.times_s[4]);
  EXPECT_EQ(page.header.at("arrays").at("position").at("count"), 3 * (3 * 5 + 1));
  for (size_t body = 0; body < 3; ++body) {
    for (size_t frame = 0; frame < 5; ++frame) {
      const size_t at = body * 5 + frame;
      const auto& state = run.at(frame, body);
      EXPECT_LT(page.rotation(at).angularDistance(state.pose.orientation), 1e-4);
      for (size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        EXPECT_NEAR(page.component("position", body, at, k), state.pose.position_m[axis], 1e-4);
        EXPECT_NEAR(page.component("velocity", body, at, k), state.velocity_m_s[axis], 1e-3);
        EXPECT_NEAR(page.component("angular_velocity", body, at, k), state.angular_velocity_rad_s[axis],
                    1e-3);
      }
    }
  }
}

TEST(Payload, HasTheFactsOfEachFrame) {
  const RecordedRun run = sample_run(3, 5);
  const Unpacked page(payload(run, {}));
  for (const std::string_view name : controle::kFactNames)
    EXPECT_EQ(page.header.at("arrays").at("facts." + std::string(name)).at("count"), 5) << name;
  EXPECT_EQ(page.number<double>("facts.kinetic_J", 2), run.facts[2].kinetic_J);
  EXPECT_EQ(page.number<double>("facts.steps", 3), 12);
}

TEST(Payload, OfManyImpactsTheStrongestAreShown) {
  RecordedRun run = sample_run(2, 2);
  run.events.clear();
  for (size_t k = 0; k < kMostEvents + 500; ++k) {
    run.events.push_back({.time_s = 1e-6 * static_cast<double>(k),
                          .kind = controle::EventKind::impact,
                          .impulse_N_s = Vec3(0, static_cast<double>(k), 0)});
  }
  run.events.push_back({.time_s = 1, .kind = controle::EventKind::restart, .name = "fred"});
  const Json header = Unpacked(payload(run, {})).header;
  ASSERT_EQ(header.at("events").size(), kMostEvents + 1);
  EXPECT_EQ(header.at("events").at(0).at("impulse_N_s").at(1), 500);
  EXPECT_EQ(header.at("events").back().at("kind"), "restart");
  EXPECT_EQ(header.at("events_total"), kMostEvents + 501);
}

TEST(Payload, OfManyFramesSomeAreShown) {
  constexpr size_t kFrames = kMostStates * 2 + 10;  // each third is shown
  RecordedRun run = sample_run(1, 3);
  run.times_s.resize(kFrames);
  for (size_t k = 0; k < kFrames; ++k) run.times_s[k] = static_cast<double>(k);
  run.states.resize(kFrames * 2);
  run.facts.resize(kFrames);
  const Unpacked page(payload(run, {}));
  EXPECT_EQ(page.header.at("frames"), (kFrames + 2) / 3);
  EXPECT_EQ(page.header.at("frames_total"), kFrames);
  EXPECT_EQ(page.header.at("bodies").at(0).at("frames"), page.header.at("frames"));
  EXPECT_EQ(page.number<double>("time_s", 1), 3);
}

TEST(Payload, ARunWithoutFramesIsRefused) {
  RecordedRun run = sample_run(1, 1);
  run.times_s.clear();
  EXPECT_THROW(payload(run, {}), Error);
}

TEST(Payload, ASummaryThatIsNoneIsRefused) {
  RecordedRun run = sample_run(1, 1);
  run.summary_json = "{";
  EXPECT_THROW(payload(run, {}), Error);
}

TEST(Payload, BytesOfAnyKindMakeAHeader) {
  RecordedRun run = sample_run(1, 1);
  run.scene_text = "# caf\xe9 </script>\n";  // Latin-1
  EXPECT_EQ(Unpacked(payload(run, {})).header.at("frames"), 1);
}

}  // namespace
}  // namespace animado::report
