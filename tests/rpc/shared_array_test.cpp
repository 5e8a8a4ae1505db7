// src/rpc/shared_array.cpp: seals, sizes, and no descriptor left behind.
#include "rpc/shared_array.hpp"

#include <sys/mman.h>

#include "fixture.hpp"

namespace animado::rpc::testing {
namespace {

UniqueFd unsealed(size_t bytes) {
  UniqueFd fd(memfd_create("test", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  EXPECT_EQ(ftruncate(fd.get(), static_cast<off_t>(bytes)), 0);
  return fd;
}

size_t open_descriptors() {
  return static_cast<size_t>(
      std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator()));
}

TEST(SharedArray, TwoMappingsOfItSeeTheSameNumbers) {
  UniqueFd fd = SharedArray::make("a", {2, 3});
  const SharedArray one(UniqueFd(dup(fd.get())), {2, 3}, "a"), two(std::move(fd), {2, 3}, "a");
  EXPECT_EQ(one.values().size(), 6u);
  EXPECT_EQ(one.values()[5], 0);
  one.values()[5] = 42;
  EXPECT_EQ(two.values()[5], 42);
}

TEST(SharedArray, ItsSizeIsSealed) {
  const UniqueFd fd = SharedArray::make("a", {4});
  EXPECT_NE(ftruncate(fd.get(), 0), 0);
  EXPECT_NE(ftruncate(fd.get(), 1 << 20), 0);
}

TEST(SharedArray, AnEmptyOneIsAllowed) {
  EXPECT_TRUE(SharedArray(SharedArray::make("a", {0, 3}), {0, 3}, "a").values().empty());
}

TEST(SharedArray, WhatCouldShrinkUnderUsIsRefused) {
  EXPECT_EQ(error_of([] { SharedArray(unsealed(32), {4}, "a"); }).code(), Code::bad_shape);
  EXPECT_EQ(error_of([] { SharedArray(SharedArray::make("a", {3}), {4}, "a"); }).code(), Code::bad_shape);
  EXPECT_EQ(error_of([] { SharedArray(UniqueFd(), {4}, "a"); }).code(), Code::bad_shape);
}

TEST(SharedArray, ImpossibleShapesAreRefused) {
  EXPECT_EQ(error_of([] { SharedArray::make("a", {-1}); }).code(), Code::bad_shape);
  EXPECT_EQ(error_of([] { SharedArray::make("a", {1l << 40, 1l << 40}); }).code(), Code::bad_shape);
}

class SharedArraysTest : public SocketTest {
 protected:
  Served names_{directory_, "interexpserv", fill_names};
};

TEST_F(SharedArraysTest, OldMappingsGoAndDescriptorsWithThem) {
  SocketSuite maker(options()), user(options());
  for (size_t i = 0; i < SharedArrays::kMaxOpened; ++i)
    maker.arrays().create(fmt::format("a{}", i), {1}).values()[0] = double(i);
  for (size_t i = 0; i < SharedArrays::kMaxOpened; ++i) user.arrays().open(fmt::format("a{}", i));
  // The server, a thread of this process, closes its copy of what it sent before it answers again.
  const auto settled = [&] {
    user.channel(std::string(kWellKnown)).call<Ping>({});
    return open_descriptors();
  };
  const size_t before = settled();
  for (size_t i = 0; i < 200; ++i) {
    const std::string name = fmt::format("b{}", i);
    maker.arrays().create(name, {1}).values()[0] = 0.5;
    EXPECT_EQ(user.arrays().open(name).values()[0], 0.5);
    maker.arrays().drop(name);
  }
  EXPECT_EQ(user.arrays().open("a3").values()[0], 3);
  EXPECT_EQ(settled(), before + 200) << "those that interexpserv itself keeps";
}

TEST_F(SharedArraysTest, ANameIsUsedOnce) {
  SocketSuite suite(options());
  suite.arrays().create("a", {1});
  EXPECT_EQ(error_of([&] { suite.arrays().create("a", {1}); }).code(), Code::conflict);
  EXPECT_EQ(error_of([&] { suite.arrays().open("b"); }).code(), Code::unknown_array);
}

TEST_F(SharedArraysTest, ARequestMayNotReachBeyondAnArray) {
  SocketSuite suite(options());
  suite.arrays().create("a", {4});
  ServedCall call(1, suite);
  EXPECT_EQ(call.read(Array::named("a", {2}, 2)).size(), 2u);
  for (const Array& array : {Array::named("a", {5}), Array::named("a", {2}, 3), Array::named("a", {1}, -1)}) {
    EXPECT_EQ(error_of([&] { call.read(array); }).code(), Code::bad_shape);
    EXPECT_EQ(error_of([&] { call.write(array); }).code(), Code::bad_shape);
  }
  EXPECT_EQ(error_of([&] { call.write(Array::inlined({1}, {1})); }).code(), Code::bad_params);
  EXPECT_EQ(error_of([&] { call.read(Array::inlined({2}, {1})); }).code(), Code::bad_shape);
}

}  // namespace
}  // namespace animado::rpc::testing
