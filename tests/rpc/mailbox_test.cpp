// src/rpc/mailbox.cpp: letters, by themselves.
#include <sys/mman.h>

#include "raw.hpp"

namespace animado::rpc::testing {
namespace {

std::string taken(Mailbox& mailbox) {
  std::string letter(Mailbox::kRoom, '\0');
  letter.resize(mailbox.take(letter.data()).value());
  return letter;
}

struct Pair {
  Mailbox server = Mailbox::make(), client = Mailbox::open(copies(server.descriptors()));
};

TEST(Mailbox, LettersGoBothWays) {
  Pair pair;
  EXPECT_FALSE(pair.server.has_letter());
  EXPECT_FALSE(is_readable(pair.server.bell()));
  EXPECT_TRUE(pair.client.put("what"));
  EXPECT_TRUE(is_readable(pair.server.bell()));
  EXPECT_FALSE(is_readable(pair.client.bell()));
  EXPECT_TRUE(pair.server.has_letter());
  EXPECT_FALSE(pair.client.has_letter());
  EXPECT_EQ(taken(pair.server), "what");
  EXPECT_FALSE(pair.server.has_letter());
  EXPECT_TRUE(pair.server.put("that"));
  EXPECT_TRUE(is_readable(pair.client.bell()));
  EXPECT_EQ(taken(pair.client), "that");
}

TEST(Mailbox, WhoIsAwakeIsNotRungFor) {
  Pair pair;
  pair.server.stay_awake();
  EXPECT_TRUE(pair.client.put("a"));
  EXPECT_FALSE(is_readable(pair.server.bell()));
  EXPECT_FALSE(pair.server.fall_asleep());
  EXPECT_EQ(taken(pair.server), "a");
  EXPECT_TRUE(pair.server.fall_asleep());
  EXPECT_TRUE(pair.client.put("b"));
  EXPECT_TRUE(is_readable(pair.server.bell()));
}

TEST(Mailbox, ALetterThatIsTooLongIsNotPut) {
  Pair pair;
  const std::string full(Mailbox::kRoom, 'x');
  EXPECT_FALSE(pair.client.put(full + "x"));
  EXPECT_FALSE(pair.server.has_letter());
  EXPECT_TRUE(pair.client.put(full));
  EXPECT_EQ(taken(pair.server), full);
}

TEST(Mailbox, ASizeThatCannotBeIsNotBelieved) {
  Pair pair;
  auto* pages = static_cast<uint32_t*>(
      mmap(nullptr, 8192, PROT_READ | PROT_WRITE, MAP_SHARED, pair.server.descriptors()[0], 0));
  ASSERT_NE(pages, MAP_FAILED);
  pages[1] = Mailbox::kRoom + 1;
  pages[0] = 1;
  EXPECT_TRUE(pair.server.has_letter());
  std::string letter(Mailbox::kRoom, '\0');
  EXPECT_FALSE(pair.server.take(letter.data()).has_value());
  munmap(pages, 8192);
}

TEST(Mailbox, IsOpenedFromThreeDescriptorsOfOneOnly) {
  const Mailbox server = Mailbox::make();
  EXPECT_EQ(error_of([&] { Mailbox::open({}); }).code(), Code::bad_shape);
  EXPECT_EQ(error_of([&] { Mailbox::open(copies(std::array{0, 1, 2})); }).code(), Code::bad_shape);
}

}  // namespace
}  // namespace animado::rpc::testing
