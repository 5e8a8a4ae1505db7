// A client that is not a Channel: writes bytes, reads messages as JSON text, and sees which way they came.
#pragma once

#include <gmock/gmock.h>
#include <poll.h>

#include "fixture.hpp"
#include "rpc/json.hpp"

namespace animado::rpc::testing {

using ::testing::HasSubstr;

inline constexpr double kLong_s = 30;

inline std::vector<UniqueFd> copies(std::span<const int> descriptors) {
  std::vector<UniqueFd> copied;
  for (int fd : descriptors) copied.emplace_back(dup(fd));
  return copied;
}

inline bool is_readable(int fd) {
  pollfd entry{fd, POLLIN, 0};
  return poll(&entry, 1, 0) == 1;
}

class Raw {
 public:
  explicit Raw(const fs::path& socket) : connection_(connect_to(socket), Descriptors::taken) {}

  // Hands over what the server takes now; the rest goes while replies are waited for.
  void send(std::string_view bytes) {
    connection_.out() += bytes;
    connection_.flush();
  }
  void send_json(std::string_view json) { send(packed_of(json)); }
  void send_letter(std::string_view bytes) {
    connection_.call_by_letter();
    send(bytes);
  }
  // The next message, or "closed".
  std::string receive() {
    std::string_view message;
    const auto deadline = Clock::now() + seconds(kLong_s);
    while (!connection_.next_message(message)) {
      const bool more = connection_.flush() && connection_.unsent() > 0;
      if (more) wait_until(connection_.fd(), POLLIN | POLLOUT, deadline);
      const auto received = more ? connection_.receive() : connection_.receive_by(deadline);
      if (received == Connection::Received::closed) return "closed";
      if (Clock::now() > deadline) throw std::runtime_error("the server says nothing");
    }
    return json_of(message);
  }
  std::string ask(std::string_view json) {
    send_json(json);
    return receive();
  }
  std::string ask_by_letter(std::string_view json) {
    send_letter(packed_of(json));
    return receive();
  }
  void hello() {
    EXPECT_THAT(ask(R"([0, 1, "hello", [{"protocol": "animado", "version": 1}]])"),
                HasSubstr(R"("protocol_version":1)"));
  }
  // What the server says, and copies of what it hands over.
  std::string open_mailbox() {
    std::string answer = ask(R"([0, 2, "mailbox", [{}]])");
    auto descriptors = connection_.take_descriptors();
    for (const UniqueFd& fd : descriptors) handed_.emplace_back(dup(fd.get()));
    if (!descriptors.empty()) connection_.use(Mailbox::open(std::move(descriptors)), Connection::Waits::here);
    return answer;
  }
  std::vector<UniqueFd> take_handed() { return std::exchange(handed_, {}); }
  Connection& connection() { return connection_; }

 private:
  Connection connection_;
  std::vector<UniqueFd> handed_;
};

}  // namespace animado::rpc::testing
