// Writes MessagePack to the end of a buffer. What most values are, a byte, is written here; the rest by
// msgpack-cxx, which stays behind this class, so that who sends messages does not compile it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace animado::rpc {

class Encoder {
 public:
  explicit Encoder(std::string& out) : out_(out) {}

  void nil() { byte(0xc0); }
  void boolean(bool value) { byte(value ? 0xc3 : 0xc2); }
  void integer(int64_t value) {
    value >= 0 && value < 128 ? byte(static_cast<uint8_t>(value)) : long_integer(value);
  }
  void number(double value);  // always as float64: 2.0 stays a number, −0.0 keeps its sign
  void text(std::string_view value) {
    value.size() < 32 ? byte(static_cast<uint8_t>(0xa0 | value.size())) : long_text_head(value.size());
    out_.append(value);
  }
  // `count` values follow.
  void list(size_t count) { count < 16 ? byte(static_cast<uint8_t>(0x90 | count)) : long_list(count); }
  // `count` pairs follow.
  void map(size_t count) { count < 16 ? byte(static_cast<uint8_t>(0x80 | count)) : long_map(count); }
  void numbers(std::span<const double> values);               // bytes: little-endian float64
  void raw(std::string_view packed) { out_.append(packed); }  // one value, packed elsewhere

 private:
  void byte(uint8_t code) { out_.push_back(static_cast<char>(code)); }
  void long_integer(int64_t value);
  void long_text_head(size_t bytes);
  void long_list(size_t count);
  void long_map(size_t count);

  std::string& out_;
};

}  // namespace animado::rpc
