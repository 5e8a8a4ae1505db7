#include "base/hash.hpp"

#include <fmt/format.h>

namespace animado {

void Fnv1a::add(std::span<const std::byte> bytes) {
  constexpr uint64_t kPrime = 0x100000001b3u;
  for (const std::byte byte : bytes) value_ = (value_ ^ static_cast<uint64_t>(byte)) * kPrime;
}

std::string hex(uint64_t value) {
  return fmt::format("{:016x}", value);
}

}  // namespace animado
