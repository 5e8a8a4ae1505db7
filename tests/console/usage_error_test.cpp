// src/console/usage_error.cpp
#include "console/usage_error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

namespace animado {
namespace {

// A tool with two commands, as `animado` is.
class UsageError : public testing::Test {
 protected:
  UsageError() {
    app_.require_subcommand(1);
    CLI::App* run = app_.add_subcommand("run", "Runs");
    run->add_option("scene", scene_)->required();
    run->add_option("--out", out_);
    app_.add_subcommand("report", "Reports");
  }

  // What is said of a command line.
  std::string said(const std::string& words) {
    try {
      app_.parse(words);
    } catch (const CLI::ParseError& error) {
      const Error said = usage_error(app_, error);
      return said.message() + "; " + said.remedy();
    }
    return "accepted";
  }

  CLI::App app_{"Does things", "tool"};
  std::string scene_, out_;
};

TEST_F(UsageError, NamesTheWordThatWasMeant) {
  EXPECT_EQ(said("run a --ouy b"), "there is no option `--ouy`; did you mean `--out`?");
  EXPECT_EQ(said("rnu a"), "there is no command `rnu`; did you mean `run`?");
}

TEST_F(UsageError, TellsWhatIsTooMuchOrMissing) {
  EXPECT_EQ(said("run a b c"), "`b` is a word too many; `tool run --help` lists what there is");
  EXPECT_EQ(said("run a --colourful"),
            "there is no option `--colourful`; `tool run --help` lists what there is");
  EXPECT_EQ(said("run"), "scene is required; `tool run --help` tells how it is called");
  EXPECT_EQ(said(""), "A subcommand is required; `tool --help` tells how it is called");
}

TEST_F(UsageError, HelpIsNone) {
  testing::internal::CaptureStdout();
  try {
    app_.parse("--help");
    FAIL();
  } catch (const CLI::ParseError& error) {
    EXPECT_EQ(exit_of_parse(app_, error), 0);
  }
  EXPECT_THAT(testing::internal::GetCapturedStdout(), testing::HasSubstr("Usage: tool"));
}

}  // namespace
}  // namespace animado
