// src/egesp/handles.cpp: a handle belongs to one connection, and ends with it.
#include "egesp/handles.hpp"

#include <gtest/gtest.h>

namespace animado::egesp {
namespace {

struct Thing : Kept {
  explicit Thing(size_t holds, int* ended = nullptr) : holds_(holds), ended_(ended) {}
  ~Thing() override {
    if (ended_) ++*ended_;
  }
  size_t bytes() const override { return holds_; }
  size_t holds_;
  int* ended_;
};
struct OtherThing : Kept {
  size_t bytes() const override { return 0; }
};

TEST(Handles, AreFoundByTheirOwnerAndByTheirKind) {
  Handles handles;
  const int64_t handle = handles.keep(1, std::make_unique<Thing>(5));
  EXPECT_EQ(handles.find<Thing>(1, handle, "thing").bytes(), 5u);
  for (const auto& wrong : {std::pair<uint64_t, int64_t>{2, handle}, {1, handle + 1}, {1, 0}, {1, -1}}) {
    try {
      handles.find<Thing>(wrong.first, wrong.second, "thing");
      FAIL() << wrong.second;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Code::unknown_handle);
    }
  }
  EXPECT_THROW(handles.find<OtherThing>(1, handle, "other thing"), Error);
}

TEST(Handles, EndWithTheirReleaseOrTheirConnection) {
  Handles handles;
  int ended = 0;
  const int64_t first = handles.keep(1, std::make_unique<Thing>(1, &ended));
  handles.keep(1, std::make_unique<Thing>(1, &ended));
  const int64_t of_another = handles.keep(2, std::make_unique<Thing>(1, &ended));
  EXPECT_FALSE(handles.release(2, first)) << "it belongs to another";
  EXPECT_TRUE(handles.release(1, first));
  EXPECT_FALSE(handles.release(1, first)) << "a repeated request";
  EXPECT_EQ(ended, 1);
  handles.end(1);
  EXPECT_EQ(ended, 2);
  EXPECT_EQ(handles.find<Thing>(2, of_another, "thing").bytes(), 1u);
  EXPECT_GT(handles.keep(1, std::make_unique<Thing>(1)), of_another) << "a number is never used twice";
}

TEST(Handles, OneConnectionMayKeepSoMuchAndNoMore) {
  Handles handles;
  const int64_t large = handles.keep(1, std::make_unique<Thing>(kLargestPrepared - 1));
  EXPECT_THROW(handles.keep(1, std::make_unique<Thing>(2)), Error);
  handles.keep(2, std::make_unique<Thing>(2));
  handles.release(1, large);
  handles.keep(1, std::make_unique<Thing>(2));
}

}  // namespace
}  // namespace animado::egesp
