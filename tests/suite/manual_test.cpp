// What the programs say of themselves: --help, manual pages, and how shells complete a command line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "command.hpp"

namespace animado::suite {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsSupersetOf;

const fs::path kPrograms = ANIMADO_BIN_DIR;
const Words kDaemons = {"interexpserv", "egesp", "fred", "colisao", "controle"};

bool is_installed(const std::string& program) {
  const TemporaryDirectory directory;
  return Command(directory, {"-c", "command -v " + program}, "/bin/sh").finish().code == 0;
}

Words lines_of(const std::string& text) {
  Words lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// What bash offers for the last of the words, in the folder of the source.
Words completed(const Words& words) {
  std::string script = "cd '" + kSource.string() + "' && source <('" + kAnimado.string() +
                       "' completion bash) && COMP_WORDS=(";
  for (const std::string& word : words) script += "'" + word + "' ";
  script += ") COMP_CWORD=" + std::to_string(words.size() - 1) +
            " && _animado && printf '%s\\n' \"${COMPREPLY[@]}\"";
  const TemporaryDirectory directory;
  const Outcome outcome = Command(directory, {"--norc", "-c", script}, "/bin/bash").finish();
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  return lines_of(outcome.out);
}

Words commands() {
  return completed({"animado", ""});
}

TEST(Help, OpensWithExamples) {
  EXPECT_THAT(animado({"--help"}).out, testing::StartsWith("  animado "));
  for (const std::string& name : commands()) {
    const Outcome outcome = animado({name, "--help"});
    EXPECT_EQ(outcome.code, 0) << name;
    EXPECT_THAT(outcome.out, testing::StartsWith("  ")) << name;
    EXPECT_THAT(lines_of(outcome.out).at(0), HasSubstr("animado " + name)) << name;
  }
  const TemporaryDirectory directory;
  for (const std::string& name : kDaemons) {
    const Outcome outcome = Command(directory, {"--help"}, kPrograms / name).finish();
    EXPECT_EQ(outcome.code, 0) << name;
    EXPECT_THAT(outcome.out, testing::StartsWith("  " + name)) << name;
  }
}

TEST(Completion, OfCommandsOptionsAndWords) {
  EXPECT_THAT(commands(), IsSupersetOf({"run", "plot", "log", "completion", "man"}));
  EXPECT_EQ(completed({"animado", "pl"}), Words{"plot"});
  EXPECT_THAT(completed({"animado", "run", "--"}), IsSupersetOf({"--out", "--in-process", "--extensions"}));
  EXPECT_EQ(completed({"animado", "solve", "--method", "s"}), Words{"sparse"});
  EXPECT_EQ(completed({"animado", "plot", "runs/a", "energy", "res"}), Words{"residual"});
}

TEST(Completion, OfScenesAndFolders) {
  EXPECT_EQ(completed({"animado", "run", "scenes/coli"}), Words{"scenes/colisao.animado"});
  EXPECT_EQ(completed({"animado", "run", "--out", "scenes", "scenes/paddle"}), Words{""})
      << "paddle.csv is no scene";
  for (const std::string command : {"plot", "render", "report"})
    EXPECT_EQ(completed({"animado", command, "sce"}), Words{"scenes"}) << command;
  EXPECT_EQ(completed({"animado", "run", "--out", "sce"}), Words{"scenes"});
}

TEST(Completion, ZshReadsItsOwn) {
  if (!is_installed("zsh")) GTEST_SKIP() << "zsh is not installed";
  const TemporaryDirectory directory;
  // What zsh's own functions are handed is printed.
  const std::string script =
      "compdef() { :; }; _describe() { print -l $commands; }\n"
      "_arguments() { print -l -- \"$@\"; }\n"
      "source <('" +
      kAnimado.string() +
      "' completion zsh)\n"
      "words=(animado ''); CURRENT=2; _animado\n"
      "words=(animado run ''); CURRENT=3; _animado\n"
      "for command in ${commands%%:*}; do words=(animado $command ''); CURRENT=3; "
      "_animado >/dev/null; done\n";
  const Outcome outcome = Command(directory, {"-f", "-c", script}, "/usr/bin/zsh").finish();
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(lines_of(outcome.out),
              IsSupersetOf({"run:Simulate a scene", "*:scene:_files -g \"*.animado\"",
                            "--quiet[No progress and no report; errors are still told]"}));
}

// Keys are typed into a zsh of its own; what it shows is read until what is waited for is there.
TEST(Completion, ZshCompletesWithTab) {
  if (!is_installed("zsh")) GTEST_SKIP() << "zsh is not installed";
  const TemporaryDirectory directory;
  const std::string script =
      "zmodload zsh/zpty; zpty shell zsh -f -i\n"
      "zpty -w shell \"autoload -Uz compinit; compinit -u -d $1/dump; cd '" +
      kSource.string() + "'; source <('" + kAnimado.string() +
      "' completion zsh); print rea''dy\"\n"
      "zpty -r shell seen '*ready*'\n"
      "typed() { zpty -n -w shell $'\\x15'\"$1\"$'\\t'; zpty -r shell seen \"*$2*\"; print -- \"$2\"; }\n"
      "typed 'animado compl' 'completion'\n"
      "typed 'animado run scenes/coli' 'sao.animado'\n"
      "typed 'animado run --in-p' 'rocess'\n"
      "typed 'animado solve --method sp' 'arse'\n"
      "typed 'animado plot runs x resi' 'dual'\n";
  const Words words = {"20", "zsh", "-f", "-c", script, "zsh", directory.path()};
  const Outcome outcome = Command(directory, words, "/usr/bin/timeout").finish();
  EXPECT_EQ(outcome.code, 0) << "after " << outcome.out << outcome.err;
  EXPECT_EQ(lines_of(outcome.out), (Words{"completion", "sao.animado", "rocess", "arse", "dual"}));
}

void expect_clean(const std::string& page, const std::string& name) {
  const TemporaryDirectory directory;
  const fs::path file = write_text(directory / "page.1", page);
  if (is_installed("groff")) {
    const Words groff = {"-c", "groff -ww -man -Kutf8 -Tutf8 -z " + file.string()};
    EXPECT_EQ(Command(directory, groff, "/bin/sh").finish().err, "") << name;
  }
  if (is_installed("mandoc")) {
    // It wants a date, which would make each build another one.
    const Words mandoc = {"-c", "mandoc -Tlint -Wwarning " + file.string() + " | grep -v 'missing date'"};
    EXPECT_EQ(Command(directory, mandoc, "/bin/sh").finish().out, "") << name;
  }
}

TEST(ManualPages, AreCleanAndHoldTheExamples) {
  if (!is_installed("groff") && !is_installed("mandoc")) GTEST_SKIP() << "neither groff nor mandoc is here";
  expect_clean(animado({"man"}).out, "animado");
  for (const std::string& name : commands()) expect_clean(animado({"man", name}).out, name);
  const TemporaryDirectory directory;
  for (const std::string& name : kDaemons)
    expect_clean(Command(directory, {"--man"}, kPrograms / name).finish().out, name);
  EXPECT_THAT(animado({"man", "run"}).out, HasSubstr("animado run scenes/colisao.animado"));
  EXPECT_THAT(animado({"man", "run"}).out, HasSubstr("\\fB\\-\\-in\\-process\\fR"));
}

TEST(ManualPages, AreWrittenAsFiles) {
  const TemporaryDirectory directory;
  EXPECT_EQ(animado({"man", "--all", (directory / "man1").string()}).code, 0);
  EXPECT_EQ(text_of(directory / "man1/animado-run.1"), animado({"man", "run"}).out);
  EXPECT_EQ(text_of(directory / "man1/animado.1"), animado({"man"}).out);
  EXPECT_EQ(animado({"man", "nothing"}).code, 2);
}

}  // namespace
}  // namespace animado::suite
