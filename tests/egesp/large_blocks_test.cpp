// src/egesp/large_blocks.cpp: what is kept for whom, and that nothing is lost on the way.
#include "egesp/large_blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace animado::egesp {
namespace {

constexpr size_t kPage = LargeBlocks::kPage;

char* filled(LargeBlocks& blocks, size_t bytes, char with) {
  auto* const memory = static_cast<char*>(blocks.allocate(bytes));
  std::fill_n(memory, bytes, with);
  return memory;
}

bool holds(const char* memory, size_t bytes, char what) {
  return std::all_of(memory, memory + bytes, [what](char c) { return c == what; });
}

TEST(LargeBlocks, ALargeOneBeginsWithAPageAndIsKeptForWhoAsksForAsMuch) {
  LargeBlocks blocks;
  char* const first = filled(blocks, 5 * kPage + 1, 'a');
  EXPECT_EQ(reinterpret_cast<uintptr_t>(first) % kPage, 0);
  blocks.release(first);
  EXPECT_EQ(blocks.kept(), 6 * kPage);
  EXPECT_EQ(blocks.allocate(6 * kPage), first);
  EXPECT_EQ(blocks.kept(), 0);
  blocks.release(first);
}

TEST(LargeBlocks, TheSmallestThatFitsIsTakenAndNoneThatIsTwiceAsLarge) {
  LargeBlocks blocks;
  void* const five = blocks.allocate(5 * kPage);
  void* const eight = blocks.allocate(8 * kPage);
  blocks.release(eight);
  blocks.release(five);
  EXPECT_EQ(blocks.allocate(4 * kPage), five);
  void* const three = blocks.allocate(3 * kPage);
  EXPECT_NE(three, eight);
  EXPECT_EQ(blocks.kept(), 8 * kPage);
  blocks.release(three);
  blocks.release(five);
}

TEST(LargeBlocks, WhatIsInUseIsGivenToNobodyElse) {
  LargeBlocks blocks;
  char* const a = filled(blocks, 2 * kPage, 'a');
  char* const b = filled(blocks, 2 * kPage, 'b');
  EXPECT_TRUE(holds(a, 2 * kPage, 'a') && holds(b, 2 * kPage, 'b'));
  blocks.release(a);
  blocks.release(b);
}

TEST(LargeBlocks, KeepsItsContentWhenItGrowsAndStaysWhereItShrinks) {
  LargeBlocks blocks;
  char* memory = filled(blocks, 2 * kPage, 'a');
  char* const grown = static_cast<char*>(blocks.resize(memory, 20 * kPage));
  EXPECT_TRUE(holds(grown, 2 * kPage, 'a'));
  EXPECT_EQ(blocks.kept(), 2 * kPage);
  EXPECT_EQ(blocks.resize(grown, 10), grown);
  blocks.release(grown);
}

TEST(LargeBlocks, ASmallOneIsMallocs) {
  LargeBlocks blocks;
  char* const small = filled(blocks, 100, 'a');
  char* const large = static_cast<char*>(blocks.resize(small, 3 * kPage));
  EXPECT_TRUE(holds(large, 100, 'a'));
  blocks.release(large);
  EXPECT_EQ(blocks.kept(), 0);
  blocks.release(blocks.resize(nullptr, 100));
  blocks.release(nullptr);
}

TEST(LargeBlocks, ThereIsALimitToOneAndToAllThatAreKept) {
  LargeBlocks blocks;
  EXPECT_EQ(blocks.allocate(LargeBlocks::kLargest + 1), nullptr);
  void* const some = blocks.allocate(kPage);
  EXPECT_EQ(blocks.resize(some, LargeBlocks::kLargest + 1), nullptr);
  blocks.release(some);
  std::array<void*, 4> many;
  for (void*& one : many) one = blocks.allocate(LargeBlocks::kMostKept / 2 - kPage);
  for (void* one : many) blocks.release(one);
  EXPECT_LE(blocks.kept(), LargeBlocks::kMostKept);
  EXPECT_EQ(blocks.allocate(LargeBlocks::kMostKept / 2 - kPage), many[2]);  // the last ones are kept
  blocks.release(many[2]);
  blocks.release(blocks.allocate(LargeBlocks::kMostKept + 1));
  EXPECT_LE(blocks.kept(), LargeBlocks::kMostKept);
}

}  // namespace
}  // namespace animado::egesp
