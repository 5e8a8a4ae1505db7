// INTEREXPSERV under several clients at once, over real sockets: who watches misses nothing, who does not
// read is told so, one of two who set the same wins, replicas take turns.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <list>
#include <set>
#include <thread>

#include "command.hpp"
#include "interexpserv/client.hpp"
#include "services.hpp"

namespace animado::suite {
namespace {

using namespace interexpserv;

class RegistryOfSuite : public testing::Test {
 protected:
  rpc::SocketSuite connect(const std::string& client = "test") {
    return rpc::SocketSuite({.directory = services_.directory(), .client = client, .trace = client});
  }
  Outcome command(Words words) {
    words.insert(words.end(), {"--socket-dir", services_.directory()});
    return animado(words);
  }

  Services services_;
};

TEST_F(RegistryOfSuite, AWatcherIsToldEveryChangeOfSeveralWritersInOrder) {
  constexpr int kWriters = 3, kChanges = 400;
  rpc::SocketSuite watching = connect();
  Client watcher(watching);
  const int64_t first = watcher.watch("race.*").sequence + 1;
  std::vector<std::thread> writers;
  for (int writer = 0; writer < kWriters; ++writer) {
    writers.emplace_back([this, writer] {
      rpc::SocketSuite suite = connect();
      std::vector<Set::Request> requests;
      for (int i = 0; i < kChanges; ++i)
        requests.push_back({fmt::format("race.lane{}", writer), std::to_string(i), {}});
      const bool pipelined = writer == 0;
      if (pipelined) suite.channel("interexpserv").call_all<Set>(requests);
      for (const Set::Request& request : pipelined ? std::vector<Set::Request>{} : requests)
        Client(suite).set(request.name, request.text);
    });
  }
  std::map<std::string, int> seen;
  NameChanged::Request change;
  for (int64_t sequence = first; sequence < first + kWriters * kChanges; ++sequence) {
    ASSERT_TRUE(watcher.wait_change(change = {}, 10)) << "at " << sequence;
    ASSERT_EQ(change.sequence, sequence);
    ASSERT_EQ(change.text, std::to_string(seen[change.name]++)) << change.name;
  }
  for (std::thread& writer : writers) writer.join();
  EXPECT_EQ(seen.size(), static_cast<size_t>(kWriters));
  FellBehind::Request lost;
  EXPECT_FALSE(watcher.fell_behind(lost));
}

TEST_F(RegistryOfSuite, AWatcherThatDoesNotReadIsToldWhatItLostAndTheOthersLoseNothing) {
  rpc::SocketSuite deaf_suite = connect(), good_suite = connect(), editing = connect();
  Client deaf(deaf_suite), good(good_suite), editor(editing);
  const int64_t begin = deaf.watch("").sequence;
  good.watch("");
  const std::string padding(1000,
                            ' ');  // a kilobyte a change: it takes a thousand to fill what is kept for one
  constexpr int kChanges = 2000;
  NameChanged::Request change;
  for (int i = 0; i < kChanges; ++i) {
    editor.set("k", std::to_string(i) + padding);
    ASSERT_TRUE(good.wait_change(change = {}, 10));
    ASSERT_EQ(change.sequence, begin + 1 + i);
  }
  int64_t told = 0;
  FellBehind::Request lost;
  // Either may come next, and to wait for one does not end when the other comes.
  for (int looks = 0; !deaf.fell_behind(lost, 0.01); ++looks) {
    ASSERT_LT(looks, 1000) << "neither told nor told that it was not";
    while (deaf.wait_change(change = {}, 0)) ASSERT_EQ(change.sequence, begin + ++told);
  }
  while (deaf.wait_change(change = {}, 0)) EXPECT_EQ(change.sequence, begin + ++told);
  EXPECT_LT(told, kChanges);
  EXPECT_EQ(lost.first_lost, begin + told + 1);
  EXPECT_EQ(lost.sequence, begin + kChanges);
  const Changes::Reply now = deaf.changes(lost.since);
  ASSERT_EQ(now.names.size(), 1u);
  EXPECT_EQ(now.names[0].text, std::to_string(kChanges - 1) + padding);
  editor.set("k", "0");
  ASSERT_TRUE(deaf.wait_change(change = {}, 10));  // and from here on as before
  EXPECT_EQ(change.sequence, begin + kChanges + 1);
  EXPECT_GT(change.version, now.version);
}

TEST_F(RegistryOfSuite, OfTwoWhoSetTheSameVersionOneWins) {
  constexpr int kEach = 150;
  Client(services_.suite()).set("counter", "0");
  const auto count_up = [this](std::string name) {
    rpc::SocketSuite suite = connect(name);
    Client client(suite);
    for (int done = 0; done < kEach;) {
      const NameState now = client.get("counter");
      try {
        client.set("counter", std::to_string(std::stoi(now.text) + 1), now.version);
        ++done;
      } catch (const Error& error) {
        ASSERT_EQ(error.code(), Code::conflict);
        ASSERT_EQ(error.where(), "counter");
      }
    }
  };
  std::thread one(count_up, "one"), two(count_up, "two");
  one.join();
  two.join();
  Client client(services_.suite());
  EXPECT_EQ(client.get("counter").text, std::to_string(2 * kEach));
  const auto history = client.history("counter");
  ASSERT_EQ(history.size(), 16u);
  for (size_t i = 1; i < history.size(); ++i)
    EXPECT_EQ(std::stoi(history[i].text), std::stoi(history[i - 1].text) + 1);
  EXPECT_THAT(history.back().who, testing::AnyOf("one", "two"));
}

TEST_F(RegistryOfSuite, ReplicasTakeTurnsAndADeadOneIsNotFound) {
  const std::string program = std::string(ANIMADO_BIN_DIR) + "/egesp";
  std::vector<Child> replicas;
  for (int i = 0; i < 2; ++i) {
    replicas.emplace_back(std::vector<std::string>{program, "--socket-dir", services_.directory()},
                          services_.directory() / "replica.output");
  }
  Client client(services_.suite());
  const auto of_egesp = [&] {
    std::multiset<int64_t> pids;
    for (const auto& service : client.services()) {
      if (service.name == "egesp") pids.insert(service.pid);
    }
    return pids;
  };
  const auto has_ended = [](const Child& child) { return child.wait(0); };
  ASSERT_TRUE(wait_until([&] { return of_egesp().size() == 3; },
                         [&] { return std::ranges::any_of(replicas, has_ended); }))
      << "a replica ended: " << text_of(services_.directory() / "replica.output");
  // Three that look it up get three servers, and stay with them.
  std::list<rpc::SocketSuite> users;
  std::multiset<int64_t> pids;
  for (int i = 0; i < 3; ++i) {
    users.emplace_back(connect());
    pids.insert(users.back().channel("egesp").call<rpc::Statistics>({}).pid);
  }
  EXPECT_EQ(pids, of_egesp());

  const pid_t victim = replicas[0].pid();
  ASSERT_EQ(kill(victim, SIGKILL), 0);
  ASSERT_TRUE(wait_until([&] { return of_egesp().size() == 2; }, [&] { return has_ended(replicas[1]); }));
  EXPECT_FALSE(of_egesp().contains(victim));
  for (int i = 0; i < 6; ++i) EXPECT_NE(client.lookup("egesp").pid, victim);
  for (rpc::SocketSuite& user : users) EXPECT_NE(user.channel("egesp").call<rpc::Statistics>({}).pid, victim);
}

TEST_F(RegistryOfSuite, TopShowsEachReplicaAndHowBusyItIs) {
  const Child replica({std::string(ANIMADO_BIN_DIR) + "/fred", "--socket-dir", services_.directory()},
                      services_.directory() / "replica.output");
  const auto rows = [&] {
    const Outcome outcome = command({"top", "--json", "--every", "0.02"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out);
  };
  ASSERT_TRUE(wait_until([&] { return rows().size() == 5; }, [&] { return replica.wait(0); }));
  for (const auto& row : rows()) {
    EXPECT_GE(row.at("busy"), 0.0);
    EXPECT_LE(row.at("busy"), 1.0);
    EXPECT_LE(row.at("p50_us"), row.at("p99_us"));
    EXPECT_GT(row.at("p99_us"), 0.0);
    EXPECT_GT(row.at("requests_per_s"), 0.0);  // the look itself
    EXPECT_GE(row.at("connections"), 1);
  }
  const Outcome table = command({"top", "--once", "--every", "0.02"});
  EXPECT_THAT(table.out, testing::StartsWith("SERVICE "));
  EXPECT_EQ(std::ranges::count(table.out, '\n'), 6);
  EXPECT_EQ(table.out.find('\x1b'), std::string::npos);
}

TEST_F(RegistryOfSuite, RestartsOfANameAreCounted) {
  const auto restarts = [&] { return Client(services_.suite()).services().at(0).restarts; };
  EXPECT_EQ(restarts(), 0);  // colisao, the first by name
  services_.restart("colisao", SIGKILL);
  EXPECT_EQ(restarts(), 1);
}

TEST_F(RegistryOfSuite, ASnapshotIsAFileThatRestoreBringsBack) {
  const TemporaryDirectory directory;
  const std::string file = directory / "names.txt";
  ASSERT_EQ(command({"set", "ball.mass", "2", "spring.k", "4*pi^2*\n ball.mass"}).code, 0);
  ASSERT_EQ(command({"snapshot", file}).code, 0);
  EXPECT_EQ(text_of(file), "# animado names, version 1\nball.mass = 2\nspring.k = 4*pi^2*\n     ball.mass\n");
  ASSERT_EQ(command({"set", "ball.mass", "3", "late", "1"}).code, 0);
  const Outcome outcome = command({"restore", file});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "3 names changed\n");  // ball.mass, spring.k, which needs it, and late
  EXPECT_THAT(command({"snapshot"}).out,
              testing::HasSubstr("ball.mass = 2\nspring.k = 4*pi^2*\n     ball.mass\n"));
  EXPECT_EQ(command({"get", "late"}).code, 2);
  write_text(file, "ball.mass = 5\nspring.k 3\n");
  const Outcome wrong = command({"restore", file});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, testing::HasSubstr("names.txt:2"));
  EXPECT_EQ(command({"get", "ball.mass"}).out, "2\n");
}

TEST_F(RegistryOfSuite, SetTakesTheVersionThatIsExpected) {
  ASSERT_EQ(command({"set", "k", "1", "--if-version", "0"}).code, 0);
  const auto state = nlohmann::json::parse(command({"get", "k", "--json"}).out);
  ASSERT_EQ(command({"set", "k", "2", "--if-version", state.at("version").dump()}).code, 0);
  const Outcome late = command({"set", "k", "3", "--if-version", state.at("version").dump()});
  EXPECT_EQ(late.code, 2);
  EXPECT_THAT(late.err, testing::HasSubstr("`k` has version 2, last changed by animado; 1 was expected"));
  EXPECT_EQ(command({"get", "k"}).out, "2\n");
  EXPECT_THAT(command({"get", "k", "--history"}).out,
              testing::ContainsRegex("T.*Z +1 animado +k = 1\n.*T.*Z +2 animado +k = 2\n"));
}

TEST_F(RegistryOfSuite, WatchOnTheCommandLineTellsANamespace) {
  ASSERT_EQ(command({"set", "ball.mass", "1", "ballast", "7"}).code, 0);
  const TemporaryDirectory directory;
  Command watch(directory, {"watch", "ball.*", "--count", "3", "--socket-dir", services_.directory()});
  ASSERT_TRUE(wait_until([&] { return watch.out() == "ball.mass = 1\n"; }, [&] { return !watch.running(); }));
  Client(services_.suite()).define({{"ball.mass", "2"}, {"ball.weight", "10*mass"}});
  const Outcome outcome = watch.finish();
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "ball.mass = 1\nball.mass = 2\nball.weight = 20\n");
}

}  // namespace
}  // namespace animado::suite
