// src/console/program_manual.cpp
#include "console/program_manual.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

namespace animado {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class ProgramManual : public testing::Test {
 protected:
  ProgramManual() {
    app_.formatter(std::make_shared<ExamplesFirst>("  tool 'a-b' ~x    what it does\n\nSaid after.\n"));
    app_.add_option("file", file_, "What is read")->required()->type_name("FILE");
    app_.add_option("--depth,-d", depth_, ".5 or `more`");
    app_.add_flag("--deep", deep_, "All of it");
  }

  CLI::App app_{"Does things", "tool"};
  std::string file_;
  int depth_ = 0;
  bool deep_ = false;
};

TEST_F(ProgramManual, HelpOpensWithExamples) {
  EXPECT_THAT(app_.help(),
              StartsWith("  tool 'a-b' ~x    what it does\n\nSaid after.\n\nDoes things\nUsage: tool"));
}

TEST_F(ProgramManual, ThePageHasWhatTheHelpHas) {
  const std::string page = man_page(app_, "tool");
  EXPECT_THAT(page, StartsWith(".TH TOOL 1 "));
  EXPECT_THAT(page, HasSubstr(".SH NAME\ntool \\- Does things\n"));
  EXPECT_THAT(page, HasSubstr(".SH SYNOPSIS\n\\fBtool\\fR [\\fIOPTIONS\\fR] \\fIfile\\fR\n"));
  EXPECT_THAT(page, HasSubstr(".TP\n\\fB\\-d\\fR, \\fB\\-\\-depth\\fR \\fIINT\\fR\n"));
  EXPECT_THAT(page, HasSubstr(".TP\n\\fB\\-\\-deep\\fR\nAll of it\n"));
}

TEST_F(ProgramManual, WhatTroffWouldChangeIsWrittenByName) {
  const std::string page = man_page(app_, "tool");
  EXPECT_THAT(page, HasSubstr(".nf\n  tool \\(aqa\\-b\\(aq \\(tix    what it does\n.fi\n.PP\nSaid after.\n"));
  EXPECT_THAT(page, HasSubstr("\n\\&.5 or \\(gamore\\(ga\n"));
}

TEST_F(ProgramManual, TheSynopsisOfACommandNamesItsProgram) {
  CLI::App program("All", "suite");
  const CLI::App& command = *program.add_subcommand("run", "Runs");
  EXPECT_THAT(man_page(command, "suite-run"), HasSubstr("\\fBsuite run\\fR"));
  EXPECT_THAT(man_page(program, "suite"), HasSubstr(".SH COMMANDS\n.TP\n\\fBrun\\fR\nRuns\n"));
}

}  // namespace
}  // namespace animado
