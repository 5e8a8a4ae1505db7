// src/rpc/mailbox.cpp and who uses it: letters between a client and a server, and what goes over the socket
// all the same.
#include <gmock/gmock.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>

#include <algorithm>
#include <cstring>

#include "fixture.hpp"
#include "rpc/encoder.hpp"
#include "rpc/json.hpp"
#include "rpc/wire.hpp"

namespace animado::rpc::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double kLong_s = 30;

std::vector<UniqueFd> copies(std::span<const int> descriptors) {
  std::vector<UniqueFd> copied;
  for (int fd : descriptors) copied.emplace_back(dup(fd));
  return copied;
}

bool rings(int bell) {
  pollfd entry{bell, POLLIN, 0};
  return poll(&entry, 1, 0) == 1;
}

std::string taken(Mailbox& mailbox) {
  std::string letter(Mailbox::kRoom, '\0');
  letter.resize(mailbox.take(letter.data()).value());
  return letter;
}

struct Pair {
  Mailbox server = Mailbox::make(), client = Mailbox::open(copies(server.descriptors()));
};

TEST(Mailbox, LettersGoBothWays) {
  Pair pair;
  EXPECT_FALSE(pair.server.has_letter());
  EXPECT_FALSE(rings(pair.server.bell()));
  EXPECT_TRUE(pair.client.put("what"));
  EXPECT_TRUE(rings(pair.server.bell()));
  EXPECT_FALSE(rings(pair.client.bell()));
  EXPECT_TRUE(pair.server.has_letter());
  EXPECT_FALSE(pair.client.has_letter());
  EXPECT_EQ(taken(pair.server), "what");
  EXPECT_FALSE(pair.server.has_letter());
  EXPECT_TRUE(pair.server.put("that"));
  EXPECT_TRUE(rings(pair.client.bell()));
  EXPECT_EQ(taken(pair.client), "that");
}

TEST(Mailbox, ALetterThatIsTooLongIsNotPut) {
  Pair pair;
  const std::string full(Mailbox::kRoom, 'x');
  EXPECT_FALSE(pair.client.put(full + "x"));
  EXPECT_FALSE(pair.server.has_letter());
  EXPECT_TRUE(pair.client.put(full));
  EXPECT_EQ(taken(pair.server), full);
}

TEST(Mailbox, ASizeThatCannotBeIsNotBelieved) {
  Pair pair;
  auto* pages = static_cast<uint32_t*>(
      mmap(nullptr, 8192, PROT_READ | PROT_WRITE, MAP_SHARED, pair.server.descriptors()[0], 0));
  ASSERT_NE(pages, MAP_FAILED);
  pages[1] = Mailbox::kRoom + 1;
  pages[0] = 1;
  EXPECT_TRUE(pair.server.has_letter());
  std::string letter(Mailbox::kRoom, '\0');
  EXPECT_FALSE(pair.server.take(letter.data()).has_value());
  munmap(pages, 8192);
}

TEST(Mailbox, IsOpenedFromThreeDescriptorsOfOneOnly) {
  const Mailbox server = Mailbox::make();
  EXPECT_EQ(error_of([&] { Mailbox::open({}); }).code(), Code::bad_shape);
  EXPECT_EQ(error_of([&] { Mailbox::open(copies(std::array{0, 1, 2})); }).code(), Code::bad_shape);
}

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

TEST(MailboxEnds, AnAnswerIsALetterAndWhatFollowsItIsNot) {
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

TEST(MailboxEnds, WhatHasBegunToGoOverTheSocketEndsThere) {
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

TEST(MailboxEnds, ALetterWaitsUntilTheMessageBeforeItIsWhole) {
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
  EXPECT_TRUE(ends.client->has_letter());
  EXPECT_EQ(ends.client->receive_by(begin + seconds(kLong_s)), Connection::Received::nothing);  // the bell
  ends.server->out() = text.substr(4);
  ends.server->flush();
  EXPECT_EQ(ends.client->receive_by(begin + seconds(kLong_s)), Connection::Received::bytes);
  EXPECT_EQ(next(*ends.client), R"("over the socket")");
  EXPECT_EQ(ends.client->receive_by(begin + seconds(kLong_s)), Connection::Received::bytes);
  EXPECT_EQ(next(*ends.client), "1");
  EXPECT_LT(Clock::now() - begin, seconds(kLong_s / 2)) << "nobody waited for a bell that had been heard";
}

TEST(MailboxEnds, WhoWaitsForALetterHearsThatThePeerIsGone) {
  Ends ends;
  const auto begin = Clock::now();
  ends.server.reset();
  EXPECT_EQ(ends.client->receive_by(begin + seconds(kLong_s)), Connection::Received::closed);
  EXPECT_LT(Clock::now() - begin, seconds(kLong_s / 2));
}

// A client, message by message, that sees which way each came.
class Client {
 public:
  explicit Client(const fs::path& socket) : connection_(connect_to(socket), Descriptors::taken) {
    EXPECT_THAT(ask(R"([0, 1, "hello", [{"protocol": "animado", "version": 1}]])"), HasSubstr("pid"));
  }

  std::string open_mailbox() {
    const std::string answer = ask(R"([0, 2, "mailbox", [{}]])");
    auto descriptors = connection_.take_descriptors();
    for (const UniqueFd& fd : descriptors) kept_.emplace_back(dup(fd.get()));
    if (!descriptors.empty()) connection_.use(Mailbox::open(std::move(descriptors)), Connection::Waits::here);
    return answer;
  }

  std::string ask(std::string_view json) {
    connection_.out() += packed_of(json);
    return send_and_receive();
  }
  std::string ask_by_letter(std::string_view json) {
    connection_.call_by_letter();
    return ask(json);
  }
  std::string send_and_receive() {
    EXPECT_TRUE(connection_.flush());
    return receive();
  }
  std::string receive() {
    const auto deadline = Clock::now() + seconds(kLong_s);
    std::string_view message;
    while (!connection_.next_message(message)) {
      if (connection_.receive_by(deadline) == Connection::Received::closed) return "closed";
      if (Clock::now() > deadline) return "nothing";
    }
    return json_of(message);
  }
  Connection& connection() { return connection_; }
  const std::vector<UniqueFd>& kept() const { return kept_; }  // copies of the mailbox's descriptors

 private:
  Connection connection_;
  std::vector<UniqueFd> kept_;
};

bool readable(int fd) {
  pollfd entry{fd, POLLIN, 0};
  return poll(&entry, 1, 0) == 1;
}

class MailboxTest : public SocketTest {
 protected:
  Served parrot_{directory_, "parrot", fill_parrot};
};

TEST_F(MailboxTest, WhatCameAsALetterIsAnsweredByOne) {
  Client client(parrot_.socket());
  EXPECT_EQ(client.open_mailbox(), R"([1,2,null,{"room":4088}])");
  Connection& connection = client.connection();
  connection.out() += packed_of(R"([0, 3, "empty", [{}]])");
  connection.call_by_letter();
  ASSERT_TRUE(connection.flush());
  pollfd bell{connection.mailbox()->bell(), POLLIN, 0};
  ASSERT_EQ(poll(&bell, 1, 30000), 1);
  EXPECT_TRUE(connection.has_letter());
  EXPECT_FALSE(readable(connection.fd()));
  EXPECT_EQ(client.receive(), R"([1,3,null,{}])");
  EXPECT_EQ(client.ask_by_letter(R"([0, 4, "emty", [{}]])").substr(0, 5), "[1,4,");
}

TEST_F(MailboxTest, WhatCameOverTheSocketIsAnsweredThere) {
  Client client(parrot_.socket());
  client.open_mailbox();
  EXPECT_EQ(client.ask(R"([0, 3, "empty", [{}]])"), R"([1,3,null,{}])");
  EXPECT_FALSE(rings(client.connection().mailbox()->bell()));
}

TEST_F(MailboxTest, AnAnswerThatIsTooLongComesOverTheSocket) {
  Client client(parrot_.socket());
  client.open_mailbox();
  EXPECT_GT(client.ask_by_letter(R"([0, 3, "describe", [{}]])").size(), Mailbox::kRoom);
  EXPECT_EQ(client.ask_by_letter(R"([0, 4, "empty", [{}]])"), R"([1,4,null,{}])");
}

TEST_F(MailboxTest, NotificationsOfACallComeBeforeItsAnswer) {
  Client client(parrot_.socket());
  client.open_mailbox();
  for (int id : {3, 4, 5}) {
    EXPECT_EQ(client.ask_by_letter(fmt::format(R"([0, {}, "twice", [{{"in": [1, 2]}}]])", id)),
              R"([2,"told",[{"count":2}]])");
    EXPECT_THAT(client.receive(), HasSubstr(fmt::format("[1,{},", id)));
  }
}

TEST_F(MailboxTest, AskedForTwiceItIsTheSame) {
  Client client(parrot_.socket());
  client.open_mailbox();
  client.ask_by_letter(R"([0, 3, "empty", [{}]])");
  client.open_mailbox();
  EXPECT_EQ(client.ask_by_letter(R"([0, 4, "empty", [{}]])"), R"([1,4,null,{}])");
}

TEST_F(MailboxTest, BytesThatAreNoMessageEndTheConnection) {
  Client client(parrot_.socket());
  client.open_mailbox();
  client.connection().out() = "\xc1";
  client.connection().call_by_letter();
  EXPECT_THAT(client.send_and_receive(), HasSubstr(R"("code":"protocol")"));
  EXPECT_EQ(client.receive(), "closed");
}

// The bell is open at the client's side for longer than the connection.
TEST_F(MailboxTest, WhoRingsAfterHeLeftDisturbsNobody) {
  std::vector<UniqueFd> kept;
  {
    Client client(parrot_.socket());
    client.open_mailbox();
    for (const UniqueFd& fd : client.kept()) kept.emplace_back(dup(fd.get()));
  }
  Client other(parrot_.socket());
  while (other.ask(R"([0, 3, "statistics", [{}]])").find(R"("connections":1)") == std::string::npos) {
  }
  Mailbox gone = Mailbox::open(std::move(kept));
  EXPECT_TRUE(gone.put("anybody?"));
  for (int i = 0; i < 100; ++i)  // a server looks at everybody now and then only
    EXPECT_EQ(other.ask(R"([0, 4, "empty", [{}]])"), R"([1,4,null,{}])");
}

TEST_F(MailboxTest, WhoGetsNoneGoesOnOverTheSocket) {
  std::list<Client> clients;
  while (clients.emplace_back(parrot_.socket()).open_mailbox().find("limit") == std::string::npos)
    ASSERT_LT(clients.size(), 100u);
  EXPECT_EQ(clients.size(), 65u);
  EXPECT_EQ(clients.back().ask_by_letter(R"([0, 3, "empty", [{}]])"), R"([1,3,null,{}])");
  clients.pop_front();
  while (clients.back().open_mailbox().find("limit") !=
         std::string::npos) {  // until the first is seen to be gone
  }
  EXPECT_EQ(clients.back().ask_by_letter(R"([0, 4, "empty", [{}]])"), R"([1,4,null,{}])");
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

// A client may ask for more than the socket's buffers hold of answers, and read them later.
TEST_F(SocketTest, EachAnswerBringsItsDescriptorHoweverLateItIsRead) {
  constexpr int kMany = 2000;
  Served names(directory_, std::string(kWellKnown), fill_names);
  SocketSuite suite(options());
  suite.arrays().create("a", {1});
  Client client(names.socket()), other(names.socket());
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

// A server of one client, which answers whatever it is asked with an empty map, and remembers how it was
// asked.
class Listener {
 public:
  // refusal: what who asks for a mailbox is told.
  explicit Listener(const fs::path& socket, std::optional<Code> refusal = {})
      : listener_(listen_at(socket)), refusal_(refusal), thread_([this] { serve(); }) {}
  ~Listener() { thread_.join(); }
  // Once the client is gone: how many requests came, and which of them as letters.
  const std::vector<bool>& letters() {
    thread_.join();
    thread_ = std::thread([] {});
    return letters_;
  }

 private:
  void serve() {
    wait_until(listener_.get(), POLLIN, Clock::now() + seconds(kLong_s));
    Connection client(UniqueFd(accept4(listener_.get(), nullptr, nullptr, SOCK_NONBLOCK)));
    bool letter = false;
    for (;;) {
      std::string_view message;
      while (client.next_message(message)) {
        letters_.push_back(letter);
        answer(client, message);
      }
      pollfd both[] = {{client.fd(), POLLIN, 0},
                       {client.mailbox() ? client.mailbox()->bell() : -1, POLLIN, 0}};
      if (!client.has_letter()) poll(both, 2, 1);
      letter = client.has_letter();
      if (client.receive() == Connection::Received::closed) return;
    }
  }
  void answer(Connection& client, std::string_view message) const {
    Envelope envelope;
    read_envelope(message, envelope);
    const bool opens = envelope.method == OpenMailbox::name;
    Encoder out(client.out());
    if (opens && refusal_) {
      write_error(envelope.id, Error(*refusal_, "no", {}, "do without"), out);
      client.flush();
      return;
    }
    if (opens) {
      client.use(Mailbox::make(), Connection::Waits::elsewhere);
      client.attach(client.mailbox()->descriptors());
    }
    const Hello::Reply hello{"parrot", "1", kProtocolVersion, 1};
    const OpenMailbox::Reply room{Mailbox::kRoom};
    const Nothing nothing;
    begin_result(envelope.id, out);
    if (envelope.method == Hello::name) {
      pack(type_of<Hello::Reply>(), &hello, out);
    } else if (opens) {
      pack(type_of<OpenMailbox::Reply>(), &room, out);
    } else {
      pack(type_of<Nothing>(), &nothing, out);
    }
    client.flush();
  }

  UniqueFd listener_;
  std::optional<Code> refusal_;
  std::vector<bool> letters_;
  std::thread thread_;
};

TEST_F(SocketTest, TheNinthCallOfAChannelIsALetterAndManyAtOnceAreNot) {
  const fs::path socket = directory_.path() / "parrot.sock";
  Listener listener(socket);
  {
    SocketSuite suite(options());
    SocketChannel& parrot = suite.server("parrot", socket);
    for (int i = 0; i < 9; ++i) parrot.call<Empty>({});
    const std::vector<Nothing> requests(3);
    parrot.call_all<Empty>(requests);
    parrot.call<Empty>({});
  }
  std::vector<bool> expected(9, false);  // hello, seven calls, the request for a mailbox
  expected.insert(expected.end(), {true, true, false, false, false, true});
  EXPECT_EQ(listener.letters(), expected);
}

TEST_F(SocketTest, AServerThatHasNoMailboxIsCalledOverTheSocket) {
  for (Code refusal : {Code::limit, Code::unknown_method}) {
    const fs::path socket = directory_.path() / fmt::format("{}.sock", name_of(refusal));
    Listener listener(socket, refusal);
    {
      SocketSuite suite(options());
      for (int i = 0; i < 20; ++i) suite.server("parrot", socket).call<Empty>({});
    }
    EXPECT_EQ(listener.letters(), std::vector<bool>(22, false));
  }
}

TEST_F(SocketTest, AServerThatFailsToMakeAMailboxIsNotTakenForOneWithout) {
  const fs::path socket = directory_.path() / "parrot.sock";
  Listener listener(socket, Code::internal);
  SocketSuite suite(options());
  SocketChannel& parrot = suite.server("parrot", socket);
  for (int i = 0; i < 7; ++i) parrot.call<Empty>({});
  EXPECT_EQ(error_of([&] { parrot.call<Empty>({}); }).code(), Code::internal);
}

TEST_F(MailboxTest, AChannelThatIsCalledOftenOpensOne) {
  Served names(directory_, std::string(kWellKnown), fill_names);
  Served parrot(directory_, "polly", fill_parrot);
  SocketSuite suite(options());
  Channel& polly = suite.channel("polly");
  const auto mailboxes = [&] {
    const auto rows = polly.call<Statistics>({}).messages;
    return std::ranges::count(rows, "mailbox", &Statistics::Count::message);
  };
  EXPECT_EQ(mailboxes(), 0);
  for (int i = 0; i < 100; ++i) {
    auto request = full_request();
    request.count = i;
    request.label = std::string(static_cast<size_t>(i * i), 'x');  // up to 9801 bytes
    const auto reply = polly.call<Echo>(request);
    ASSERT_EQ(reply.count, i);
    ASSERT_EQ(reply.label, request.label);
    ASSERT_EQ(error_of([&] { polly.call<Fail>({}); }).code(), Code::refused);
  }
  EXPECT_EQ(mailboxes(), 1);
  // Descriptors come over the socket from where calls are letters.
  for (int i = 0; i < 20; ++i)
    EXPECT_EQ(suite.arrays().create(fmt::format("a{}", i), {2}).values().size(), 2u);
  Told::Request told;
  polly.call<Twice>({Array::inlined({1}, {3}), {}});
  EXPECT_TRUE(polly.wait_notification<Told>(told, kLong_s));
  EXPECT_EQ(told.count, 1);
}

}  // namespace
}  // namespace animado::rpc::testing
