// A service is a table: message → handler. The skeleton (daemon.hpp) serves it on a socket, LocalSuite serves
// it in this process. Beside its own messages every service answers hello, ping, statistics and describe
// (common.hpp).
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "rpc/channel.hpp"
#include "rpc/codec.hpp"
#include "rpc/message.hpp"

namespace animado::rpc {

using ConnectionId = uint64_t;

// What a handler may ask about the call it serves.
class Call {
 public:
  virtual ~Call() = default;
  virtual ConnectionId connection() const = 0;
  virtual std::string_view client() const { return {}; }  // who calls, as it said in hello; may be empty

  // The numbers of an array of the request: inline ones, or the shared pages. Throws bad_shape when the array
  // holds fewer than its shape asks for, unknown_array when nobody created it.
  virtual std::span<const double> read(const Array& array) = 0;
  virtual std::span<double> write(const Array& array) = 0;  // shared only: bad_params otherwise

  virtual void send_descriptor(int fd) = 0;  // with the reply, or another one; the service keeps its own copy
  virtual UniqueFd take_descriptor() { return {}; }  // that came with the request, if any
};

// Bytes of notifications that a connection may leave unread, beside what the kernel keeps for it.
inline constexpr size_t kMaxUnread = 256 << 10;

class Service {
 public:
  using Handler = std::function<void(const void* request, void* reply, Call& call)>;
  struct Entry {
    const MessageCodec* codec;
    Handler handler;
  };

  explicit Service(std::string name) : name_(std::move(name)) {}
  Service(Service&&) = default;
  const std::string& name() const { return name_; }

  // Adds a row. `handler` is callable as Reply(const Request&, Call&) or Reply(const Request&).
  template <class M, class H>
  Service& on(H handler) {
    add(codec<M>(), [handler = std::move(handler)](const void* request, void* reply, Call& call) mutable {
      const auto& typed = *static_cast<const typename M::Request*>(request);
      auto& answer = *static_cast<typename M::Reply*>(reply);
      if constexpr (std::is_invocable_v<H, const typename M::Request&, Call&>) {
        answer = handler(typed, call);
      } else {
        answer = handler(typed);
      }
    });
    return *this;
  }

  const Entry* find(std::string_view method) const;
  const std::map<std::string, Entry, std::less<>>& entries() const { return entries_; }

  // Called when a connection ends, however it ends (leases end here).
  std::function<void(ConnectionId)> on_disconnect;
  // How a notification is sent: `message` is whole, as notification() packs it, and may go to many
  // connections. Set by whoever serves. full: the connection has too much unread, and nothing was sent;
  // on_drained is called when it has read all of it.
  enum class Delivery { sent, full, gone };
  std::function<Delivery(ConnectionId, std::string_view message)> post;
  std::function<void(ConnectionId)> on_drained;

  // Sends a notification to one connection. False when it is gone or full.
  bool notify(ConnectionId connection, const MessageCodec& message, const void* request) const;

  // Whether a connection is still there, for a handler that takes long; sends on what it was notified of. Set
  // by a server, empty in this process.
  std::function<bool(ConnectionId)> is_connected;

  // Gives a connection a mailbox, or tells that it has, and what a client needs for it: Mailbox::descriptors.
  // Throws Code::limit. Set by a server, empty in this process.
  std::function<std::array<int, 3>(ConnectionId)> open_mailbox;

 private:
  void add(const MessageCodec& codec, Handler handler);
  std::string name_;
  std::map<std::string, Entry, std::less<>> entries_;
  mutable const Entry* last_found_ = nullptr;  // what was asked for is likely to be asked for again
};

// A whole notification, to be posted.
std::string notification(const MessageCodec& message, const void* request);
template <class M>
std::string notification(const typename M::Request& request) {
  return notification(codec<M>(), &request);
}

// Puts `values` where the request asks for the result: into the shared array `out`, or inline. Returns the
// reply's array.
Array deliver(Call& call, const std::optional<Array>& out, std::vector<int64_t> shape,
              std::vector<double> values);

}  // namespace animado::rpc
