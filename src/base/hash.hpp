// A hash that names content: scenes and final states are compared by it across runs and machines. It is no
// guard against someone who wants two contents to collide.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace animado {

// FNV-1a, 64 bits (Fowler, Noll, Vo). Bytes may be added in pieces: the value depends on their
// sequence alone.
class Fnv1a {
 public:
  void add(std::span<const std::byte> bytes);
  void add(std::string_view text) { add(std::as_bytes(std::span(text))); }
  void add(std::span<const double> numbers) { add(std::as_bytes(numbers)); }  // their bits, little-endian
  uint64_t value() const { return value_; }

 private:
  uint64_t value_ = 0xcbf29ce484222325u;
};

std::string hex(uint64_t value);  // 16 digits, lower case

}  // namespace animado
