// src/interexpserv/server.cpp: its messages, in this process and over a socket of the real program.
#include "interexpserv/server.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "daemon.hpp"
#include "interexpserv/client.hpp"
#include "rpc/local_suite.hpp"
#include "rpc/manual_page.hpp"
#include "tests/error_of.hpp"

namespace animado::interexpserv {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> names_of(const std::vector<NameState>& states) {
  std::vector<std::string> names;
  for (const NameState& state : states) names.push_back(state.name);
  return names;
}

// Every test of this fixture runs twice: that a socket lies between must change nothing.
class Interexpserv : public testing::TestWithParam<bool> {
 protected:
  Interexpserv() {
    if (GetParam()) {
      daemon_.emplace();
      suite_ = std::make_unique<rpc::SocketSuite>(daemon_->connect());
    } else {
      auto local = std::make_unique<rpc::LocalSuite>();
      local->add("interexpserv", fill_table);
      suite_ = std::move(local);
    }
    client_.emplace(*suite_);
  }
  Client& client() { return *client_; }
  rpc::Suite& suite() { return *suite_; }
  rpc::Channel& channel() { return suite_->channel("interexpserv"); }

  double number(const std::string& name) { return client().get(name).values.at(0); }

  // t, then two bodies in rows of two: x x y y z z.
  std::span<double> publish_world() {
    const std::span<double> array = suite().arrays().create("run/world", {8}).values();
    publish(array, std::vector<double>{0.5, 10, 11, 20, 21, 30, 31});
    client().bind({{"t", "run/world", Type::scalar, 1, 1},
                   {"ball.position", "run/world", Type::vector, 2, 2},
                   {"cube.position", "run/world", Type::vector, 3, 2}});
    return array;
  }

 private:
  std::optional<Daemon> daemon_;
  std::unique_ptr<rpc::Suite> suite_;
  std::optional<Client> client_;
};

INSTANTIATE_TEST_SUITE_P(Way, Interexpserv, testing::Values(false, true),
                         [](const auto& way) { return way.param ? "Socket" : "InProcess"; });

TEST_P(Interexpserv, DefinesAndGets) {
  EXPECT_EQ(client().define({{"spring.k", "4*pi^2*ball.mass"}, {"Ball.Mass", "2"}}), 1);
  const NameState k = client().get("SPRING.K");
  EXPECT_EQ(k.name, "spring.k");
  EXPECT_EQ(k.text, "4*pi^2*ball.mass");
  EXPECT_EQ(k.kind, Kind::definition);
  EXPECT_EQ(k.type, Type::scalar);
  EXPECT_DOUBLE_EQ(k.values.at(0), 8 * M_PI * M_PI);
  EXPECT_EQ(client().set("ball.mass", "1"), 2);
  EXPECT_DOUBLE_EQ(number("spring.k"), 4 * M_PI * M_PI);
  EXPECT_EQ(client().get("spring.k").version, 2);
  client().set("ball.weight", "(0, -10*mass, 0)");
  EXPECT_THAT(client().get("ball.weight").values, ElementsAre(0, -10, 0));
  EXPECT_THAT(names_of(client().get_within("ball")), ElementsAre("ball.mass", "ball.weight"));
  EXPECT_EQ(client().remove({"ball.weight"}), 4);
  EXPECT_EQ(error_of([&] { client().get("ball.weight"); }).code(), Code::unknown_name);
}

TEST_P(Interexpserv, RefusesWithTheCaretAndChangesNothing) {
  client().set("ball.mass", "2");
  const Error error = error_of([&] { client().define({{"a", "1"}, {"b", "2*bal.mass"}}); });
  EXPECT_EQ(error.code(), Code::unknown_name);
  EXPECT_EQ(error.where(), "b");
  EXPECT_THAT(error.message(), HasSubstr("  2*bal.mass\n    ^"));
  EXPECT_THAT(error.remedy(), HasSubstr("`ball.mass`"));
  EXPECT_EQ(error_of([&] { client().define({{"x1", "x2"}, {"x2", "x1"}}); }).code(), Code::cycle);
  EXPECT_EQ(error_of([&] { client().set("a b", "1"); }).code(), Code::bad_params);
  EXPECT_EQ(error_of([&] { client().set("a\xff", "1"); }).code(), Code::bad_params);
  EXPECT_EQ(error_of([&] { client().set("ball.mass", "(1, 2, 3)"); }).code(), Code::type);
  EXPECT_EQ(client().changes(0).version, 1);
}

TEST_P(Interexpserv, Evaluates) {
  client().set("ball.mass", "2");
  EXPECT_THAT(client().evaluate("(mass, 2^10, -1)", "ball").values, ElementsAre(2, 1024, -1));
  EXPECT_EQ(client().evaluate("1 < 2").type, Type::boolean);
  EXPECT_TRUE(std::isinf(client().evaluate("1/0").values.at(0)));
  EXPECT_TRUE(std::isnan(client().evaluate("0/0").values.at(0)));
  EXPECT_EQ(error_of([&] { client().evaluate("1 +"); }).code(), Code::syntax);
  EXPECT_EQ(error_of([&] { client().evaluate("t"); }).code(), Code::unavailable);
  EXPECT_EQ(error_of([&] { client().evaluate(std::string(100'000, '(')); }).code(), Code::limit);
}

TEST_P(Interexpserv, TellsChangesSinceAVersion) {
  client().define({{"a", "1"}, {"b", "2*a"}, {"c", "3"}});
  const int64_t version = client().set("a", "5");
  client().remove({"c"});
  const Changes::Reply reply = client().changes(version - 1);
  EXPECT_THAT(names_of(reply.names), ElementsAre("a", "b", "c"));
  EXPECT_EQ(reply.names[2].kind, Kind::removed);
  EXPECT_EQ(reply.version, version + 1);
  EXPECT_TRUE(client().changes(reply.version).names.empty());
}

TEST_P(Interexpserv, ReadsLiveNames) {
  const std::span<double> array = publish_world();
  client().set("gap", "norm(cube.position - ball.position) + t");
  EXPECT_THAT(client().get("ball.position").values, ElementsAre(10, 20, 30));
  EXPECT_EQ(client().get("ball.position").kind, Kind::live);
  EXPECT_DOUBLE_EQ(number("gap"), std::sqrt(3.0) + 0.5);
  publish(array, std::vector<double>{1, 0, 3, 0, 4, 0, 0});
  EXPECT_EQ(number("gap"), 6);
  EXPECT_EQ(client().evaluate("position.y", "cube").values.at(0), 4);
}

TEST_P(Interexpserv, RefusesBadBindings) {
  suite().arrays().create("run/small", {3});
  const auto bind_code = [&](Bind::Bound bound) {
    return error_of([&] { client().bind({std::move(bound)}); }).code();
  };
  EXPECT_EQ(bind_code({"v", "run/none", Type::scalar, 1, 1}), Code::unknown_array);
  EXPECT_EQ(bind_code({"v", "run/small", Type::scalar, 0, 1}), Code::bad_shape);
  EXPECT_EQ(bind_code({"v", "run/small", Type::scalar, 3, 1}), Code::bad_shape);
  EXPECT_EQ(bind_code({"v", "run/small", Type::vector, 1, 1}), Code::bad_shape);
  EXPECT_EQ(bind_code({"v", "run/small", Type::vector, 1, INT64_MAX}), Code::bad_shape);
  EXPECT_EQ(bind_code({"v", "run/small", Type::vector, 1, INT64_MIN}), Code::bad_shape);
  EXPECT_EQ(bind_code({"2v", "run/small", Type::scalar, 1, 1}), Code::bad_params);
  client().set("k", "1");
  EXPECT_EQ(bind_code({"k", "run/small", Type::scalar, 1, 1}), Code::conflict);
  publish_world();
  EXPECT_EQ(error_of([&] { client().set("ball.position", "(0, 0, 0)"); }).code(), Code::conflict);
}

TEST_P(Interexpserv, ANameWithoutAValueIsListedWithoutOne) {
  client().set("wave", "sin(t)");
  const std::vector<NameState> all = client().get_within("");
  ASSERT_EQ(all.size(), 1u);
  EXPECT_TRUE(all[0].values.empty());
  EXPECT_EQ(error_of([&] { client().get("wave"); }).code(), Code::unavailable);
}

TEST_P(Interexpserv, AnArrayThatIsNeverFinishedIsToldSo) {
  const std::span<double> array = publish_world();
  store_shared(array[0], 5, std::memory_order_release);
  EXPECT_EQ(error_of([&] { client().get("t"); }).code(), Code::unavailable);
}

TEST_P(Interexpserv, NotifiesWhoWatches) {
  client().define({{"ball.mass", "2"}, {"ball.weight", "10*mass"}, {"ballast", "1"}});
  EXPECT_EQ(client().watch("Ball").version, 1);
  client().set("ballast", "2");
  client().set("ball.mass", "3");
  NameChanged::Request change;
  ASSERT_TRUE(client().wait_change(change, 10));
  EXPECT_EQ(change.name, "ball.mass");
  EXPECT_EQ(change.text, "3");
  EXPECT_THAT(change.values, ElementsAre(3));
  ASSERT_TRUE(client().wait_change(change, 10));
  EXPECT_EQ(change.name, "ball.weight");
  EXPECT_THAT(change.values, ElementsAre(30));
  client().remove({"ball.weight"});
  ASSERT_TRUE(client().wait_change(change, 10));
  EXPECT_EQ(change.kind, Kind::removed);
  client().unwatch("ball");
  client().set("ball.mass", "4");
  EXPECT_FALSE(client().wait_change(change, 0));
}

TEST_P(Interexpserv, SetsOnlyWhatIsAsExpected) {
  client().define({{"a", "1"}, {"b", "1"}});
  const int64_t version = client().get("a").version;
  client().set("b", "2", version);
  const Error late = error_of([&] { client().define({{"a", "5"}, {"c", "6"}}, {{"b", version}}); });
  EXPECT_EQ(late.code(), Code::conflict);
  EXPECT_EQ(late.where(), "b");
  EXPECT_THAT(late.message(), HasSubstr("has version 2"));
  EXPECT_EQ(number("a"), 1);
  client().set("c", "6", 0);
  EXPECT_EQ(error_of([&] { client().set("c", "7", 0); }).code(), Code::conflict);
  EXPECT_EQ(error_of([&] { client().remove({"c"}, {{"c", 1}}); }).code(), Code::conflict);
  client().remove({"c"}, {{"c", 3}});
}

TEST_P(Interexpserv, TellsTheHistoryOfAName) {
  client().set("k", "1");
  client().set("k", "2*3");
  client().remove({"k"});
  const auto history = client().history("K");
  ASSERT_EQ(history.size(), 3u);
  EXPECT_EQ(history[1].text, "2*3");
  EXPECT_EQ(history[1].version, 2);
  EXPECT_EQ(history[1].who, GetParam() ? "test" : "");
  EXPECT_THAT(history[1].time, testing::MatchesRegex("20..-..-..T..:..:..Z"));
  EXPECT_EQ(history[2].kind, Kind::removed);
  EXPECT_EQ(error_of([&] { client().history("j"); }).code(), Code::unknown_name);
}

TEST_P(Interexpserv, ASnapshotIsRestoredWholeOrNotAtAll) {
  publish_world();
  client().define({{"ball.mass", "2"}, {"spring.k", "4*pi^2*ball.mass"}});
  const Snapshot::Reply all = client().snapshot(), ball = client().snapshot("ball.*");
  EXPECT_THAT(all.names, ElementsAre("ball.mass", "spring.k"));
  EXPECT_THAT(all.texts, ElementsAre("2", "4*pi^2*ball.mass"));
  EXPECT_THAT(ball.names, ElementsAre("ball.mass"));
  client().define({{"ball.mass", "3"}, {"other", "1"}});
  EXPECT_EQ(client().restore(ball, "ball").changed, 2);  // spring.k follows
  EXPECT_EQ(number("other"), 1);
  EXPECT_EQ(client().restore(all).changed, 1);
  EXPECT_EQ(error_of([&] { client().get("other"); }).code(), Code::unknown_name);
  EXPECT_THAT(client().get("ball.position").values, ElementsAre(10, 20, 30));
  Snapshot::Reply broken = all;
  broken.texts[1] = "ball.maß";
  EXPECT_EQ(error_of([&] { client().restore(broken); }).where(), "spring.k");
  broken.texts.pop_back();
  EXPECT_EQ(error_of([&] { client().restore(broken); }).code(), Code::bad_params);
  EXPECT_EQ(client().snapshot().texts, all.texts);
}

TEST_P(Interexpserv, SharesArrays) {
  suite().arrays().create("a", {2, 3}).values()[5] = 7;
  const auto reply = channel().call<rpc::ArrayOpen>({"a"});
  EXPECT_EQ(reply.shape, (std::vector<int64_t>{2, 3}));
  const rpc::SharedArray same(channel().take_descriptor(), reply.shape, "a");
  EXPECT_EQ(same.values()[5], 7);
  channel().call<rpc::ArrayCreate>({"a", {2, 3}});  // the same again: the array that is there
  EXPECT_EQ(rpc::SharedArray(channel().take_descriptor(), {2, 3}, "a").values()[5], 7);

  EXPECT_EQ(error_of([&] { channel().call<rpc::ArrayCreate>({"a", {6}}); }).code(), Code::conflict);
  EXPECT_EQ(error_of([&] { channel().call<rpc::ArrayCreate>({"", {6}}); }).code(), Code::bad_params);
  EXPECT_EQ(error_of([&] { channel().call<rpc::ArrayCreate>({"b", {-1}}); }).code(), Code::bad_shape);
  EXPECT_EQ(error_of([&] {
              channel().call<rpc::ArrayCreate>({"b", {1 << 30, 1 << 30}});
            }).code(),
            Code::bad_shape);
  EXPECT_EQ(error_of([&] { channel().call<rpc::ArrayOpen>({"none"}); }).code(), Code::unknown_array);
  EXPECT_EQ(error_of([&] { channel().call<rpc::ArrayAdopt>({"c", {6}}); }).code(), Code::bad_params);

  suite().arrays().create("b", {0});
  ASSERT_EQ(client().arrays().size(), 2u);
  EXPECT_EQ(client().arrays()[0].name, "a");
  client().release_array("a");
  client().release_array("a");
  EXPECT_EQ(error_of([&] { channel().call<rpc::ArrayOpen>({"a"}); }).code(), Code::unknown_array);
  EXPECT_EQ(same.values()[5], 7);  // who has it mapped keeps it
}

TEST_P(Interexpserv, LimitsTheNumberOfArrays) {
  const auto create = [&](int i) {
    channel().call<rpc::ArrayCreate>({fmt::format("a{}", i), {1}});
    channel().take_descriptor();
  };
  for (int i = 0; i < 512; ++i) create(i);
  EXPECT_EQ(error_of([&] { create(512); }).code(), Code::limit);
  client().release_array("a3");
  create(512);
}

TEST_P(Interexpserv, KnowsWhoOffersWhat) {
  EXPECT_EQ(error_of([&] { channel().call<rpc::Lookup>({"egesp"}); }).code(), Code::unavailable);
  channel().call<rpc::Register>({"egesp", "/run/egesp.sock", "0.1", 42});
  const auto found = channel().call<rpc::Lookup>({"egesp"});
  EXPECT_EQ(found.socket, "/run/egesp.sock");
  EXPECT_EQ(found.pid, 42);
  const auto services = client().services();
  ASSERT_EQ(services.size(), 1u);
  EXPECT_EQ(services[0].name, "egesp");
  EXPECT_THAT(services[0].since, testing::MatchesRegex("....-..-..T..:..:..Z"));
  EXPECT_THAT(error_of([&] { channel().call<rpc::Lookup>({"egezp"}); }).remedy(), HasSubstr("egesp"));
}

// Over a socket it is tests/suite/registry_test.cpp.
TEST(InterexpservTable, AWatcherInThisProcessThatDoesNotReadIsToldSo) {
  rpc::LocalSuite suite;
  suite.add("interexpserv", fill_table);
  Client client(suite);
  client.watch("k");
  const std::string padding(1000, ' ');
  for (int i = 0; i < 500; ++i) client.set("k", std::to_string(i) + padding);
  NameChanged::Request change;
  FellBehind::Request lost;
  int64_t told = 0;
  while (client.wait_change(change = {}, 0)) ASSERT_EQ(change.sequence, ++told);
  EXPECT_LT(told, 500);
  ASSERT_TRUE(client.fell_behind(lost));
  EXPECT_EQ(lost.first_lost, told + 1);
  EXPECT_EQ(lost.sequence, 500);
  EXPECT_EQ(client.changes(lost.since).names.size(), 1u);
  client.set("k", "0");
  ASSERT_TRUE(client.wait_change(change = {}, 0));
  EXPECT_EQ(change.sequence, 501);
}

TEST(InterexpservTable, AnswersEveryMessageOfItsProtocol) {
  rpc::LocalSuite suite;
  const rpc::Service& service = suite.add("interexpserv", fill_table);
  for (const rpc::MessageCodec* codec : rpc::codecs<Messages>())
    EXPECT_TRUE(service.find(codec->name)) << codec->name;
}

// Asks until the answer is an error: what ends with a connection ends when the daemon has noticed.
template <class F>
Code code_when_gone(F ask) {
  while (true) {
    try {
      ask();
    } catch (const Error& error) {
      return error.code();
    }
  }
}

TEST(InterexpservDaemon, LeasesArraysAndWatchesEndWithTheirConnection) {
  const Daemon daemon;
  rpc::SocketSuite observer = daemon.connect();
  rpc::Channel& channel = observer.channel("interexpserv");
  {
    rpc::SocketSuite other = daemon.connect();
    other.channel("interexpserv").call<rpc::Register>({"fred", "/run/fred.sock", "0.1", 7});
    other.arrays().create("fred/array", {4});
    Client(other).watch("");
    channel.call<rpc::Lookup>({"fred"});
    channel.call<rpc::ArrayOpen>({"fred/array"});
  }
  EXPECT_EQ(code_when_gone([&] { channel.call<rpc::Lookup>({"fred"}); }), Code::unavailable);
  EXPECT_EQ(code_when_gone([&] { channel.call<rpc::ArrayOpen>({"fred/array"}); }), Code::unknown_array);
  Client(observer).set("k", "1");  // nobody is left to be told
}

TEST(InterexpservDaemon, TellsOtherConnections) {
  const Daemon daemon;
  rpc::SocketSuite watching = daemon.connect(), editing = daemon.connect();
  Client watcher(watching), editor(editing);
  watcher.watch("spring");
  editor.set("spring.k", "2");
  NameChanged::Request change;
  ASSERT_TRUE(watcher.wait_change(change, 10));
  EXPECT_EQ(change.name, "spring.k");
}

TEST(InterexpservDaemon, NamesSurviveKill) {
  Daemon daemon;
  rpc::SocketSuite suite = daemon.connect();
  Client client(suite);
  client.define({{"ball.mass", "2"}, {"spring.k", "3*ball.mass"}});
  client.set("gone", "1");
  const int64_t version = client.remove({"gone"});
  daemon.end(SIGKILL);
  daemon.start();
  EXPECT_EQ(client.get("spring.k").values.at(0), 6);
  EXPECT_EQ(client.changes(0).version, version);
  EXPECT_EQ(client.changes(version - 1).names.at(0).kind, Kind::removed);
  EXPECT_EQ(client.set("ball.mass", "5"), version + 1);
  EXPECT_EQ(client.get("spring.k").values.at(0), 15);
}

TEST(InterexpservDaemon, LiveNamesComeBackWithTheirArrays) {
  Daemon daemon;
  rpc::SocketSuite suite = daemon.connect();
  Client client(suite);
  const std::span<double> array = suite.arrays().create("run/world", {3}).values();
  client.bind({{"t", "run/world", Type::scalar, 1, 1}, {"height", "run/world", Type::scalar, 2, 1}});
  client.set("late", "t > 1");
  publish(array, std::vector<double>{2, 100});
  EXPECT_EQ(client.get("late").values.at(0), 1);
  daemon.end(SIGKILL);
  daemon.start();
  EXPECT_EQ(client.get("height").values.at(0), 100);
  publish(array, std::vector<double>{0.5, 50});
  EXPECT_EQ(client.get("late").values.at(0), 0);
  EXPECT_EQ(client.get("height").values.at(0), 50);
}

}  // namespace
}  // namespace animado::interexpserv
