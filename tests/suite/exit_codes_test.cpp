// The exit codes of `animado`, each with what it prints and leaves (design, section 8).
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include "command.hpp"

namespace animado::suite {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr auto kTwoFrames = R"(
object ball
shape sphere(radius=1)
mass 1
velocity (1, 0, 0)
time
start 0
end 0.1
step 0.1
)";

// The force grows without bound: x'' = 1e6 x³ reaches infinity in a finite time.
constexpr auto kDiverging = R"(
object ball
shape sphere(radius=1)
mass 1
position (1, 0, 0)
force (1e6*ball.position.x^3, 0, 0)
time
start 0
end 10
step 0.1
)";

// Out of what a number holds within a step.
constexpr auto kOverflowing = R"(
object ball
shape sphere(radius=1)
mass 1
force (1e200, 0, 0)
time
end 10
step 0.1
)";

constexpr auto kLong = R"(
object ball
shape sphere(radius=1)
mass 1
velocity (1, 0, 0)
time
start 0
end 100000
step 0.1
)";

// So stiff that its first frame takes 10⁸ steps and more.
constexpr auto kEndlessFrame = R"(
world
method dopri5
object ball
shape sphere(radius=1)
mass 1
velocity (1, 0, 0)
linear damping 1e9
time
end 1
step 1
)";

class ExitCodes : public testing::Test {
 protected:
  std::string scene(const std::string& text) { return write_text(directory_ / "scene.animado", text); }
  Outcome in_shell(const std::string& arguments, const fs::path& program = kAnimado) {
    return Command(directory_, {"-c", "exec \"$0\" " + arguments, program}, "/bin/sh").finish();
  }
  TemporaryDirectory directory_;
};

class BothWays : public ExitCodes, public testing::WithParamInterface<bool> {
 protected:
  Words run_words(const std::string& scene_text, Words more = {}) {
    Words words = {"run", scene(scene_text), "--no-pictures"};
    if (GetParam()) words.push_back("--in-process");
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  // Ctrl-C as soon as there are steps.
  Outcome interrupted(const std::string& scene_text) {
    Command command(directory_, run_words(scene_text));
    const fs::path partial = directory_ / "runs" / fmt::format(".scene.partial-{}", command.pid());
    const auto under_way = [&] {
      return text_of(partial / "logs/fred.log").find(" stage ") != std::string::npos;
    };
    EXPECT_TRUE(wait_until(under_way, [&] { return !command.running(); })) << command.err();
    command.signal(SIGINT);
    const Outcome outcome = command.finish();
    EXPECT_FALSE(fs::exists(partial));
    return outcome;
  }
};
INSTANTIATE_TEST_SUITE_P(Run, BothWays, testing::Bool(),
                         [](const auto& way) { return way.param ? "InProcess" : "Sockets"; });

TEST_P(BothWays, ZeroWhenDoneWithTheFilesOfARun) {
  const Outcome outcome = Command(directory_, run_words(kTwoFrames)).finish();
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("results in runs/scene"));
  for (const std::string file :
       {"states.csv", "events.jsonl", "summary.json", "animation.glb", "logs/interexpserv.log",
        "logs/egesp.log", "logs/fred.log", "logs/colisao.log"}) {
    EXPECT_TRUE(fs::exists(directory_ / "runs/scene" / file)) << file;
  }
  // The results, and nothing beside them.
  EXPECT_EQ(std::distance(fs::directory_iterator(directory_ / "runs"), fs::directory_iterator()), 1);
}

TEST_P(BothWays, ThreeWhenTheSceneIsRefusedBeforeAnythingIsMade) {
  const Outcome outcome =
      Command(directory_, run_words("object ball\nshape sphere(radius=1)\nmas 1\n")).finish();
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("scene.animado:3:1"));
  EXPECT_THAT(outcome.err, HasSubstr("mass"));
  EXPECT_FALSE(fs::exists(directory_ / "runs"));
}

TEST_P(BothWays, FourWhenTheMotionDivergesWithTheFramesSoFar) {
  const Outcome outcome = Command(directory_, run_words(kDiverging)).finish();
  EXPECT_EQ(outcome.code, 4) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("error: "));
  EXPECT_THAT(outcome.err, HasSubstr("ball"));
  EXPECT_THAT(text_of(directory_ / "runs/scene/summary.json"), HasSubstr("\"diverged\""));
}

TEST_P(BothWays, FourAndNumbersInTheSummaryHoweverFarTheMotionDiverges) {
  const Outcome outcome = Command(directory_, run_words(kOverflowing)).finish();
  EXPECT_EQ(outcome.code, 4) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("energy: 0 J at the start, 0 J at the end"));
  EXPECT_THAT(text_of(directory_ / "runs/scene/summary.json"), Not(HasSubstr("null")));
}

TEST_P(BothWays, HundredAndThirtyWhenInterruptedWithUsableResults) {
  const Outcome outcome = interrupted(kLong);
  EXPECT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_THAT(text_of(directory_ / "runs/scene/summary.json"), HasSubstr("\"interrupted\""));
  const std::string states = text_of(directory_ / "runs/scene/states.csv");
  EXPECT_TRUE(states.ends_with('\n'));
  EXPECT_GE(std::ranges::count(states, '\n'), 2);
}

TEST_P(BothWays, HundredAndThirtyWhenInterruptedInTheMidstOfAFrame) {
  const Outcome outcome = interrupted(kEndlessFrame);
  EXPECT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_THAT(text_of(directory_ / "runs/scene/summary.json"), HasSubstr("\"interrupted\""));
  EXPECT_EQ(std::ranges::count(text_of(directory_ / "runs/scene/states.csv"), '\n'), 2);
}

// No file may grow beyond 100 kB, which is refused as the space of a full disk is.
TEST_P(BothWays, FiveWhenTheDiskIsFullWithWhatWasWritten) {
  Words words = {"-c", "trap '' XFSZ; ulimit -f 200; exec \"$0\" \"$@\"", kAnimado};
  const Words run = run_words(kLong);
  words.insert(words.end(), run.begin(), run.end());
  Command command(directory_, words, "/bin/sh");
  const fs::path partial = directory_ / "runs" / fmt::format(".scene.partial-{}", command.pid());
  const Outcome outcome = command.finish();
  EXPECT_EQ(outcome.code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("cannot write"));
  EXPECT_GT(fs::file_size(partial / "states.csv"), 50'000);
  EXPECT_FALSE(fs::exists(directory_ / "runs/scene"));
}

TEST_P(BothWays, PrintsTheSummaryOnStdoutForPrograms) {
  const Outcome outcome = Command(directory_, run_words(kTwoFrames, {"--json", "--quiet"})).finish();
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(nlohmann::json::parse(outcome.out).at("frames"), 2);
}

TEST_F(ExitCodes, TwoForACommandLineThatMakesNoSense) {
  EXPECT_EQ(animado({}).code, 2);
  EXPECT_EQ(animado({"fly"}).code, 2);
  EXPECT_EQ(animado({"run"}).code, 2);
  EXPECT_EQ(animado({"run", "scene", "--in-process", "--keep-services"}).code, 2);
  EXPECT_EQ(animado({"run", "scene", "--no-pictures", "--mp4"}).code, 2);
}

TEST_F(ExitCodes, TwoWhenTheResultsWouldReplaceSomethingElse) {
  write_text(directory_ / "letter", "dear");
  const Outcome outcome =
      Command(directory_, {"run", scene(kTwoFrames), "--out", directory_.path()}).finish();
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(text_of(directory_ / "letter"), "dear");
}

// What is short is written at the end only; of what is long, some is refused before.
TEST_F(ExitCodes, FiveWhenTheOutputDoesNotArrive) {
  for (const std::string command : {"eval 1+1", "protocol", "--help", "man run", "--version"}) {
    const Outcome outcome = in_shell(command + " > /dev/full");
    EXPECT_EQ(outcome.code, 5) << command;
    EXPECT_THAT(outcome.err, HasSubstr("cannot write")) << command;
  }
  EXPECT_EQ(in_shell("check none.animado --json > /dev/full").code, 3);  // went wrong before
  for (const std::string service : {"interexpserv", "egesp", "fred", "colisao"})
    EXPECT_EQ(in_shell("--messages > /dev/full", fs::path(ANIMADO_BIN_DIR) / service).code, 5) << service;
}

TEST_F(ExitCodes, AreWhatTheyAreWhenTheErrorDoesNotArrive) {
  EXPECT_EQ(in_shell("eval 1+ 2> /dev/full").code, 2);
  EXPECT_EQ(in_shell("check none.animado 2> /dev/full").code, 3);
  scene(kTwoFrames);
  EXPECT_EQ(in_shell("run scene.animado --no-pictures 2> /dev/full").code, 0);
}

TEST_F(ExitCodes, FiveWhenNoSuiteRuns) {
  const Outcome outcome = animado({"ps", "--socket-dir", directory_.path()});
  EXPECT_EQ(outcome.code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("animado run"));
}

// A build whose fred ends at once.
TEST_F(ExitCodes, FiveWhenAServiceCannotBeBroughtBackWithItsLastLines) {
  const auto programs = directory_ / "bin";
  fs::create_directory(programs);
  fs::copy(kAnimado,
           programs / "animado");  // it looks for the others beside itself, not beside a link's target
  for (const std::string name : {"interexpserv", "egesp", "colisao", "controle"}) {
    fs::create_symlink(fs::path(ANIMADO_BIN_DIR) / name, programs / name);
  }
  write_text(programs / "fred", "#!/bin/sh\necho no tableaus here\nexit 1\n");
  fs::permissions(programs / "fred", fs::perms::owner_all);
  const Outcome outcome = Command(directory_, {"run", scene(kTwoFrames)}, programs / "animado").finish();
  EXPECT_EQ(outcome.code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("fred died 5 times"));
  EXPECT_THAT(outcome.err, HasSubstr("no tableaus here"));
  EXPECT_FALSE(fs::exists(directory_ / "runs/scene"));
}

}  // namespace
}  // namespace animado::suite
