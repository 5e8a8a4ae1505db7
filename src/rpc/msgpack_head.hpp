// The first bytes of a MessagePack value: what it is and how long it says it is. Nothing is believed beyond
// the bytes that are there.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace animado::rpc {

// Limits on one message. They bound what a client can make a server hold.
inline constexpr size_t kMaxMessageBytes = size_t{64}
                                           << 20;  // 8 M numbers inline; more belongs in a shared array
inline constexpr size_t kMaxMessageValues =
    size_t{1} << 22;                            // a value of 1 byte becomes a string of 32: 128 MiB at most
inline constexpr size_t kMaxMessageDepth = 32;  // protocols nest 6 deep

struct Head {
  enum class Kind : uint8_t { nil, boolean, integer, large, number, text, bytes, list, map, extension };
  Kind kind = Kind::nil;  // large: an integer beyond int64
  int64_t integer = 0;    // boolean, integer
  double number = 0;
  size_t count = 0;  // text, bytes, extension: bytes that follow; list: values; map: pairs
  uint8_t size = 0;  // of the head itself

  bool has_body() const { return kind == Kind::text || kind == Kind::bytes || kind == Kind::extension; }
};

std::string_view name_of(Head::Kind kind);

// Reads the head at `begin`; false when the bytes end before it does. Throws Code::protocol for a byte that
// MessagePack does not use.
bool read_head(const char* begin, const char* end, Head& head);

// The same for the codes 0xc0 … 0xdf, which name their type and the size of what follows.
bool read_long_head(const char* begin, const char* end, Head& head);

inline bool read_head(const char* begin, const char* end, Head& head) {
  if (begin == end) return false;
  const auto code = static_cast<uint8_t>(*begin);
  if (code < 0x80) {
    head = {.kind = Head::Kind::integer, .integer = code, .size = 1};
  } else if (code < 0x90) {
    head = {.kind = Head::Kind::map, .count = code & 0x0fu, .size = 1};
  } else if (code < 0xa0) {
    head = {.kind = Head::Kind::list, .count = code & 0x0fu, .size = 1};
  } else if (code < 0xc0) {
    head = {.kind = Head::Kind::text, .count = code & 0x1fu, .size = 1};
  } else if (code < 0xe0) {
    return read_long_head(begin, end, head);
  } else {
    head = {.kind = Head::Kind::integer, .integer = static_cast<int8_t>(code), .size = 1};
  }
  return true;
}

// Finds the end of one value in a buffer that grows. Looks at each byte once.
class Scanner {
 public:
  // True when the value that starts at `begin` is complete; size() then tells its length. `begin` may move
  // between calls, the bytes may not change. Throws Code::limit as soon as a head claims more than a message
  // may hold.
  bool scan(const char* begin, const char* end);
  size_t size() const { return position_; }
  void reset();

 private:
  void enter(const Head& head);

  size_t position_ = 0, values_ = 0;
  size_t missing_ = 1;  // values that the innermost open list or map, or the whole, still waits for
  size_t depth_ = 0;    // of open lists and maps
  std::array<size_t, kMaxMessageDepth> outer_;  // what is missing in those around it
};

}  // namespace animado::rpc
