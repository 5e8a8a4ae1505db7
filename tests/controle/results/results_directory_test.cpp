// src/controle/results/results_directory.cpp
#include "controle/results/results_directory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.hpp"
#include "tests/temporary_directory.hpp"

namespace animado::controle {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

std::vector<std::string> names_in(const fs::path& directory) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory))
    names.push_back(entry.path().filename());
  return names;
}

void write_results(const ResultsDirectory& results, const std::string& content) {
  write_text(results.path() / "states.csv", content);
  write_text(results.path() / "summary.json", "{}");
}

// The pid of a process that is no more, and which has left what a crash leaves.
pid_t crash_with_results_at(const fs::path& final_path) {
  const pid_t child = ::fork();
  if (child == 0) {
    const ResultsDirectory results(final_path);
    write_text(results.logs() / "fred.log", "the last words\n");
    ::_exit(0);
  }
  ::waitpid(child, nullptr, 0);
  return child;
}

TEST(ResultsDirectory, IsNotThereBeforeTheCommit) {
  const TemporaryDirectory directory;
  ResultsDirectory results(directory.path() / "runs" / "top");
  write_results(results, "whole");
  EXPECT_FALSE(fs::exists(results.final_path()));
  results.commit();
  EXPECT_EQ(text_of(directory.path() / "runs/top/states.csv"), "whole");
  EXPECT_THAT(names_in(directory.path() / "runs"), ElementsAre("top"));
}

TEST(ResultsDirectory, OpenLogsMoveWithIt) {
  const TemporaryDirectory directory;
  ResultsDirectory results(directory.path() / "top");
  write_results(results, "");
  std::ofstream log(results.logs() / "egesp.log");
  log << "before" << std::flush;
  results.commit();
  log << " and after" << std::flush;
  EXPECT_EQ(text_of(directory.path() / "top/logs/egesp.log"), "before and after");
}

TEST(ResultsDirectory, ReplacesOlderResultsWhole) {
  const TemporaryDirectory directory;
  for (const std::string content : {"old", "new"}) {
    ResultsDirectory results(directory.path() / "top");
    write_results(results, content);
    if (content == "old") write_text(results.path() / "only-old", "");
    results.commit();
  }
  EXPECT_EQ(text_of(directory.path() / "top/states.csv"), "new");
  EXPECT_THAT(names_in(directory.path() / "top"), UnorderedElementsAre("states.csv", "summary.json", "logs"));
  EXPECT_THAT(names_in(directory.path()), ElementsAre("top"));
}

TEST(ResultsDirectory, ACrashLeavesOldResultsAndReadableLogs) {
  const TemporaryDirectory directory;
  ResultsDirectory old(directory.path() / "top");
  write_results(old, "old");
  old.commit();
  const pid_t dead = crash_with_results_at(directory.path() / "top");
  EXPECT_EQ(text_of(directory.path() / "top/states.csv"), "old");
  const fs::path partial = directory.path() / (".top.partial-" + std::to_string(dead));
  EXPECT_EQ(text_of(partial / "logs/fred.log"), "the last words\n");
}

TEST(ResultsDirectory, TheNextRunClearsUpAfterTheDeadAlone) {
  const TemporaryDirectory directory;
  crash_with_results_at(directory.path() / "top");
  crash_with_results_at(directory.path() / "other");
  const std::string alive = ".top.partial-1";  // init lives
  fs::create_directory(directory.path() / alive);
  ASSERT_EQ(names_in(directory.path()).size(), 3u);
  const ResultsDirectory results(directory.path() / "top");
  const std::vector<std::string> left = names_in(directory.path());
  EXPECT_THAT(left, testing::SizeIs(3));
  EXPECT_THAT(left, testing::Contains(alive));
  EXPECT_THAT(left, testing::Contains(results.path().filename().string()));
  EXPECT_THAT(left, testing::Contains(testing::StartsWith(".other.partial-")));
}

TEST(ResultsDirectory, NeverReplacesWhatIsNotResults) {
  const TemporaryDirectory directory;
  const fs::path home = directory.path() / "home";
  fs::create_directory(home);
  EXPECT_NO_THROW(ResultsDirectory{home});  // empty: nothing to lose
  write_text(home / "thesis.tex", "years of work");
  try {
    const ResultsDirectory results(home);
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::refused);
    EXPECT_EQ(error.where(), home.string());
  }
  write_text(directory.path() / "file", "");
  EXPECT_THROW(ResultsDirectory{directory.path() / "file"}, Error);
}

TEST(ResultsDirectory, LooksAgainBeforeItReplaces) {
  const TemporaryDirectory directory;
  ResultsDirectory results(directory.path() / "top");
  write_results(results, "");
  fs::create_directory(directory.path() / "top");
  write_text(directory.path() / "top/thesis.tex", "written while the run went");
  EXPECT_THROW(results.commit(), Error);
  EXPECT_TRUE(fs::exists(directory.path() / "top/thesis.tex"));
}

TEST(ResultsDirectory, ASlashAtTheEndDoesNotMatter) {
  const TemporaryDirectory directory;
  const ResultsDirectory results(directory.path().string() + "/top/");
  EXPECT_EQ(results.final_path(), directory.path() / "top");
}

TEST(ResultsDirectory, ALinkKeepsPointingToTheResults) {
  const TemporaryDirectory directory;
  fs::create_directory(directory.path() / "disk");
  fs::create_directory_symlink(directory.path() / "disk", directory.path() / "link");
  ResultsDirectory results(directory.path() / "link");
  write_results(results, "whole");
  results.commit();
  EXPECT_TRUE(fs::is_symlink(directory.path() / "link"));
  EXPECT_EQ(text_of(directory.path() / "disk/states.csv"), "whole");
}

TEST(ResultsDirectory, APlaceThatCannotBeWrittenIsAnError) {
  const TemporaryDirectory directory;
  write_text(directory.path() / "file", "");
  try {
    const ResultsDirectory results(directory.path() / "file" / "top");
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::unavailable);
  }
}

}  // namespace
}  // namespace animado::controle
