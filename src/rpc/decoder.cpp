#include "rpc/decoder.hpp"

#include "base/error.hpp"

namespace animado::rpc {

void Decoder::refuse_end() {
  throw Error(Code::protocol, "the message ends in the middle of a value", {},
              "send whole MessagePack values");
}

std::string_view Decoder::body(const Head& head) {
  const std::string_view bytes(at_, head.count);
  at_ += head.count;
  return bytes;
}

std::string_view Decoder::skip() {
  const char* begin = at_;
  for (size_t missing = 1; missing > 0; --missing) {
    const Head head = next();
    if (head.has_body()) at_ += head.count;
    if (head.kind == Head::Kind::list) missing += head.count;
    if (head.kind == Head::Kind::map) missing += 2 * head.count;
  }
  return {begin, static_cast<size_t>(at_ - begin)};
}

std::string_view Decoder::rest() {
  const std::string_view bytes(at_, static_cast<size_t>(end_ - at_));
  at_ = end_;
  return bytes;
}

}  // namespace animado::rpc
