// The other modules, each behind its socket.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "rpc/channel.hpp"
#include "rpc/connection.hpp"
#include "rpc/decoder.hpp"
#include "rpc/endpoint.hpp"
#include "rpc/inbox.hpp"
#include "rpc/shared_array.hpp"
#include "rpc/waiting.hpp"
#include "rpc/wire.hpp"

namespace animado::rpc {

class SocketSuite;

// Calls one service. Finds it through interexpserv, and stays with that server as long as the connection
// lasts; when it breaks, finds one again and repeats the request until reconnect_s is over. One thread at a
// time.
class SocketChannel final : public Channel {
 public:
  // socket: of the one server that is meant; empty for any that offers the service.
  SocketChannel(SocketSuite& suite, std::string service, std::filesystem::path socket = {})
      : suite_(suite), service_(std::move(service)), socket_(std::move(socket)) {}

  UniqueFd take_descriptor() override { return first_of(received_); }

  // Any message of any service, as text: params as a JSON object, the result as JSON.
  std::string call_json(std::string_view method, std::string_view params);

  bool is_connected() const { return connection_.has_value(); }
  int64_t connections() const { return connections_; }  // so far
  int fd() const {
    return connection_ ? connection_->fd() : -1;
  }  // readable when a notification may have come; -1 when not connected

 protected:
  void exchange(const MessageCodec& message, const void* request, void* reply) override;
  void exchange_all(const MessageCodec& message, std::span<const Exchange> exchanges) override;
  bool next_notification(const MessageCodec& message, void* request, double timeout_s) override;

 private:
  struct Broken {};  // the connection is gone; thrown inside only

  // Until it is not Broken any more, or the time limit is over.
  void repeat(std::string_view method, const std::function<void()>& attempt);
  // Sends [0, id, method, [params]] and returns the packed result, connecting and repeating as needed.
  std::string_view transact(std::string_view method, std::string_view params);
  std::string_view transact_with_arrays(std::string_view method);  // params_
  std::string_view attempt(std::string_view method, std::string_view params);
  // From exchanges[done] on, which it moves forward: what is done stays done when the connection breaks.
  void pipeline(const MessageCodec& message, std::span<const Exchange> exchanges, size_t& done);
  bool take_reply(const MessageCodec& message, int64_t id, const Exchange& exchange);
  // One exchange over the connection as it is.
  template <class M>
  std::string_view ask(const typename M::Request& request, Clock::time_point deadline);
  void connect();
  std::filesystem::path find_socket();
  void say_hello(Clock::time_point deadline);
  void hand_arrays_back(Clock::time_point deadline);
  void ask_for_mailbox(Clock::time_point deadline);
  void send(Clock::time_point deadline, std::string_view method);
  std::string_view receive_reply(int64_t id, Clock::time_point deadline, std::string_view method);
  static bool has_come(Connection::Received received);
  bool receive_now();
  bool receive(Clock::time_point deadline);
  bool next_envelope(Envelope& envelope, std::string_view& message);
  [[noreturn]] void give_up(std::string_view method);

  SocketSuite& suite_;
  std::string service_;
  std::filesystem::path socket_;
  std::string params_;
  std::optional<Connection> connection_;
  Inbox inbox_;
  int64_t connections_ = 0, listened_to_ = 0;  // how many there were; which of them notifications came over
  int64_t calls_ = 0;                          // over this connection
  std::vector<UniqueFd> received_;
  int64_t id_ = 0;
  Patience patience_;
};

class SocketSuite final : public Suite {
 public:
  struct Options {
    std::filesystem::path directory = socket_directory();
    std::string client = {};     // our name in the logs of the others
    std::string trace = {};      // the run's id in the logs
    double call_timeout_s = 30;  // a batch of 10,000 systems takes 0.01 s: who needs 30 s is stuck
    double reconnect_s =
        15;  // restarting a service takes 0.1 s; the supervisor gives up after 5 deaths in 10 s
  };
  explicit SocketSuite(Options options) : options_(std::move(options)) {}

  SocketChannel& channel(std::string_view service) override;
  // One server of several that offer the service, as `list` tells its socket.
  SocketChannel& server(const std::string& service, const std::filesystem::path& socket);
  SharedArrays& arrays() override;
  // Asks interexpserv, and tells whether that took a new connection, over which it had our arrays back.
  bool arrays_came_back();
  const Options& options() const { return options_; }
  Marks next_marks() { return {options_.trace, ++seq_}; }

 private:
  Options options_;
  int64_t seq_ = 0;
  std::map<std::string, SocketChannel, std::less<>> channels_;
  std::map<std::filesystem::path, SocketChannel> servers_;  // by socket
  std::unique_ptr<SharedArrays> arrays_;
};

}  // namespace animado::rpc
