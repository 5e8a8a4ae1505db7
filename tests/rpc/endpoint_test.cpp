// src/rpc/endpoint.cpp: folders that are ours alone, addresses that a dead process left, peers of another
// user.
#include "rpc/endpoint.hpp"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <functional>
#include <latch>
#include <thread>

#include "fixture.hpp"

namespace animado::rpc::testing {
namespace {

using EndpointTest = SocketTest;

TEST_F(EndpointTest, TheFolderIsMadeForUsAlone) {
  prepare_directory(directory_ / "a" / "run");
  EXPECT_EQ(fs::status(directory_ / "a" / "run").permissions(), fs::perms::owner_all);
  EXPECT_EQ(fs::status(directory_ / "a").permissions(), fs::perms::owner_all);
  prepare_directory(directory_ / "a" / "run");  // it may be there
}

TEST_F(EndpointTest, AFolderThatOthersCanReachIsRefused) {
  fs::create_directory(directory_ / "open");
  fs::permissions(directory_ / "open", fs::perms::owner_all | fs::perms::others_exec);
  const Error error = error_of([&] { prepare_directory(directory_ / "open"); });
  EXPECT_EQ(error.code(), Code::refused);
  EXPECT_NE(error.remedy().find("chmod 700"), std::string::npos);
  fs::create_symlink(directory_, directory_ / "link");
  EXPECT_EQ(error_of([&] { prepare_directory(directory_ / "link"); }).code(), Code::refused);
}

TEST_F(EndpointTest, AnAddressInUseIsAConflictAndADeadOneIsReplaced) {
  const fs::path socket = socket_path(directory_, kWellKnown, 0);
  UniqueFd listener = listen_at(socket);
  EXPECT_TRUE(connect_to(socket));
  EXPECT_EQ(error_of([&] { listen_at(socket); }).code(), Code::conflict);
  listener.reset();  // as a killed process leaves it
  EXPECT_TRUE(fs::exists(socket));
  EXPECT_FALSE(connect_to(socket));
  listener = listen_at(socket);
  EXPECT_TRUE(connect_to(socket));
}

TEST_F(EndpointTest, StaleSocketsOfAServiceAreRemovedAndLiveOnesKept) {
  UniqueFd live = listen_at(socket_path(directory_, "egesp", 1)),
           dead = listen_at(socket_path(directory_, "egesp", 2));
  UniqueFd other = listen_at(socket_path(directory_, "fred", 3));
  dead.reset();
  other.reset();
  remove_stale(directory_, "egesp");
  EXPECT_TRUE(fs::exists(socket_path(directory_, "egesp", 1)));
  EXPECT_FALSE(fs::exists(socket_path(directory_, "egesp", 2)));
  EXPECT_TRUE(fs::exists(socket_path(directory_, "fred", 3)));
}

// A socket that is bound and does not listen yet looks dead.
TEST_F(EndpointTest, WhoStartsIsNotClearedAwayByAnotherThatStarts) {
  std::atomic<bool> over = false;
  std::vector<std::jthread> others;
  for (int i = 0; i < 8; ++i) {
    others.emplace_back([&] {
      while (!over) remove_stale(directory_, "egesp");
    });
  }
  for (int i = 0; i < 1000; ++i) EXPECT_NO_THROW(listen_at(socket_path(directory_, "egesp", i)));
  over = true;
}

TEST_F(EndpointTest, AFolderThatIsNotThereIsNamed) {
  const fs::path folder = directory_ / "nowhere";
  for (const auto& start : std::vector<std::function<void()>>{
           [&] { listen_at(socket_path(folder, "egesp", 1)); }, [&] { remove_stale(folder, "egesp"); }}) {
    const Error error = error_of(start);
    EXPECT_EQ(error.code(), Code::refused);
    EXPECT_EQ(error.where(), folder);
    EXPECT_FALSE(error.remedy().empty());
  }
}

TEST_F(EndpointTest, OfManyThatWantOneAddressOneHasIt) {
  const fs::path socket = socket_path(directory_, kWellKnown, 0);
  for (int round = 0; round < 100; ++round) {
    std::array<UniqueFd, 2> listeners;
    std::latch ready(listeners.size());
    std::vector<std::jthread> racers;
    for (UniqueFd& listener : listeners) {
      racers.emplace_back([&] {
        ready.arrive_and_wait();
        try {
          listener = listen_at(socket);
        } catch (const Error& error) {
          EXPECT_EQ(error.code(), Code::conflict);
        }
      });
    }
    racers.clear();  // joins
    EXPECT_EQ(std::ranges::count_if(listeners, [](const UniqueFd& fd) { return bool(fd); }), 1);
  }
}

TEST_F(EndpointTest, APathTooLongForASocketNamesTheRemedy) {
  const Error error = error_of([&] { connect_to(directory_ / std::string(120, 'x')); });
  EXPECT_EQ(error.code(), Code::refused);
  EXPECT_NE(error.remedy().find("ANIMADO_SOCKET_DIR"), std::string::npos);
}

// Listens at the socket as another user in a child process while `look` runs here.
template <class F>
void as_other_user_listens(const fs::path& socket, F look) {
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t child = fork();
  if (child == 0) {
    const bool other = setuid(65534) == 0;
    const UniqueFd listener = listen_at(socket);
    const char answer = other ? 'y' : 'n';
    if (write(ready[1], &answer, 1) == 1) pause();
    _exit(0);
  }
  char answer = 'n';
  EXPECT_EQ(read(ready[0], &answer, 1), 1);
  if (answer == 'y') look();
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  close(ready[0]);
  close(ready[1]);
}

TEST_F(EndpointTest, AnotherUsersServerIsNotSpokenTo) {
  if (getuid() != 0) GTEST_SKIP() << "needs root to become another user";
  fs::permissions(directory_.path(), fs::perms::all);
  const fs::path socket = directory_ / "stranger.sock";
  as_other_user_listens(socket,
                        [&] { EXPECT_EQ(error_of([&] { connect_to(socket); }).code(), Code::refused); });
}

TEST_F(EndpointTest, AnotherUsersClientIsTurnedAway) {
  if (getuid() != 0) GTEST_SKIP() << "needs root to become another user";
  Served parrot(directory_, "parrot", fill_parrot);
  fs::permissions(directory_.path(), fs::perms::all);
  fs::permissions(parrot.socket(), fs::perms::all);
  const pid_t child = fork();
  if (child == 0) {
    char byte;
    const bool other = setuid(65534) == 0;
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, parrot.socket().c_str(), sizeof address.sun_path - 1);
    const int fd = ::socket(AF_UNIX, SOCK_STREAM, 0);
    const bool connected = ::connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    _exit(other && connected && read(fd, &byte, 1) == 0 ? 0 : 1);
  }
  int status = -1;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace animado::rpc::testing
