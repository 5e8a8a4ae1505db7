// Many requests under way at once: Channel::call_all.
#include <algorithm>

#include "base/error.hpp"
#include "rpc/encoder.hpp"
#include "rpc/socket_suite.hpp"

namespace animado::rpc {
namespace {

// Bytes of requests that are packed before the socket takes them; a server's receive is about as large.
constexpr size_t kPacked = 16 << 10;
// Requests without a reply yet: enough to keep both ends at work, few enough that their replies fit the
// socket's buffers.
constexpr size_t kUnderWay = 1024;

}  // namespace

void Channel::exchange_all(const MessageCodec& message, std::span<const Exchange> exchanges) {
  for (const auto& [request, reply, error] : exchanges) {
    try {
      exchange(message, request, reply);
    } catch (const Error& thrown) {
      *error = thrown;
    }
  }
}

void SocketChannel::exchange_all(const MessageCodec& message, std::span<const Exchange> exchanges) {
  size_t done = 0;
  repeat(message.name, [&] { pipeline(message, exchanges, done); });
  const bool knows_arrays = std::ranges::none_of(exchanges, [](const Exchange& exchange) {
    return *exchange.error && (*exchange.error)->code() == Code::unknown_array;
  });
  if (knows_arrays || service_ == kWellKnown) return;
  for (const Exchange& exchange : exchanges) {
    if (*exchange.error && (*exchange.error)->code() == Code::unknown_array) {
      exchange.error->reset();
      Channel::exchange_all(message, std::span(&exchange, 1));  // asks again once they are there
    }
  }
}

void SocketChannel::pipeline(const MessageCodec& message, std::span<const Exchange> exchanges, size_t& done) {
  if (!connection_) connect();
  const int64_t first = ++id_ - static_cast<int64_t>(done);  // the id of exchanges[0], had it been sent now
  size_t sent = done;
  auto deadline = Clock::now() + seconds(suite_.options().call_timeout_s);
  // Until the peer has sent something, or takes what is not sent yet; false when the time is over.
  const auto await_peer = [&] {
    if (connection_->unsent() == 0) return receive(deadline);
    if (!wait_until(connection_->fd(), POLLIN | POLLOUT, deadline)) return false;
    receive_now();
    return true;
  };
  while (done < exchanges.size()) {
    while (sent < exchanges.size() && sent - done < kUnderWay && connection_->unsent() < kPacked) {
      Encoder out(connection_->out());
      id_ = first + static_cast<int64_t>(sent);
      begin_request(id_, message.name, out);
      pack_params(message.request, exchanges[sent++].request, suite_.next_marks(), out);
    }
    if (!connection_->flush()) throw Broken{};
    const size_t before = done;
    while (done < sent && take_reply(message, first + static_cast<int64_t>(done), exchanges[done])) ++done;
    if (done > before) {
      deadline = Clock::now() + seconds(suite_.options().call_timeout_s);
    } else if (!await_peer()) {
      give_up(message.name);
    }
  }
}

// Replies come in the order of the requests. False when the next one is not there yet.
bool SocketChannel::take_reply(const MessageCodec& message, int64_t id, const Exchange& exchange) {
  Envelope envelope;
  std::string_view bytes;
  while (next_envelope(envelope, bytes)) {
    if (envelope.kind == Envelope::Kind::notification) {
      inbox_.put(bytes);
    } else if (envelope.kind == Envelope::Kind::reply && envelope.id == id) {
      try {
        if (!envelope.error.empty()) throw read_error(envelope.error);
        Decoder in(envelope.body);
        unpack(message.reply, in, exchange.reply, message.name);
      } catch (const Error& error) {
        *exchange.error = error;
      }
      return true;
    }
    envelope = {};
  }
  return false;
}

}  // namespace animado::rpc
