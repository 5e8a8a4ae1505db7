// src/rpc/msgpack_head.cpp: the end of a message is found however it is cut, and a length is never believed.
#include "rpc/msgpack_head.hpp"

#include <gtest/gtest.h>

#include <msgpack.hpp>
#include <sstream>

#include "fixture.hpp"

namespace animado::rpc::testing {
namespace {

// One value of every type and size of length that msgpack-cxx writes.
std::string one_of_each() {
  std::stringstream text;
  msgpack::packer<std::stringstream> packer(text);
  const std::vector<size_t> sizes = {0, 1, 15, 16, 31, 32, 255, 256, 65535, 65536};
  packer.pack_array(static_cast<uint32_t>(6 + 4 * sizes.size()));
  packer.pack_nil();
  packer.pack_true();
  packer.pack_float(1.5f);
  packer.pack_double(-2.5);
  packer.pack_int64(INT64_MIN);
  packer.pack_uint64(UINT64_MAX);
  for (size_t size : sizes) {
    packer.pack(std::string(size, 's'));
    packer.pack(std::vector<char>(size, 'b'));  // bin
    packer.pack(std::vector<int>(size, 1));
    packer.pack_ext(size, 5);
    packer.pack_ext_body(std::string(size, 'e').data(), static_cast<uint32_t>(size));
  }
  return text.str();
}

TEST(Scanner, FindsTheEndOfWhatMsgpackWrites) {
  const std::string bytes = one_of_each();
  const std::string two = bytes + bytes;
  Scanner scanner;
  EXPECT_TRUE(scanner.scan(two.data(), two.data() + two.size()));
  EXPECT_EQ(scanner.size(), bytes.size());
}

TEST(Scanner, FindsItHoweverTheBytesArrive) {
  const std::string bytes = one_of_each();
  for (size_t step : {1u, 7u, 1000u}) {
    Scanner scanner;
    size_t available = 0;
    while (available < bytes.size()) {
      EXPECT_FALSE(scanner.scan(bytes.data(), bytes.data() + available)) << available;
      available = std::min(available + step, bytes.size());
    }
    EXPECT_TRUE(scanner.scan(bytes.data(), bytes.data() + available));
    EXPECT_EQ(scanner.size(), bytes.size());
  }
}

TEST(Scanner, AClaimBeyondTheLimitIsRefusedBeforeTheBytesCome) {
  const std::string gibibyte("\x40\x00\x00\x00", 4);
  for (char code : {'\xc6', '\xc9', '\xdb', '\xdd', '\xdf'}) {  // bin, extension, text, list, map
    const std::string bytes = std::string("\x94\x00\x01", 3) + code + gibibyte;
    Scanner scanner;
    EXPECT_EQ(error_of([&] { scanner.scan(bytes.data(), bytes.data() + bytes.size()); }).code(), Code::limit);
  }
}

TEST(Scanner, ValuesAndDepthAreLimited) {
  const std::string deep(kMaxMessageDepth + 1, '\x91');
  Scanner scanner;
  EXPECT_EQ(error_of([&] { scanner.scan(deep.data(), deep.data() + deep.size()); }).code(), Code::limit);
  // Many small lists, each allowed by itself.
  std::string many("\xdd\x00\x3f\xff\xff", 5);
  for (int i = 0; i < 100; ++i) many += "\x91\xc0";
  Scanner other;
  EXPECT_EQ(error_of([&] { other.scan(many.data(), many.data() + many.size()); }).code(), Code::limit);
}

TEST(Scanner, ManySmallValuesMayNotHoldMoreBytesThanOneLarge) {
  constexpr size_t kTexts = kMaxMessageBytes / 32 + 1;  // of 32 bytes with their heads
  static_assert(kTexts < kMaxMessageValues);
  std::string bytes = "\xdd";
  for (int shift : {24, 16, 8, 0}) bytes += static_cast<char>(kTexts >> shift);
  const std::string text = '\xbf' + std::string(31, 's');
  for (size_t i = 0; i < kTexts; ++i) bytes += text;
  Scanner scanner;
  EXPECT_EQ(error_of([&] { scanner.scan(bytes.data(), bytes.data() + bytes.size()); }).code(), Code::limit);
}

TEST(Scanner, TheUnusedByteIsNotMessagePack) {
  Scanner scanner;
  const char byte = '\xc1';
  EXPECT_EQ(error_of([&] { scanner.scan(&byte, &byte + 1); }).code(), Code::protocol);
}

}  // namespace
}  // namespace animado::rpc::testing
