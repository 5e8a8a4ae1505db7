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
  Head peek() const;
  Head next();                         // takes the head; the values or bytes that it announces come next
  std::string_view body(const Head&);  // the bytes that the head of a text, bytes or extension announced
  std::string_view skip();             // takes a whole value, whatever it is: its bytes
  bool at_end() const { return at_ == end_; }
  bool finite_only() const { return numbers_ == Numbers::finite; }

  Marks marks;

 private:
  const char *at_, *end_;
  Numbers numbers_;
};

}  // namespace animado::rpc
