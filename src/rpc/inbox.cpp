#include "rpc/inbox.hpp"

#include "rpc/decoder.hpp"
#include "rpc/wire.hpp"

namespace animado::rpc {

void Inbox::put(std::string_view message) {
  messages_.emplace_back(message);
  bytes_ += message.size();
}

void Inbox::clear() {
  messages_.clear();
  bytes_ = 0;
}

bool Inbox::take(const MessageCodec& message, void* request) {
  for (auto at = messages_.begin(); at != messages_.end(); ++at) {
    Envelope envelope;
    read_envelope(*at, envelope);
    if (envelope.method != message.name) continue;
    Decoder in(envelope.body);
    unpack(message.request, in, request, message.name);
    bytes_ -= at->size();
    messages_.erase(at);
    return true;
  }
  return false;
}

}  // namespace animado::rpc
