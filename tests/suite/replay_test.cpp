// A run that was edited while it went, made again from its results: the same edits at the same frames, to the
// same bits.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command.hpp"

namespace animado::suite {
namespace {

namespace fs = std::filesystem;

constexpr auto kSpringScene = R"(
world
gravity (0, -9.81, 0)
object ball
shape sphere(radius=0.5)
mass 1
force (-4*ball.position.x, 0, 0)
time
start 0
end 200
step 0.1
)";

class Replays : public testing::Test {
 protected:
  Replays() { write_text(directory_ / "scene.animado", kSpringScene); }

  // Runs the scene and gives the ball another force as soon as some frames are there, and once more.
  Outcome run_edited() {
    Command command(directory_, {"run", "scene.animado", "--no-pictures", "--run", kRun, "--out", "first"});
    const fs::path partial = directory_ / fmt::format(".first.partial-{}", command.pid());
    const auto over = [&] { return !command.running(); };
    const auto text_in = [&](const char* file) {
      return fs::exists(partial / file) ? text_of(partial / file) : "";
    };
    EXPECT_TRUE(wait_until([&] { return text_in("states.csv").size() > 5000; }, over));
    for (const char* force : {"(sin(t), 9.81, 0)", "(-ball.position.x, 9.81, cos(t))"}) {
      EXPECT_EQ(animado({"set", "ball.force", force, "--run", kRun}).code, 0);
      EXPECT_TRUE(wait_until([&] { return text_in("events.jsonl").find(force) != std::string::npos; }, over));
    }
    return command.finish();
  }
  Outcome finish(const Words& arguments) { return Command(directory_, arguments).finish(); }
  nlohmann::json summary(const char* results) {
    return nlohmann::json::parse(text_of(directory_ / results / "summary.json"));
  }

  static constexpr auto kRun = "replays";
  const TemporaryDirectory directory_;
};

TEST_F(Replays, MakeTheSameEditsToTheSameBits) {
  ASSERT_EQ(run_edited().code, 0);
  const Outcome again = finish({"run", "--replay", "first", "--no-pictures"});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_NE(again.err.find("the same as first, to the last bit"), std::string::npos) << again.err;
  EXPECT_EQ(summary("first-replay")["state_hash"], summary("first")["state_hash"]);
  EXPECT_EQ(text_of(directory_ / "first-replay" / "events.jsonl"),
            text_of(directory_ / "first" / "events.jsonl"));

  // In one process as well, and when the scene is not there any more.
  fs::remove(directory_ / "scene.animado");
  EXPECT_EQ(finish({"run", "--replay", "first", "--no-pictures", "--out", "third", "--in-process"}).code, 0);
  EXPECT_EQ(summary("third")["state_hash"], summary("first")["state_hash"]);

  // Without the edits it is another motion.
  EXPECT_EQ(finish({"run", "first/scene.animado", "--no-pictures", "--out", "unedited"}).code, 0);
  EXPECT_NE(summary("unedited")["state_hash"], summary("first")["state_hash"]);
}

TEST_F(Replays, ThatAreNotTheSameSayWhereAndExitWith1) {
  ASSERT_EQ(finish({"run", "scene.animado", "--no-pictures", "--out", "first"}).code, 0);
  std::string states = text_of(directory_ / "first" / "states.csv");
  states.replace(states.find("\n3,"), 3, "\n3, ");
  write_text(directory_ / "first" / "states.csv", states);
  const Outcome again = finish({"run", "--replay", "first", "--no-pictures"});
  EXPECT_EQ(again.code, 1);
  EXPECT_THAT(again.err, testing::HasSubstr("NOT the same as first from here on: frame 3, t = 0.3"));
  EXPECT_THAT(again.err, testing::HasSubstr("`ball`"));
  EXPECT_EQ(finish({"run", "--replay", "first", "--no-pictures", "--in-process", "--quiet"}).code, 1);
}

TEST_F(Replays, OfARunThatWasInterruptedGoOnToTheSameBits) {
  ASSERT_EQ(finish({"run", "scene.animado", "--no-pictures", "--out", "first"}).code, 0);
  const std::string states = text_of(directory_ / "first" / "states.csv");
  auto interrupted = summary("first");
  interrupted["status"] = "interrupted";
  interrupted["state_hash"] = "that of frame 3";
  write_text(directory_ / "first" / "summary.json", interrupted.dump());
  write_text(directory_ / "first" / "states.csv", states.substr(0, states.find("\n4,") + 1));
  const Outcome again = finish({"run", "--replay", "first", "--no-pictures"});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_THAT(again.err, testing::HasSubstr("the same as first, to the last bit, as far as both went"));
}

TEST_F(Replays, AFolderWithoutResultsIsToldApart) {
  const Outcome outcome = finish({"run", "--replay", "."});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_NE(outcome.err.find("no whole results"), std::string::npos) << outcome.err;
}

TEST_F(Replays, ASceneOrAReplayIsNeeded) {
  EXPECT_EQ(finish({"run"}).code, 2);
  EXPECT_EQ(finish({"run", "scene.animado", "--replay", "."}).code, 2);
}

}  // namespace
}  // namespace animado::suite
