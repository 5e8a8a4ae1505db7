// src/interexpserv/store.cpp: what was acknowledged is there after a crash.
#include "interexpserv/store.hpp"
#include "tests/temporary_directory.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

namespace animado::interexpserv {
namespace {

class StoreTest : public testing::Test {
 protected:
  std::filesystem::path file() const { return folder_ / "names.sqlite"; }

 private:
  TemporaryDirectory folder_;
};

Names stored_names(Store& store) {
  Names names([&](int64_t version, std::span<const NameRow> rows) { store.commit(version, rows); });
  const Store::Contents contents = store.load();
  names.restore(contents.rows, contents.version);
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

TEST_F(StoreTest, TheLogTellsEveryChangeInOrder) {
  Store store(file());
  Names names = stored_names(store);
  define(names, "k", "1");
  define(names, "k2", "2*k");
  define(names, "k", "5");
  std::string story;
  for (const NameRow& row : store.log())
    story += std::to_string(row.version) + ":" + row.name + "=" + row.text + " ";
  EXPECT_EQ(story, "1:k=1 2:k2=2*k 3:k=5 3:k2=2*k ");
}

TEST_F(StoreTest, ACommitThatFailsLeavesNothing) {
  Store store(file());
  Names names = stored_names(store);
  define(names, "k", "1");
  const NameRow twice{NameRow::Kind::definition, "k", "2", Type::scalar, {}, 0};
  EXPECT_THROW(store.commit(2, std::vector<NameRow>{twice, twice}),
               Error);  // the log has one row a name and version
  EXPECT_EQ(store.load().version, 1);
  EXPECT_EQ(store.load().rows[0].text, "1");
  define(names, "k", "3");
  EXPECT_EQ(store.load().rows[0].text, "3");
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
  while (acknowledged < 20 && read(pipe_ends[0], &next, sizeof next) == sizeof next) acknowledged = next;
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  while (read(pipe_ends[0], &next, sizeof next) == sizeof next) acknowledged = next;
  close(pipe_ends[0]);

  ASSERT_GE(acknowledged, 20);
  Store store(file());
  const Store::Contents contents = store.load();
  EXPECT_GE(contents.version, acknowledged);
  EXPECT_LE(contents.version, acknowledged + 1);  // the one that was not acknowledged in time
  ASSERT_EQ(contents.rows.size(), 2u);
  EXPECT_EQ(contents.rows[0].text, std::to_string(contents.version));
  EXPECT_EQ(contents.rows[1].text, contents.rows[0].text);
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
