// What a person sees in a terminal, and who sees none of it: pipes, dumb terminals, and those who set
// NO_COLOR.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command.hpp"

namespace animado::suite {
namespace {

using testing::HasSubstr;
using testing::Not;

class Terminal : public testing::Test {
 protected:
  // What the command writes to a terminal, by script(1).
  std::string in_terminal(const std::string& variables, const std::string& command) {
    const Words words = {"-c", "env -u NO_COLOR " + variables + " script -qec '" + command + "' /dev/null"};
    const Outcome outcome = Command(directory_, words, "/bin/sh").finish();
    EXPECT_EQ(outcome.code, 0) << outcome.err << outcome.out;
    return outcome.out;
  }
  std::string log_command() {
    const auto file = write_text(directory_ / "egesp.log",
                                 "2026-11-22T15:30:07.907416Z info egesp 24784#22 solve 1.8 µs ok\n");
    return kAnimado.string() + " log " + file.string();
  }
  std::string run_command() {
    return kAnimado.string() + " run " + (kSource / "scenes/colisao.animado").string() +
           " --in-process --out " + (directory_ / "run").string();
  }

  TemporaryDirectory directory_;
};

TEST_F(Terminal, ALogIsColoured) {
  EXPECT_THAT(in_terminal("TERM=xterm", log_command()), HasSubstr("\x1b["));
}

TEST_F(Terminal, NoColorAndDumbTerminalsAreHonoured) {
  for (const std::string variables : {"TERM=xterm NO_COLOR=1", "TERM=dumb"}) {
    EXPECT_THAT(in_terminal(variables, log_command()), Not(HasSubstr("\x1b"))) << variables;
    EXPECT_THAT(in_terminal(variables, log_command()), HasSubstr("24784#22 solve")) << variables;
  }
}

TEST_F(Terminal, APipeTakesALogAsItIs) {
  const Outcome outcome = Command(directory_, {"-c", log_command() + " | cat"}, "/bin/sh").finish();
  EXPECT_EQ(outcome.out, text_of(directory_ / "egesp.log"));
}

TEST_F(Terminal, ProgressIsOneLineThatIsWrittenOver) {
  const std::string seen = in_terminal("TERM=xterm", run_command());
  EXPECT_THAT(seen, HasSubstr("\r["));
  EXPECT_THAT(seen, HasSubstr("\r\x1b[K"));
  EXPECT_THAT(seen, HasSubstr("results in "));
}

TEST_F(Terminal, ADumbOneGetsPlainLines) {
  const std::string seen = in_terminal("TERM=dumb", run_command());
  EXPECT_THAT(seen, Not(HasSubstr("\x1b")));
  EXPECT_THAT(seen, Not(HasSubstr("\r[")));
  EXPECT_THAT(seen, HasSubstr("done: 12 frames of 2 bodies"));
}

TEST_F(Terminal, AFollowedLogIsWaitedForAndReadAsItGrows) {
  const auto file = directory_ / "late.log";
  Command follow(directory_, {"log", "--follow", file.string()});
  write_text(file, "first line\nsecond ");
  const auto has = [&](const std::string& text) { return [&follow, text] { return follow.out() == text; }; };
  const auto over = [&] { return !follow.running(); };
  EXPECT_TRUE(wait_until(has("first line\n"), over)) << "half a line is not told";
  write_text(file, "first line\nsecond line\n");
  EXPECT_TRUE(wait_until(has("first line\nsecond line\n"), over));
  follow.signal(SIGINT);
  follow.finish();
}

TEST_F(Terminal, ALogThatIsNotThereIsAnError) {
  const Outcome outcome = animado({"log", "nowhere.log"});
  EXPECT_EQ(outcome.code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("nowhere.log"));
}

}  // namespace
}  // namespace animado::suite
