#include "rpc/decoder.hpp"

#include "base/error.hpp"

namespace animado::rpc {

Head Decoder::peek() const {
  Head head;
  if (!read_head(at_, end_, head) ||
      (head.has_body() && head.count > static_cast<size_t>(end_ - at_) - head.size)) {
    throw Error(Code::protocol, "the message ends in the middle of a value", {},
                "send whole MessagePack values");
  }
  return head;
}

Head Decoder::next() {
  const Head head = peek();
  at_ += head.size;
  return head;
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

}  // namespace animado::rpc
