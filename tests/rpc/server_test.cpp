// src/rpc/server.cpp, connection.cpp, wire.cpp: what a client that is not ours may send, byte by byte.
#include <gmock/gmock.h>
#include <poll.h>
#include <sys/socket.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "raw.hpp"
#include "rpc/one_core.hpp"

namespace animado::rpc::testing {
namespace {

using ServerTest = ParrotTest;

TEST_F(ServerTest, SpeaksMessagePackRpc) {
  Raw raw(parrot_.socket());
  raw.hello();
  EXPECT_EQ(raw.ask(R"([0, 7, "empty", [{}]])"), R"([1,7,null,{}])");
  EXPECT_EQ(raw.ask(R"([0, 8, "empty", []])"), R"([1,8,null,{}])");
  EXPECT_EQ(raw.ask(R"([0, 9, "twice", [{"in": [1, 2], "_trace": "ab", "_seq": 4}]])"),
            R"([2,"told",[{"count":2}]])");
  EXPECT_EQ(raw.receive(), R"([1,9,null,{"out":{"shape":[2],"data":[2.0,4.0]}}])");
}

TEST_F(ServerTest, HelloComesFirstAndInTheRightVersion) {
  Raw raw(parrot_.socket());
  EXPECT_THAT(raw.ask(R"([0, 1, "empty", [{}]])"), HasSubstr(R"("code":"protocol")"));
  EXPECT_THAT(raw.ask(R"([0, 2, "hello", [{"protocol": "animado", "version": 99}]])"),
              HasSubstr("version 99 is not spoken here"));
  EXPECT_THAT(raw.ask(R"([0, 3, "hello", [{"protocol": "gopher", "version": 1}]])"),
              HasSubstr(R"("code":"protocol")"));
  raw.hello();
}

TEST_F(ServerTest, BadRequestsAreAnsweredAndTheConnectionGoesOn) {
  Raw raw(parrot_.socket());
  raw.hello();
  EXPECT_THAT(raw.ask(R"([0, 2, "emty", [{}]])"), HasSubstr("did you mean 'empty'?"));
  EXPECT_THAT(raw.ask(R"([0, 3, "echo", [{"count": "x"}]])"), HasSubstr(R"("where":"echo.count")"));
  EXPECT_THAT(raw.ask(R"([0, 4, "fail", [{"bug": true}]])"), HasSubstr("vector out of range"));
  EXPECT_THAT(raw.ask(R"([0, 5, "echo", [[1]]])"), HasSubstr("bad_params"));
  EXPECT_EQ(raw.ask(R"([0, 6, "empty", [{}]])"), R"([1,6,null,{}])");
}

TEST_F(ServerTest, WhatIsNotMessagePackRpcEndsTheConnectionAndNothingElse) {
  for (const char* json :
       {"1", "[]", "[0]", R"([0, 5, "empty"])", R"([9, 5, "empty", [{}]])", R"([1, 5, null, {}])",
        R"({"a": 1})", R"([0, 5, 6, [{}]])", R"([0, 5, "empty", {}])", R"([0, 5, "empty", [{}, {}]])",
        R"([0, "x", "empty", [{}]])"}) {
    Raw raw(parrot_.socket());
    raw.hello();
    EXPECT_THAT(raw.ask(json), HasSubstr(R"("code":"protocol")")) << json;
    EXPECT_EQ(raw.receive(), "closed") << json;
  }
  Raw(parrot_.socket()).hello();
}

TEST_F(ServerTest, ALengthOfAGibibyteIsRefusedAtOnce) {
  Raw raw(parrot_.socket());
  raw.hello();
  // [0, 42, "echo", [{"label": a text of 0x40000000 bytes
  raw.send(
      "\x94\x00\x2a\xa4"
      "echo\x91\x81\xa5"
      "label\xdb\x40\x00\x00\x00"s);
  const std::string reply = raw.receive();
  EXPECT_THAT(reply, ::testing::StartsWith("[1,42,"));
  EXPECT_THAT(reply, HasSubstr(R"("code":"limit")"));
  EXPECT_EQ(raw.receive(), "closed");
}

TEST_F(ServerTest, ARequestMayComeByteByByteAndManyAtOnce) {
  Raw raw(parrot_.socket());
  raw.hello();
  const std::string request = packed_of(R"([0, 7, "empty", [{}]])");
  for (char byte : request) raw.send({&byte, 1});
  EXPECT_EQ(raw.receive(), R"([1,7,null,{}])");
  std::string many;
  for (int i = 0; i < 1000; ++i) many += request;
  raw.send(many);
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(raw.receive(), R"([1,7,null,{}])");
}

TEST_F(ServerTest, ClientsAreServedSideBySide) {
  std::vector<std::unique_ptr<Raw>> clients;
  for (int i = 0; i < 20; ++i) clients.push_back(std::make_unique<Raw>(parrot_.socket()));
  for (auto& client : clients) client->hello();
  clients[3].reset();  // in mid-conversation
  clients[5]->send(packed_of(R"([0, 7, "empty", [{}]])").substr(0, 5));
  clients[5].reset();  // in mid-message
  for (auto& client : clients) {
    if (!client) continue;
    EXPECT_EQ(client->ask(R"([0, 7, "empty", [{}]])"), R"([1,7,null,{}])");
  }
}

// On one core a server does not look before it sleeps.
class OneCoreServerTest : public SocketTest {
 protected:
  OneCore core_;
  Served parrot_{directory_, "parrot", fill_parrot};
};

TEST_F(OneCoreServerTest, WhoSpeaksAloneForLongDoesNotStopTheOthers) {
  constexpr int kLongAlone = 20;
  const auto ask = [](Raw& raw) { EXPECT_EQ(raw.ask(R"([0, 7, "empty", [{}]])"), R"([1,7,null,{}])"); };
  std::optional<Raw> talker(parrot_.socket());
  talker->hello();
  for (int i = 0; i < kLongAlone; ++i) ask(*talker);
  Raw newcomer(parrot_.socket());
  newcomer.hello();
  for (int i = 0; i < kLongAlone; ++i) ask(*talker);
  ask(newcomer);
  for (int i = 0; i < kLongAlone; ++i) ask(*talker);
  talker.reset();
  ask(newcomer);
}

TEST_F(ServerTest, AClientThatDoesNotReadDoesNotStopTheOthers) {
  Raw deaf(parrot_.socket());
  deaf.hello();
  std::string label(60000, 'x');
  const std::string request =
      packed_of(fmt::format(R"([0, 7, "echo", [{{"count": 1, "label": "{}"}}]])", label));
  for (int i = 0; i < 40; ++i) deaf.send(request);
  Raw other(parrot_.socket());
  other.hello();
  EXPECT_EQ(other.ask(R"([0, 7, "empty", [{}]])"), R"([1,7,null,{}])");
  for (int i = 0; i < 40; ++i) EXPECT_THAT(deaf.receive(), ::testing::StartsWith("[1,7,null"));
}

TEST_F(ServerTest, ALargeMessageGoesBothWays) {
  SocketSuite suite(options());
  Served names(directory_, "interexpserv", fill_names);
  std::vector<double> values(1 << 20, 0.25);
  const auto reply = suite.channel("parrot").call<Twice>({Array::inlined({1 << 20}, values), {}});
  EXPECT_EQ(reply.out.values, std::vector<double>(1 << 20, 0.5));
}

TEST_F(ServerTest, EachMessageLeavesALine) {
  {
    Served crow(directory_, "crow", fill_parrot);
    Raw raw(crow.socket());
    raw.ask(R"([0, 1, "hello", [{"protocol": "animado", "version": 1, "trace": "7f3a"}]])");
    raw.ask(R"([0, 2, "echo", [{"count": 3, "_seq": 12}]])");
    raw.ask(R"([0, 3, "fail", [{"bug": false}]])");
    raw.ask(R"([0, 4, "no\nsuch", [{}]])");
  }
  std::ifstream file(directory_ / "crow.log");
  const std::string log(std::istreambuf_iterator<char>(file), {});
  const std::string time = R"(20..-..-..T..:..:..\.......Z )";
  EXPECT_THAT(log, ::testing::ContainsRegex(
                       time + R"(info crow 7f3a#12 echo flag=false count=3 ratio=0.5 .* [0-9.]+ µs ok)"));
  EXPECT_THAT(log, ::testing::ContainsRegex(
                       time + R"(warning crow 7f3a#3 fail bug=false [0-9.]+ µs refused: fail.bug: no)"));
  EXPECT_THAT(log, HasSubstr("no?such 0.0 µs unknown_method"));
}

// Each of these ends without a word; the time since the last word is nobody's work.
TEST_F(ServerTest, IsNotBusyWhileNobodyAsks) {
  Raw raw(parrot_.socket());
  raw.hello();
  for (int i = 0; i < 2000; ++i) connect_to(parrot_.socket());
  const auto reply = nlohmann::json::parse(raw.ask(R"([0, 9, "statistics", [{}]])")).at(3);
  EXPECT_LT(reply.at("busy_s").get<double>(), reply.at("up_s").get<double>());
}

}  // namespace
}  // namespace animado::rpc::testing
