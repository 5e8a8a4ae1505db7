// src/rpc/connection.cpp: both ends, without a server or a channel.
#include <gmock/gmock.h>
#include <sys/socket.h>

#include <algorithm>

#include "raw.hpp"

namespace animado::rpc::testing {
namespace {

// Both ends of a connection with a mailbox.
struct Ends {
  Ends() {
    int both[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, both) != 0) throw std::runtime_error("no pair");
    server.emplace(UniqueFd(both[0]));
    client.emplace(UniqueFd(both[1]));
    Mailbox mailbox = Mailbox::make();
    client->use(Mailbox::open(copies(mailbox.descriptors())), Connection::Waits::here);
    server->use(std::move(mailbox), Connection::Waits::elsewhere);
  }
  std::optional<Connection> server, client;
};

std::string next(Connection& connection) {
  std::string_view message;
  return connection.next_message(message) ? json_of(message) : "nothing";
}

TEST(ConnectionEnds, AnAnswerIsALetterAndWhatFollowsItIsNot) {
  Ends ends;
  ends.client->out() = packed_of("1");
  ends.client->call_by_letter();
  ends.client->flush();
  EXPECT_EQ(ends.server->receive(), Connection::Received::bytes);
  EXPECT_EQ(next(*ends.server), "1");
  ends.server->out() = packed_of("2");
  ends.server->flush();
  EXPECT_TRUE(ends.client->has_letter());
  EXPECT_EQ(ends.client->receive(), Connection::Received::bytes);
  EXPECT_EQ(next(*ends.client), "2");
  for (Connection* end : {&*ends.server, &*ends.client}) {
    end->out() = packed_of("3");
    end->flush();
  }
  EXPECT_FALSE(ends.client->has_letter());
  EXPECT_FALSE(ends.server->has_letter());
  EXPECT_EQ(ends.client->receive(), Connection::Received::bytes);
  EXPECT_EQ(next(*ends.client), "3");
}

TEST(ConnectionEnds, WhatHasBegunToGoOverTheSocketEndsThere) {
  Ends ends;
  const int small = 1;  // the kernel rounds it up to what sends such messages in two pieces
  setsockopt(ends.server->fd(), SOL_SOCKET, SO_SNDBUF, &small, sizeof small);
  const std::string message = packed_of('"' + std::string(4000, 'x') + '"');
  ASSERT_LT(message.size(), Mailbox::kRoom);
  while (ends.server->unsent() == 0) {
    ends.server->out() += message;
    ends.server->flush();
  }
  for (char taken; ends.server->unsent() == message.size(); ends.server->flush())
    ASSERT_EQ(recv(ends.client->fd(), &taken, 1, 0), 1);
  ASSERT_GT(ends.server->unsent(), 0u);
  ends.server->call_by_letter();
  ends.server->flush();
  EXPECT_FALSE(ends.client->has_letter());
}

TEST(ConnectionEnds, ALetterWaitsUntilTheMessageBeforeItIsWhole) {
  Ends ends;
  const auto begin = Clock::now();
  const std::string text = packed_of(R"("over the socket")");
  ends.server->out() = text.substr(0, 4);
  ends.server->flush();
  EXPECT_EQ(ends.client->receive_by(begin + seconds(kLong_s)), Connection::Received::bytes);
  EXPECT_EQ(next(*ends.client), "nothing");
  ends.server->out() = packed_of("1");
  ends.server->call_by_letter();
  ends.server->flush();
  EXPECT_FALSE(ends.client->has_letter()) << "that could be taken now";
  EXPECT_EQ(ends.client->receive_by(Clock::now()), Connection::Received::nothing);
  ends.server->out() = text.substr(4);
  ends.server->flush();
  EXPECT_EQ(ends.client->receive_by(begin + seconds(kLong_s)), Connection::Received::bytes);
  EXPECT_EQ(next(*ends.client), R"("over the socket")");
  EXPECT_EQ(ends.client->receive_by(begin + seconds(kLong_s)), Connection::Received::bytes);
  EXPECT_EQ(next(*ends.client), "1");
  EXPECT_LT(Clock::now() - begin, seconds(kLong_s / 2)) << "nobody waited for a bell that had been heard";
}

TEST(ConnectionEnds, WhoWaitsForALetterHearsThatThePeerIsGone) {
  Ends ends;
  const auto begin = Clock::now();
  ends.server.reset();
  EXPECT_EQ(ends.client->receive_by(begin + seconds(kLong_s)), Connection::Received::closed);
  EXPECT_LT(Clock::now() - begin, seconds(kLong_s / 2));
}

TEST(ConnectionEnds, DescriptorsComeWithTheBytesThatTheyWereGivenFor) {
  int both[2];
  ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, both), 0);
  Connection from{UniqueFd(both[0])}, to(UniqueFd(both[1]), Descriptors::taken);
  const std::string before = packed_of('"' + std::string(40000, 'x') + '"');
  for (; from.unsent() == 0; from.flush()) from.out() += before;
  from.out() += before;
  from.attach(std::array{from.fd(), from.fd()});
  from.out() += packed_of("1") + packed_of("2");
  std::string last;
  while (last != "2") {
    ASSERT_TRUE(from.flush());
    ASSERT_EQ(to.receive(), Connection::Received::bytes);
    std::vector<std::string> came;
    for (std::string text = next(to); text != "nothing"; text = next(to)) came.push_back(text);
    const bool with = std::ranges::count(came, "1") > 0;
    EXPECT_EQ(to.take_descriptors().size(), with ? 2u : 0u);
    if (!came.empty()) last = came.back();
  }
}

}  // namespace
}  // namespace animado::rpc::testing
