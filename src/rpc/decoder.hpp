// Reads MessagePack from bytes that are all there, value by value, without a copy or a tree.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "rpc/msgpack_head.hpp"

namespace animado::rpc {

// Replies may say NaN (a residual that was lost); requests may not.
enum class Numbers { any, finite };

// What a request may carry beside its fields, under the reserved keys _trace and _seq, for the log.
struct Marks {
  std::string_view trace;  // of the run
  int64_t seq = 0;         // number of the call in the run
};

class Decoder {
 public:
  explicit Decoder(std::string_view bytes, Numbers numbers = Numbers::any)
      : at_(bytes.data()), end_(bytes.data() + bytes.size()), numbers_(numbers) {}

  // The head of the next value, which stays next. Throws Code::protocol at the end of the bytes.
  Head peek() const {
    Head head;
    if (!read_head(at_, end_, head) ||
        (head.has_body() && head.count > static_cast<size_t>(end_ - at_) - head.size))
      refuse_end();
    return head;
  }
  // Takes the head; the values or bytes that it announces come next.
  Head next() {
    const Head head = peek();
    at_ += head.size;
    return head;
  }
  std::string_view body(const Head&);  // the bytes that the head of a text, bytes or extension announced
  std::string_view skip();             // takes a whole value, whatever it is: its bytes
  std::string_view rest();             // takes all that is left
  bool at_end() const { return at_ == end_; }
  bool finite_only() const { return numbers_ == Numbers::finite; }

  Marks marks;

 private:
  [[noreturn]] static void refuse_end();

  const char *at_, *end_;
  Numbers numbers_;
};

}  // namespace animado::rpc
