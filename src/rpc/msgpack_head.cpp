#include "rpc/msgpack_head.hpp"

#include <array>
#include <bit>
#include <cstring>

#include <fmt/format.h>
#include "base/error.hpp"

namespace animado::rpc {
namespace {

uint64_t big_endian(const char* at, size_t bytes) {
  uint64_t value = 0;
  for (size_t i = 0; i < bytes; ++i) value = value << 8 | static_cast<uint8_t>(at[i]);
  return value;
}

// How the types beyond the small ones are coded: bytes 0xc4 … 0xdf of the MessagePack specification.
struct Coding {
  Head::Kind kind;
  uint8_t bytes;  // of the integer, number or length that follows
  bool is_signed;
  uint8_t
      extra;  // bytes between the length and the body that are counted with the body (extension: its type)
  uint8_t fixed_body;  // body length that the code itself tells
};

using Kind = Head::Kind;
constexpr std::array<Coding, 28> kCodings = {{
    {Kind::bytes, 1, false, 0, 0},     {Kind::bytes, 2, false, 0, 0},     {Kind::bytes, 4, false, 0, 0},
    {Kind::extension, 1, false, 1, 0}, {Kind::extension, 2, false, 1, 0}, {Kind::extension, 4, false, 1, 0},
    {Kind::number, 4, false, 0, 0},    {Kind::number, 8, false, 0, 0},    {Kind::integer, 1, false, 0, 0},
    {Kind::integer, 2, false, 0, 0},   {Kind::integer, 4, false, 0, 0},   {Kind::integer, 8, false, 0, 0},
    {Kind::integer, 1, true, 0, 0},    {Kind::integer, 2, true, 0, 0},    {Kind::integer, 4, true, 0, 0},
    {Kind::integer, 8, true, 0, 0},    {Kind::extension, 0, false, 1, 1}, {Kind::extension, 0, false, 1, 2},
    {Kind::extension, 0, false, 1, 4}, {Kind::extension, 0, false, 1, 8}, {Kind::extension, 0, false, 1, 16},
    {Kind::text, 1, false, 0, 0},      {Kind::text, 2, false, 0, 0},      {Kind::text, 4, false, 0, 0},
    {Kind::list, 2, false, 0, 0},      {Kind::list, 4, false, 0, 0},      {Kind::map, 2, false, 0, 0},
    {Kind::map, 4, false, 0, 0},
}};

bool read_coded(const Coding& coding, const char* at, const char* end, Head& head) {
  if (static_cast<size_t>(end - at) < 1u + coding.bytes) return false;
  uint64_t raw = big_endian(at + 1, coding.bytes);
  head = {.kind = coding.kind, .size = static_cast<uint8_t>(1 + coding.bytes)};
  if (coding.kind == Kind::number) {
    head.number = coding.bytes == 4 ? static_cast<double>(std::bit_cast<float>(static_cast<uint32_t>(raw)))
                                    : std::bit_cast<double>(raw);
  } else if (coding.kind == Kind::integer) {
    if (coding.is_signed) {
      const int shift = 64 - 8 * coding.bytes;
      head.integer = static_cast<int64_t>(raw << shift) >> shift;
    } else {
      head.integer = static_cast<int64_t>(raw);
      if (raw > INT64_MAX) head.kind = Kind::large;
    }
  } else {
    head.count = static_cast<size_t>(raw) + coding.extra + coding.fixed_body;
  }
  return true;
}

[[noreturn]] void refuse_beyond(size_t most, std::string_view what) {
  throw Error(Code::limit, fmt::format("the message holds more than {} {}", most, what), {},
              "put large data into a shared array (array_create of interexpserv) and name it in the message");
}

}  // namespace

std::string_view name_of(Head::Kind kind) {
  constexpr std::array<std::string_view, 10> kNames = {
      "nothing", "a boolean", "an integer",  "an integer beyond 63 bits", "a number", "text", "bytes",
      "a list",  "a map",     "an extension"};
  return kNames[static_cast<size_t>(kind)];
}

bool read_long_head(const char* begin, const char* end, Head& head) {
  const auto code = static_cast<uint8_t>(*begin);
  if (code >= 0xc4) return read_coded(kCodings[code - 0xc4u], begin, end, head);
  if (code == 0xc1)
    throw Error(Code::protocol, "the byte 0xc1 is not MessagePack", {}, "send MessagePack-RPC messages only");
  head = {.kind = code == 0xc0 ? Kind::nil : Kind::boolean, .integer = code & 1, .size = 1};
  return true;
}

void Scanner::reset() {
  position_ = values_ = depth_ = 0;
  missing_ = 1;
}

// Steps into a list or map, or over the head of a body.
void Scanner::enter(const Head& head) {
  if (head.has_body()) {
    position_ += head.count;
    return;
  }
  const size_t values = head.kind == Kind::map ? 2 * head.count : head.count;
  values_ += values;
  if (values_ > kMaxMessageValues) refuse_beyond(kMaxMessageValues, "values");
  // Each value to come takes a byte at least.
  if (position_ + values > kMaxMessageBytes) refuse_beyond(kMaxMessageBytes, "bytes");
  if (depth_ == kMaxMessageDepth) refuse_beyond(kMaxMessageDepth, "levels");
  outer_[depth_++] = missing_;
  missing_ = values;
}

bool Scanner::scan(const char* begin, const char* end) {
  const auto available = static_cast<size_t>(end - begin);
  while (missing_ > 0) {
    // The bytes of a body are skipped before they are there; then the next head is not there either.
    if (position_ >= available) return false;
    const auto code = static_cast<uint8_t>(begin[position_]);
    const bool small = code < 0x80 || code >= 0xe0;
    const bool short_text = code >= 0xa0 && code < 0xc0;
    if (small || short_text) {  // most values, and nothing to check
      position_ += small ? 1 : 1 + (code & 0x1fu);
      --missing_;
    } else {
      Head head;
      if (!read_head(begin + position_, end, head)) return false;
      position_ += head.size;
      --missing_;
      if (head.count > 0) enter(head);
    }
    if (position_ > kMaxMessageBytes) refuse_beyond(kMaxMessageBytes, "bytes");
    while (missing_ == 0 && depth_ > 0) missing_ = outer_[--depth_];
  }
  return position_ <= available;
}

}  // namespace animado::rpc
