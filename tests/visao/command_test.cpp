// visao and `animado render` as a user runs them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shell.hpp"
#include "visao/picture.hpp"

namespace animado::visao {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class VisaoCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    directory_ = new TemporaryDirectory;
    const Outcome run = simulate("colisao", *directory_ / "run");
    ASSERT_EQ(run.code, 0) << run.err;
  }
  static void TearDownTestSuite() { delete directory_; }

  static Outcome visao(const std::string& options) {
    return shell(kPrograms + "visao '" + (*directory_ / "run").string() + "' " + options);
  }
  static fs::path file(const std::string& name) { return *directory_ / name; }

  static inline TemporaryDirectory* directory_ = nullptr;
};

TEST_F(VisaoCommand, MakesASheetBesideTheResultsAndNamesIt) {
  const Outcome outcome = visao("--size 320");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, (file("run") / "sheet.png").string() + "\n");
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(read_png(file("run") / "sheet.png").size().width_px, 320);
}

TEST_F(VisaoCommand, RenderIsTheSameCommand) {
  ASSERT_EQ(visao("--size 320 --camera top --frames 2,5 --quiet --output " + file("a.png").string()).code, 0);
  const Outcome outcome =
      shell(kPrograms + "animado render '" + file("run").string() +
            "' --size 320 --camera top --frames 2,5 --quiet --output " + file("b.png").string());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(text_of(file("a.png")), text_of(file("b.png"))) << "and its bytes are the same each time";
}

TEST_F(VisaoCommand, CamerasDiffer) {
  std::vector<std::string> pictures;
  for (const std::string camera : {"three-quarter", "front", "side", "top", "'(9, 2, 9)'"}) {
    const Outcome outcome =
        visao("--size 200x150 --frames 1 --camera " + camera + " --output " + file("c.png").string());
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(read_png(file("c.png")).size().height_px, 150);
    pictures.push_back(text_of(file("c.png")));
  }
  std::ranges::sort(pictures);
  EXPECT_EQ(std::ranges::adjacent_find(pictures), pictures.end());
}

TEST_F(VisaoCommand, HelpOpensWithExamplesUnderTheNameThatWasCalled) {
  EXPECT_THAT(shell(kPrograms + "visao --help").out, testing::StartsWith("  visao "));
  const Outcome outcome = shell(kPrograms + "animado render --help");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, testing::StartsWith("  animado render "));
}

TEST_F(VisaoCommand, TwoForWhatMakesNoSense) {
  EXPECT_EQ(shell(kPrograms + "visao").code, 2);
  EXPECT_EQ(shell(kPrograms + "visao /nowhere").code, 2);
  for (const std::string options : {"--size 12", "--size 1x1", "--size big", "--frames 1,99",
                                    "--camera nowhere", "--look-at 3", "--fly"}) {
    const Outcome outcome = visao(options);
    EXPECT_EQ(outcome.code, 2) << options;
    EXPECT_NE(outcome.err, "") << options;
  }
  const Outcome outcome = shell("PATH=/nowhere " + kPrograms + "visao '" + file("run").string() + "' --mp4");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("apt-get install ffmpeg"));
  EXPECT_THAT(outcome.err, testing::Not(HasSubstr("\x1b"))) << "no colours in a file";
}

// ffmpeg's place is taken by a program that asks for an interruption when it has its first bytes.
TEST_F(VisaoCommand, AnInterruptedFilmLeavesNothing) {
  fs::create_directory(file("bin"));
  const fs::path script = write_text(file("bin") / "ffmpeg",
                                     "#!/bin/sh\n/usr/bin/head -c 1000 > /dev/null\nkill -INT $PPID\n"
                                     "exec /bin/cat > /dev/null\n");
  fs::permissions(script, fs::perms::owner_all);
  const Outcome outcome = shell("PATH=" + file("bin").string() + " " + kPrograms + "visao '" +
                                file("run").string() + "' --mp4 --size 64x64 --quiet");
  EXPECT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_FALSE(fs::exists(file("run") / "film.mp4"));
  for (const auto& entry : fs::directory_iterator(file("run"))) {
    EXPECT_THAT(entry.path().filename().string(), testing::Not(HasSubstr("partial")));
  }
}

TEST(Run, LeavesASheetUnlessItIsToldNotTo) {
  const TemporaryDirectory directory;
  const std::string run =
      kPrograms + "animado run " + kScenes + "colisao.animado --quiet --out " + (directory / "run").string();
  ASSERT_EQ(shell(run).code, 0);
  EXPECT_GT(read_png(directory / "run" / "sheet.png").size().width_px, 1000);
  ASSERT_EQ(shell(run + " --no-pictures").code, 0);
  EXPECT_FALSE(fs::exists(directory / "run" / "sheet.png"));
}

// A build whose visao fails: the numbers are there, and what became of the picture is told.
TEST(Run, APictureThatFailsSpoilsNoRun) {
  const TemporaryDirectory directory;
  const fs::path programs = directory / "bin";
  fs::create_directory(programs);
  fs::copy(kPrograms + "animado", programs / "animado");  // it looks for visao beside itself
  const std::string run = (programs / "animado").string() + " run " + kScenes +
                          "colisao.animado --in-process --quiet --out " + (directory / "run").string();
  const Outcome without = shell(run);
  EXPECT_EQ(without.code, 0);
  EXPECT_THAT(without.err, HasSubstr("scripts/build release programs"));
  const fs::path visao = write_text(programs / "visao", "#!/bin/sh\necho blind >&2\nexit 2\n");
  fs::permissions(visao, fs::perms::owner_all);
  const Outcome failing = shell(run);
  EXPECT_EQ(failing.code, 0);
  EXPECT_THAT(failing.err, HasSubstr("blind"));
  EXPECT_THAT(failing.err, HasSubstr("animado render"));
  EXPECT_TRUE(fs::exists(directory / "run" / "summary.json"));
}

}  // namespace
}  // namespace animado::visao
