// src/rpc/socket_channel.cpp: when a channel opens a mailbox, and what it sends through it.
#include <gmock/gmock.h>
#include <sys/socket.h>

#include <algorithm>

#include "raw.hpp"
#include "rpc/encoder.hpp"
#include "rpc/wire.hpp"

namespace animado::rpc::testing {
namespace {

// A server of one client, which answers whatever it is asked with an empty map, and remembers how it was
// asked.
class Listener {
 public:
  // refusal: what who asks for a mailbox is told; or else how much room a letter has.
  explicit Listener(const fs::path& socket, std::optional<Code> refusal = {}, int64_t room = Mailbox::kRoom)
      : listener_(listen_at(socket)), refusal_(refusal), room_(room), thread_([this] { serve(); }) {}
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
    const OpenMailbox::Reply room{room_};
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
  int64_t room_;
  std::vector<bool> letters_;
  std::thread thread_;
};

using ChannelMailboxTest = SocketTest;

TEST_F(ChannelMailboxTest, TheEighthCallOfAChannelIsALetterAndManyAtOnceAreNot) {
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

TEST_F(ChannelMailboxTest, AServerThatHasNoMailboxIsCalledOverTheSocket) {
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

TEST_F(ChannelMailboxTest, AServerOfAnotherVersionIsCalledOverTheSocket) {
  const fs::path socket = directory_.path() / "parrot.sock";
  Listener listener(socket, {}, Mailbox::kRoom + 4);
  {
    SocketSuite suite(options());
    for (int i = 0; i < 20; ++i) suite.server("parrot", socket).call<Empty>({});
  }
  EXPECT_EQ(listener.letters(), std::vector<bool>(22, false));
}

TEST_F(ChannelMailboxTest, AServerThatFailsToMakeAMailboxIsNotTakenForOneWithout) {
  const fs::path socket = directory_.path() / "parrot.sock";
  Listener listener(socket, Code::internal);
  SocketSuite suite(options());
  SocketChannel& parrot = suite.server("parrot", socket);
  for (int i = 0; i < 7; ++i) parrot.call<Empty>({});
  EXPECT_EQ(error_of([&] { parrot.call<Empty>({}); }).code(), Code::internal);
}

TEST_F(ChannelMailboxTest, AChannelThatIsCalledOftenOpensOne) {
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
