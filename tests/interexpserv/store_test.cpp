// src/interexpserv/store.cpp: what was acknowledged is there after a crash.
#include "interexpserv/store.hpp"
#include "tests/temporary_directory.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "base/error.hpp"
#include "interexpserv/names.hpp"

namespace animado::interexpserv {
namespace {

class StoreTest : public testing::Test {
 protected:
  std::filesystem::path file() const { return folder_ / "names.sqlite"; }

 private:
  TemporaryDirectory folder_;
};

Names stored_names(Store& store) {
  Names names([&](std::span<const NamedRevision> revisions) { store.commit(revisions); });
  names.load(store.load());
  return names;
}

void define(Names& names, const std::string& name, const std::string& text) {
  names.define(std::vector<NamedText>{{name, text}});
}

TEST_F(StoreTest, KeepsNamesAndVersions) {
  std::vector<NameRow> before;
  {
    Store store(file());
    Names names = stored_names(store);
    EXPECT_EQ(names.version(), 0);
    define(names, "ball.mass", "2");
    names.bind(std::vector<NamedBinding>{{"ball.position", Type::vector, {"run/state", 3, 7}}});
    define(names, "weight", "(0, -9.81*ball.mass, 0)");
    define(names, "high", "ball.position.y > 1");
    define(names, "gone", "1");
    names.remove(std::vector<std::string>{"gone"});
    define(names, "ball.mass", "3");
    before = names.rows("");
  }
  Store store(file());
  const Names names = stored_names(store);
  EXPECT_EQ(names.version(), 7);
  EXPECT_EQ(names.rows(""), before);
  EXPECT_EQ(names.changes(5).front().kind, NameRow::Kind::removed);
  EXPECT_EQ(names.row("ball.position").binding, (Binding{"run/state", 3, 7}));
}

TEST_F(StoreTest, KeepsTheHistoryOfANameAndForgetsWhatIsOlder) {
  std::vector<Revision> history;
  {
    Store store(file());
    Names names = stored_names(store);
    for (int i = 0; i < 3000; ++i) define(names, "k", std::to_string(i));
    define(names, "rare", "1");
    history = names.history("k");
  }
  Store store(file());
  const Names names = stored_names(store);
  EXPECT_EQ(names.history("k"), history);
  EXPECT_EQ(names.version(), 3001);
  EXPECT_EQ(store.load().size(), kRevisionsKept + 1);
}

TEST_F(StoreTest, OneProcessAtATime) {
  const Store store(file());
  EXPECT_THROW(Store{file()}, Error);
}

// The disk is full: as far as a file may grow, and not a byte more.
TEST_F(StoreTest, ACommitThatFailsLeavesNothing) {
  Store store(file());
  Names names = stored_names(store);
  define(names, "k", "1");
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit full{std::filesystem::file_size(file().string() + ".journal") + 10, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &full);
  EXPECT_THROW(define(names, "k", "2"), Error);
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(names.row("k").text, "1");
  define(names, "k", "3");
  const std::vector<NamedRevision> kept = store.load();
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_EQ(kept[0].revision.text, "1");
  EXPECT_EQ(kept[1].revision.text, "3");
}

// A child commits without end, acknowledges each version over a pipe and is killed at once.
TEST_F(StoreTest, SurvivesKill) {
  int pipe_ends[2];
  ASSERT_EQ(pipe(pipe_ends), 0);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    Store store(file());
    Names names = stored_names(store);
    for (int64_t i = 1;; ++i) {
      names.define(std::vector<NamedText>{{"a", std::to_string(i)}, {"b", std::to_string(i)}});
      if (write(pipe_ends[1], &i, sizeof i) != sizeof i) _exit(1);
    }
  }
  close(pipe_ends[1]);
  int64_t acknowledged = 0, next = 0;
  while (acknowledged < 2500 && read(pipe_ends[0], &next, sizeof next) == sizeof next) acknowledged = next;
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  while (read(pipe_ends[0], &next, sizeof next) == sizeof next) acknowledged = next;
  close(pipe_ends[0]);

  ASSERT_GE(acknowledged, 2500);  // some in SQLite, some in the journal
  Store store(file());
  const Names names = stored_names(store);
  EXPECT_GE(names.version(), acknowledged);
  EXPECT_LE(names.version(), acknowledged + 1);  // the one that was not acknowledged in time
  EXPECT_EQ(names.size(), 2u);
  EXPECT_EQ(names.row("a").text, std::to_string(names.version()));
  EXPECT_EQ(names.row("b").text, names.row("a").text);
}

TEST_F(StoreTest, RefusesWhatIsNoDatabase) {
  std::ofstream(file()) << std::string(5000, 'x');
  try {
    Store store(file());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::refused);
    EXPECT_EQ(error.where(), file().string());
  }
}

TEST_F(StoreTest, SaysWhereItCannotWrite) {
  try {
    Store store("/nowhere/names.sqlite");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::unavailable);
    EXPECT_EQ(error.where(), "/nowhere/names.sqlite");
  }
}

}  // namespace
}  // namespace animado::interexpserv
