#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "base/error.hpp"
#include "rpc/common.hpp"
#include "rpc/directory_watch.hpp"
#include "rpc/encoder.hpp"
#include "rpc/json.hpp"
#include "rpc/socket_suite.hpp"
#include "rpc/wire.hpp"

namespace animado::rpc {
namespace {

// Between two looks for a lost service, when its socket does not show up by itself: it may listen a moment
// before it is registered.
constexpr std::chrono::milliseconds kFirstPause{1}, kLongestPause{100};

// From this call on a connection is worth a mailbox.
constexpr int64_t kCallWithMailbox = 8;

// Waits for a service to come back: until a socket appears in the folder, or a pause that doubles is over.
class Comeback {
 public:
  Comeback(const std::filesystem::path& directory, double limit_s)
      : directory_(directory), deadline_(Clock::now() + seconds(limit_s)) {}

  // False when the time limit is over.
  bool wait() {
    if (Clock::now() >= deadline_) return false;
    if (!watch_) {
      // The service may have come back before we began to watch: the first pause is none.
      watch_.emplace(directory_);
      return true;
    }
    wait_until(watch_->fd(), POLLIN, std::min(deadline_, Clock::now() + pause_));
    watch_->clear();
    pause_ = std::min(2 * pause_, kLongestPause);
    return true;
  }

 private:
  std::filesystem::path directory_;
  Clock::time_point deadline_;
  std::chrono::milliseconds pause_ = kFirstPause;
  std::optional<DirectoryWatch> watch_;
};

}  // namespace

void SocketChannel::exchange(const MessageCodec& message, const void* request, void* reply) {
  params_.clear();
  Encoder out(params_);
  pack_params(message.request, request, suite_.next_marks(), out);
  Decoder in(transact_with_arrays(message.name));
  unpack(message.reply, in, reply, message.name);
}

// A service that looked for an array of ours while interexpserv had lost it is asked again once it is there.
std::string_view SocketChannel::transact_with_arrays(std::string_view method) {
  for (;;) {
    try {
      return transact(method, params_);
    } catch (const Error& error) {
      const bool may_be_lost = error.code() == Code::unknown_array && service_ != kWellKnown;
      if (!may_be_lost || !suite_.arrays_came_back()) throw;
    }
  }
}

std::string SocketChannel::call_json(std::string_view method, std::string_view params) {
  return json_of(transact(method, packed_of(params)));
}

std::string_view SocketChannel::transact(std::string_view method, std::string_view params) {
  std::string_view result;
  const auto once = [&] { result = attempt(method, params); };
  repeat(method, std::ref(once));  // a reference fits into a std::function without memory of its own
  return result;
}

void SocketChannel::repeat(std::string_view method, const std::function<void()>& attempt) {
  std::optional<Comeback> comeback;
  do {
    try {
      return attempt();
    } catch (const Broken&) {
      connection_.reset();
      if (!comeback) comeback.emplace(suite_.options().directory, suite_.options().reconnect_s);
    }
  } while (comeback->wait());
  give_up(method);
}

std::string_view SocketChannel::attempt(std::string_view method, std::string_view params) {
  if (!connection_) connect();
  const auto deadline = Clock::now() + seconds(suite_.options().call_timeout_s);
  if (++calls_ == kCallWithMailbox) ask_for_mailbox(deadline);
  Encoder out(connection_->out());
  begin_request(++id_, method, out);
  out.raw(params);
  connection_->call_by_letter();
  send(deadline, method);
  const std::string_view result = receive_reply(id_, deadline, method);
  received_ = connection_->take_descriptors();
  return result;
}

std::filesystem::path SocketChannel::find_socket() {
  if (!socket_.empty()) return socket_;
  const auto& directory = suite_.options().directory;
  if (service_ == kWellKnown) return socket_path(directory, kWellKnown, 0);
  try {
    return suite_.channel(kWellKnown).call<Lookup>({service_}).socket;
  } catch (const Error& error) {
    // Not registered now: it may be about to come back. When interexpserv itself is away, its own channel has
    // waited already.
    if (error.code() == Code::unavailable && error.where() != kWellKnown) throw Broken{};
    throw;
  }
}

void SocketChannel::connect() {
  UniqueFd fd = connect_to(find_socket());
  if (!fd) throw Broken{};
  connection_.emplace(std::move(fd), Descriptors::taken);
  inbox_.clear();
  ++connections_;
  calls_ = 0;
  try {
    const auto deadline = Clock::now() + seconds(suite_.options().call_timeout_s);
    say_hello(deadline);
    if (service_ == kWellKnown) hand_arrays_back(deadline);
  } catch (const Error&) {
    connection_.reset();
    throw;
  }
}

template <class M>
std::string_view SocketChannel::ask(const typename M::Request& request, Clock::time_point deadline) {
  Encoder out(connection_->out());
  begin_request(++id_, M::name, out);
  pack(type_of<typename M::Request>(), &request, out);
  send(deadline, M::name);
  return receive_reply(id_, deadline, M::name);
}

void SocketChannel::say_hello(Clock::time_point deadline) {
  ask<Hello>({std::string(kProtocolName), kProtocolVersion, suite_.options().client, suite_.options().trace},
             deadline);
}

// Arrays belong to the connection: one that was restarted does not know ours, nor one that we were cut off
// from.
void SocketChannel::hand_arrays_back(Clock::time_point deadline) {
  for (const auto& [name, array] : suite_.arrays().made()) {
    const int descriptor = array.descriptor();
    connection_->attach({&descriptor, 1});
    ask<ArrayAdopt>({name, array.shape()}, deadline);
  }
}

// A server that has none to give is called over the socket; so is one of another version, whose letters have
// another form: their room tells.
void SocketChannel::ask_for_mailbox(Clock::time_point deadline) {
  try {
    Decoder in(ask<OpenMailbox>({}, deadline));
    OpenMailbox::Reply mailbox;
    unpack(type_of<OpenMailbox::Reply>(), in, &mailbox, OpenMailbox::name);
    auto descriptors = connection_->take_descriptors();
    if (mailbox.room != Mailbox::kRoom) return;
    connection_->use(Mailbox::open(std::move(descriptors)), Connection::Waits::here);
  } catch (const Error& error) {
    if (error.code() != Code::limit && error.code() != Code::unknown_method) throw;
  }
}

void SocketChannel::send(Clock::time_point deadline, std::string_view method) {
  for (;;) {
    if (!connection_->flush()) throw Broken{};
    if (connection_->unsent() == 0) return;
    if (!wait_until(connection_->fd(), POLLOUT, deadline)) give_up(method);
  }
}

bool SocketChannel::has_come(Connection::Received received) {
  if (received == Connection::Received::closed) throw Broken{};
  return received == Connection::Received::bytes;
}

// Takes the bytes that are there; false when there are none.
bool SocketChannel::receive_now() {
  return has_come(connection_->receive());
}

// Waits for bytes; false when none came in time.
bool SocketChannel::receive(Clock::time_point deadline) {
  const auto look = [this] {
    connection_->spin_for_letter();
    return receive_now();
  };
  if (patience_.pays()) {
    if (patience_.poll(look)) return true;
  } else if (connection_->mailbox() && !connection_->has_letter()) {
    patience_.hand_over();
  }
  const auto received = connection_->receive_by(deadline);
  patience_.waited();
  return has_come(received) || Clock::now() < deadline;
}

// Takes the next message that is there. A peer that sends something else loses the connection.
bool SocketChannel::next_envelope(Envelope& envelope, std::string_view& message) {
  try {
    if (!connection_->next_message(message)) return false;
    read_envelope(message, envelope);
    return true;
  } catch (const Error&) {
    connection_.reset();
    throw;
  }
}

std::string_view SocketChannel::receive_reply(int64_t id, Clock::time_point deadline,
                                              std::string_view method) {
  for (;;) {
    Envelope envelope;
    std::string_view message;
    while (next_envelope(envelope, message)) {
      if (envelope.kind == Envelope::Kind::notification) inbox_.put(message);
      if (envelope.kind != Envelope::Kind::reply || envelope.id != id) continue;
      if (!envelope.error.empty()) throw read_error(envelope.error);
      return envelope.body;
    }
    if (!receive(deadline)) give_up(method);
  }
}

void SocketChannel::give_up(std::string_view method) {
  const bool was_connected = connection_.has_value();
  connection_.reset();  // an answer that comes late must not meet the next question
  const auto& options = suite_.options();
  throw Error(
      Code::unavailable,
      was_connected
          ? fmt::format("{} did not answer {} within {} s", service_, method, options.call_timeout_s)
          : fmt::format("{} cannot be reached (tried for {} s, sockets in {})", service_, options.reconnect_s,
                        options.directory.string()),
      service_,
      "animado ps shows what runs; animado run starts all services; the log of the service may tell more");
}

bool SocketChannel::next_notification(const MessageCodec& message, void* request, double timeout_s) {
  const auto deadline = Clock::now() + seconds(timeout_s);
  try {
    // A call may have made a new connection meanwhile, which nobody has asked to watch anything.
    const int64_t before = std::exchange(listened_to_, connections_);
    if (!connection_ || (before != 0 && before != connections_)) throw Broken{};
    while (!inbox_.take(message, request)) {
      if (!(timeout_s > 0 ? receive(deadline) : receive_now())) return false;
      Envelope envelope;
      std::string_view text;
      while (next_envelope(envelope, text)) inbox_.put(text);
    }
    return true;
  } catch (const Broken&) {
    connection_.reset();
    listened_to_ = 0;
    throw Error(Code::unavailable, fmt::format("the connection to {} was lost", service_), service_,
                "ask to watch again");
  }
}

}  // namespace animado::rpc
