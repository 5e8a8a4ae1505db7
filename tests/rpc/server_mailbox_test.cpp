// src/rpc/server.cpp: clients with a mailbox, and descriptors that go with answers.
#include <gmock/gmock.h>

#include <ctime>
#include <list>

#include "raw.hpp"

namespace animado::rpc::testing {
namespace {

using ServerMailboxTest = ParrotTest;

TEST_F(ServerMailboxTest, WhatCameAsALetterIsAnsweredByOne) {
  Raw client(parrot_.socket());
  client.hello();
  EXPECT_EQ(client.open_mailbox(), R"([1,2,null,{"room":4084}])");
  Connection& connection = client.connection();
  connection.fall_asleep();
  client.send_letter(packed_of(R"([0, 3, "empty", [{}]])"));
  ASSERT_TRUE(wait_until(connection.mailbox()->bell(), POLLIN, Clock::now() + seconds(kLong_s)));
  EXPECT_TRUE(connection.has_letter());
  EXPECT_FALSE(is_readable(connection.fd()));
  EXPECT_EQ(client.receive(), R"([1,3,null,{}])");
  EXPECT_EQ(client.ask_by_letter(R"([0, 4, "emty", [{}]])").substr(0, 5), "[1,4,");
}

TEST_F(ServerMailboxTest, WhatCameOverTheSocketIsAnsweredThere) {
  Raw client(parrot_.socket());
  client.hello();
  client.open_mailbox();
  EXPECT_EQ(client.ask(R"([0, 3, "empty", [{}]])"), R"([1,3,null,{}])");
  EXPECT_FALSE(is_readable(client.connection().mailbox()->bell()));
}

TEST_F(ServerMailboxTest, AnAnswerThatIsTooLongComesOverTheSocket) {
  Raw client(parrot_.socket());
  client.hello();
  client.open_mailbox();
  EXPECT_GT(client.ask_by_letter(R"([0, 3, "describe", [{}]])").size(), Mailbox::kRoom);
  EXPECT_EQ(client.ask_by_letter(R"([0, 4, "empty", [{}]])"), R"([1,4,null,{}])");
}

TEST_F(ServerMailboxTest, NotificationsOfACallComeBeforeItsAnswer) {
  Raw client(parrot_.socket());
  client.hello();
  client.open_mailbox();
  for (int id : {3, 4, 5}) {
    EXPECT_EQ(client.ask_by_letter(fmt::format(R"([0, {}, "twice", [{{"in": [1, 2]}}]])", id)),
              R"([2,"told",[{"count":2}]])");
    EXPECT_THAT(client.receive(), HasSubstr(fmt::format("[1,{},", id)));
  }
}

TEST_F(ServerMailboxTest, AskedForTwiceItIsTheSame) {
  Raw client(parrot_.socket());
  client.hello();
  client.open_mailbox();
  client.ask_by_letter(R"([0, 3, "empty", [{}]])");
  client.open_mailbox();
  EXPECT_EQ(client.ask_by_letter(R"([0, 4, "empty", [{}]])"), R"([1,4,null,{}])");
}

// With pauses about as long as a server looks before it sleeps: a letter that it neither saw nor was rung for
// would wait for ever.
TEST_F(ServerMailboxTest, NoLetterIsMissedByWhoIsAboutToSleep) {
  Raw client(parrot_.socket());
  client.hello();
  client.open_mailbox();
  for (int i = 0; i < 4000; ++i) {
    const auto pause = std::chrono::nanoseconds(kPollFor) / 2 + std::chrono::nanoseconds(20 * i);
    const auto end = Clock::now() + pause;
    while (Clock::now() < end) {
    }
    ASSERT_EQ(client.ask_by_letter(fmt::format(R"([0, {}, "empty", [{{}}]])", 3 + i)),
              fmt::format("[1,{},null,{{}}]", 3 + i));
  }
}

TEST_F(ServerMailboxTest, WhoDidNotSpeakLastIsHeardWithoutABell) {
  Raw one(parrot_.socket()), other(parrot_.socket());
  for (Raw* client : {&one, &other}) {
    client->hello();
    client->open_mailbox();
  }
  for (int i = 0; i < 100; ++i)
    for (Raw* client : {&one, &other})
      ASSERT_EQ(client->ask_by_letter(R"([0, 3, "empty", [{}]])"), R"([1,3,null,{}])");
}

// Against the rules, and no reason to look for its end without a pause.
TEST_F(ServerMailboxTest, ALetterInTheMiddleOfAMessageKeepsNobodyBusy) {
  Raw client(parrot_.socket());
  client.hello();
  client.open_mailbox();
  const std::string message = packed_of(R"([0, 3, "empty", [{}]])");
  client.send(message.substr(0, 5));
  client.send_letter(packed_of(R"([0, 4, "empty", [{}]])"));
  const std::clock_t before = std::clock();
  EXPECT_FALSE(wait_until(client.connection().fd(), POLLIN, Clock::now() + std::chrono::milliseconds(200)));
  EXPECT_LT(std::clock() - before, CLOCKS_PER_SEC / 10);
  client.send(message.substr(5));
  EXPECT_THAT((std::array{client.receive(), client.receive()}),
              ::testing::UnorderedElementsAre(R"([1,3,null,{}])", R"([1,4,null,{}])"));
}

TEST_F(ServerMailboxTest, BytesThatAreNoMessageEndTheConnection) {
  Raw client(parrot_.socket());
  client.hello();
  client.open_mailbox();
  client.send_letter("\xc1");
  EXPECT_THAT(client.receive(), HasSubstr(R"("code":"protocol")"));
  EXPECT_EQ(client.receive(), "closed");
}

// The bell is open at the client's side for longer than the connection.
TEST_F(ServerMailboxTest, WhoRingsAfterHeLeftDisturbsNobody) {
  std::vector<UniqueFd> kept;
  {
    Raw client(parrot_.socket());
    client.hello();
    client.open_mailbox();
    kept = client.take_handed();
  }
  Raw other(parrot_.socket());
  other.hello();
  while (other.ask(R"([0, 3, "statistics", [{}]])").find(R"("connections":1)") == std::string::npos) {
  }
  Mailbox gone = Mailbox::open(std::move(kept));
  EXPECT_TRUE(gone.put("anybody?"));
  for (int i = 0; i < 100; ++i)  // a server looks at everybody now and then only
    EXPECT_EQ(other.ask(R"([0, 4, "empty", [{}]])"), R"([1,4,null,{}])");
}

TEST_F(ServerMailboxTest, WhoGetsNoneGoesOnOverTheSocket) {
  std::list<Raw> clients;
  const auto refuses = [&] { return clients.back().open_mailbox().find("limit") != std::string::npos; };
  do {
    clients.emplace_back(parrot_.socket()).hello();
  } while (clients.size() < 100 && !refuses());
  EXPECT_EQ(clients.size(), 65u);
  EXPECT_EQ(clients.back().ask_by_letter(R"([0, 3, "empty", [{}]])"), R"([1,3,null,{}])");
  clients.pop_front();
  while (refuses()) {  // until the first is seen to be gone
  }
  EXPECT_EQ(clients.back().ask_by_letter(R"([0, 4, "empty", [{}]])"), R"([1,4,null,{}])");
}

// A client may ask for more than the socket's buffers hold of answers, and read them later.
TEST_F(SocketTest, EachAnswerBringsItsDescriptorHoweverLateItIsRead) {
  constexpr int kMany = 2000;
  Served names(directory_, std::string(kWellKnown), fill_names);
  SocketSuite suite(options());
  suite.arrays().create("a", {1});
  Raw client(names.socket()), other(names.socket());
  client.hello();
  other.hello();
  std::string& out = client.connection().out();
  out += packed_of(R"([2, "array_open", [{"name": "a"}]])");  // no answer, and so no descriptor
  for (int i = 1; i <= kMany; ++i)
    out += packed_of(fmt::format(R"([0, {}, "array_open", [{{"name": "a"}}]])", i));
  while (other.ask(R"([0, 3, "statistics", [{}]])").find(R"("unsent_bytes":0)") != std::string::npos)
    ASSERT_TRUE(client.connection().flush());
  int answers = 0, descriptors = 0;
  const auto deadline = Clock::now() + seconds(kLong_s);
  while (answers < kMany && Clock::now() < deadline) {
    ASSERT_TRUE(client.connection().flush());
    ASSERT_NE(client.connection().receive_by(Clock::now() + seconds(0.01)), Connection::Received::closed);
    std::string_view message;
    for (; client.connection().next_message(message); ++answers) {
      ASSERT_THAT(json_of(message), ::testing::StartsWith(fmt::format("[1,{},null,", answers + 1)));
    }
    descriptors += static_cast<int>(client.connection().take_descriptors().size());
    ASSERT_GE(descriptors, answers);
  }
  EXPECT_EQ(answers, kMany);
  EXPECT_EQ(descriptors, kMany);
}

}  // namespace
}  // namespace animado::rpc::testing
