// src/base/hash.cpp
#include "base/hash.hpp"

#include <gtest/gtest.h>

#include <array>

namespace animado {
namespace {

uint64_t hash_of(std::string_view text) {
  Fnv1a hash;
  hash.add(text);
  return hash.value();
}

// The test vectors that the authors of FNV publish.
TEST(Fnv1a, PublishedValues) {
  EXPECT_EQ(hash_of(""), 0xcbf29ce484222325u);
  EXPECT_EQ(hash_of("a"), 0xaf63dc4c8601ec8cu);
  EXPECT_EQ(hash_of("foobar"), 0x85944171f73967e8u);
}

TEST(Fnv1a, PiecesAddUpToTheWhole) {
  Fnv1a hash;
  hash.add("foo");
  hash.add("bar");
  EXPECT_EQ(hash.value(), hash_of("foobar"));
}

TEST(Fnv1a, NumbersAreTheirBits) {
  const std::array one = {1.0}, next = {1.0 + 0x1p-52};
  Fnv1a numbers, bytes, other;
  numbers.add(one);
  bytes.add(std::string_view("\0\0\0\0\0\0\xF0\x3F", 8));
  other.add(next);
  EXPECT_EQ(numbers.value(), bytes.value());
  EXPECT_NE(numbers.value(), other.value());
}

TEST(Hex, KeepsItsZeros) {
  EXPECT_EQ(hex(0x2a), "000000000000002a");
  EXPECT_EQ(hex(0xFEDCBA9876543210u), "fedcba9876543210");
}

}  // namespace
}  // namespace animado
