// animado integrate and the examples of docs/fred.md, as a user runs them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "command.hpp"
#include "services.hpp"

namespace animado::suite {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// Away from whatever suite this machine runs, which may be about to end.
class IntegrateCommand : public testing::Test {
 protected:
  IntegrateCommand() { setenv("ANIMADO_SOCKET_DIR", (nowhere_ / "none").c_str(), 1); }
  ~IntegrateCommand() override { unsetenv("ANIMADO_SOCKET_DIR"); }

 private:
  TemporaryDirectory nowhere_;
};

TEST_F(IntegrateCommand, PrintsATable) {
  const Outcome outcome =
      animado({"integrate", "x' = v; v' = -x", "--from", "x=1, v=0", "--until", "pi", "--samples", "2"});
  EXPECT_EQ(outcome.code, 2) << "--until takes a number";
  const Outcome good = animado({"integrate", "x' = v; v' = -k*x", "--from", "x=1, v=0", "--with", "k=4*pi^2",
                                "--until", "1", "--samples", "2"});
  EXPECT_EQ(good.code, 0) << good.err;
  EXPECT_THAT(good.out,
              testing::MatchesRegex(" *t +x +v\n *0 +1 +0\n *0.5 +-(1|0.999999).*\n *1 +(1|0.999999).*\n"));
}

TEST_F(IntegrateCommand, DrawsWithoutColoursIntoAPipe) {
  const Outcome outcome =
      animado({"integrate", "x' = v; v' = -x", "--from", "x=1, v=0", "--until", "10", "--plot"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("⡀"));
  EXPECT_THAT(outcome.out, testing::Not(HasSubstr("\x1b")));
  EXPECT_EQ(outcome.err, "");
}

TEST_F(IntegrateCommand, WritesCsvAndStopsAtAnEvent) {
  const TemporaryDirectory directory;
  const fs::path file = directory / "fall.csv";
  const Outcome outcome = animado({"integrate", "y' = v; v' = -9.81", "--from", "y=10, v=0", "--until", "9",
                                   "--stop", "y = 0", "--csv", file.string()});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("y = 0 at t = 1.4278431229"));
  EXPECT_THAT(text_of(file), testing::StartsWith("t,y,v\n0,10,0\n"));
}

TEST_F(IntegrateCommand, SaysWhereItCouldNotGoOn) {
  const Outcome outcome = animado({"integrate", "y' = y^2", "--from", "y=1", "--until", "2"});
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("singular"));
  EXPECT_EQ(animado({"integrate", "y = 1", "--from", "y=1", "--until", "2"}).code, 2);
}

TEST(IntegrateExamples, InPythonAndShell) {
  Services services;
  const TemporaryDirectory directory;
  const Outcome python =
      Command(directory, {kSource / "docs/examples/integrate.py", services.socket("interexpserv")},
              "/usr/bin/python3")
          .finish();
  EXPECT_EQ(python.code, 0) << python.err;
  EXPECT_EQ(python.out, "event: after 1 s at x = 3 m\n");
  const std::string path = std::string(ANIMADO_BIN_DIR) + ":" + std::getenv("PATH");
  const Outcome shell =
      Command(directory, {"PATH=" + path, kSource / "docs/examples/integrate.sh", services.directory()},
              "/usr/bin/env")
          .finish();
  EXPECT_EQ(shell.code, 0) << shell.err;
  EXPECT_NEAR(nlohmann::json::parse(shell.out).at("state").at(0).get<double>(), 2.718281828459045, 1e-10);
}

TEST(IntegrateExamples, NamesOfTheRegistryMayBeUsed) {
  Services services;
  const auto directory = services.directory().string();
  ASSERT_EQ(animado({"set", "spring.k", "5", "--socket-dir", directory}).code, 0);
  const Outcome outcome = animado({"integrate", "x' = spring.k*m", "--from", "x=0", "--with", "m=2",
                                   "--until", "1", "--samples", "1", "--socket-dir", directory});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("10"));
}

// Each line of the page's block of commands does what it says: it ends well.
TEST(FredPage, ItsCommandsRun) {
  const std::string text = text_of(kSource / "docs/fred.md"), opening = "```sh\n";
  const size_t begin = text.find(opening) + opening.size();
  const std::string block = text.substr(begin, text.find("```", begin) - begin);
  const TemporaryDirectory directory;
  const std::string script = "set -e\nexport ANIMADO_SOCKET_DIR=$PWD/none PATH='" +
                             std::string(ANIMADO_BIN_DIR) + "':$PATH\n" + block;
  const Outcome outcome = Command(directory, {"-c", script}, "/bin/sh").finish();
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(std::count(block.begin(), block.end(), '\n'), 5);
}

}  // namespace
}  // namespace animado::suite
