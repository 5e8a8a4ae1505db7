// Writes MessagePack to the end of a buffer. msgpack-cxx stays behind this class, so that who sends messages
// does not compile it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace animado::rpc {

class Encoder {
 public:
  explicit Encoder(std::string& out) : out_(out) {}

  void nil();
  void boolean(bool value);
  void integer(int64_t value);
  void number(double value);  // always as float64: 2.0 stays a number, −0.0 keeps its sign
  void text(std::string_view value);
  void list(size_t count);                       // `count` values follow
  void map(size_t count);                        // `count` pairs follow
  void numbers(std::span<const double> values);  // bytes: little-endian float64
  void raw(std::string_view packed);             // one value, packed elsewhere

 private:
  std::string& out_;
};

}  // namespace animado::rpc
