// report.html as a user gets it: with each run that does not decline it, and again from the results.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/suite/command.hpp"

namespace animado::suite {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const std::string kBouncingBall = ANIMADO_SOURCE_DIR "/scenes/bouncing_ball.animado";

class Report : public testing::Test {
 protected:
  Outcome run(const Words& options = {}) {
    Words words = {"run", kBouncingBall, "--in-process", "--quiet", "--out", results};
    words.insert(words.end(), options.begin(), options.end());
    return animado(words);
  }

  TemporaryDirectory directory;
  const std::string results = directory / "ball";
  const std::string page = results + "/report.html";
};

#if ANIMADO_WEB
TEST_F(Report, ComesWithARun) {
  EXPECT_EQ(run().code, 0);
  EXPECT_THAT(text_of(page), testing::StartsWith("<!doctype html>"));
}

TEST_F(Report, IsMadeAgainFromTheResults) {
  ASSERT_EQ(run().code, 0);
  const std::string first = text_of(page);
  fs::remove(page);
  const Outcome outcome = animado({"report", results});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr(page));
  EXPECT_EQ(text_of(page).size(), first.size());
}
#endif

TEST_F(Report, CanBeDeclined) {
  EXPECT_EQ(run({"--no-pictures"}).code, 0);
  EXPECT_TRUE(fs::exists(results + "/states.csv"));
  EXPECT_FALSE(fs::exists(page));
}

TEST_F(Report, OfAFolderWithoutResultsIsAMistakeInTheCommand) {
  const Outcome outcome = animado({"report", directory.path()});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("error: "));
  EXPECT_TRUE(fs::is_empty(directory.path()));
}

TEST_F(Report, OfDamagedResultsSaysWhereTheyAre) {
  ASSERT_EQ(run({"--no-pictures"}).code, 0);
  write_text(results + "/frames.csv", "nothing\n");
  const Outcome outcome = animado({"report", results});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_FALSE(fs::exists(page));
#if ANIMADO_WEB
  EXPECT_THAT(outcome.err, HasSubstr("frames.csv"));
#endif
}

}  // namespace
}  // namespace animado::suite
