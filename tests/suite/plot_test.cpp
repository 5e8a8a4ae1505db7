// animado plot, on a run of the paper's example.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command.hpp"

namespace animado::suite {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class PlotCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    directory_ = new TemporaryDirectory;
    const auto scene = std::filesystem::path(ANIMADO_SOURCE_DIR) / "scenes/colisao.animado";
    ASSERT_EQ(animado({"run", scene, "--in-process", "--quiet", "--out", run()}).code, 0);
  }
  static void TearDownTestSuite() { delete directory_; }

  static std::string run() { return (*directory_ / "run").string(); }
  static std::string file(const char* name) { return (*directory_ / name).string(); }

 private:
  static inline TemporaryDirectory* directory_ = nullptr;
};

TEST_F(PlotCommand, DrawsInTextWithoutColoursIntoAPipe) {
  const Outcome outcome = animado({"plot", run(), "energy", "cubo.y"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("energy (J)\n"));
  EXPECT_THAT(outcome.out, HasSubstr("position (m)\n"));
  EXPECT_THAT(outcome.out, HasSubstr("⠉"));
  EXPECT_THAT(outcome.out, testing::Not(HasSubstr("\x1b")));
}

TEST_F(PlotCommand, WritesPicturesAndTables) {
  EXPECT_EQ(animado({"plot", run(), "esfera.y", "-o", file("a.svg"), "--csv", file("a.csv")}).code, 0);
  EXPECT_THAT(text_of(file("a.svg")), StartsWith("<?xml"));
  EXPECT_THAT(text_of(file("a.csv")), StartsWith("time_s,esfera.y\n0,3\n"));
  EXPECT_EQ(animado({"plot", run(), "-o", file("a.png")}).code, 0);
  EXPECT_THAT(text_of(file("a.png")), StartsWith("\x89PNG"));
}

TEST_F(PlotCommand, SaysWhatIsWrong) {
  const Outcome misspelt = animado({"plot", run(), "cubo.yy"});
  EXPECT_NE(misspelt.code, 0);
  EXPECT_THAT(misspelt.err, HasSubstr("is it 'cubo.y'?"));
  const Outcome nowhere = animado({"plot", "no-run"});
  EXPECT_NE(nowhere.code, 0);
  EXPECT_THAT(nowhere.err, HasSubstr("no-run"));
}

}  // namespace
}  // namespace animado::suite
