// src/interexpserv/published.hpp: a reader never sees half a picture.
#include "interexpserv/published.hpp"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace animado::interexpserv {
namespace {

TEST(Published, AReaderSeesWhatWasPublished) {
  std::vector<double> array(4, 0), copy(4, 0);
  publish(array, std::vector<double>{1, 2, 3});
  EXPECT_TRUE(read_published(array, copy));
  EXPECT_EQ(copy, (std::vector<double>{2, 1, 2, 3}));
}

TEST(Published, NothingIsReadWhileTheWriterIsAtWork) {
  std::vector<double> array = {1, 5}, copy(2, 0);
  EXPECT_FALSE(read_published(array, copy));
  publish(array, std::vector<double>{6});  // the next writer mends what a dead one left
  EXPECT_TRUE(read_published(array, copy));
  EXPECT_EQ(copy, (std::vector<double>{4, 6}));
}

// The writer always publishes equal numbers: a torn picture would hold two different ones.
TEST(Published, PicturesAreWhole) {
  constexpr int kPictures = 20'000;
  std::vector<double> array(65, 0), copy(65, 0);
  std::thread writer([&] {
    std::vector<double> picture(64);
    for (int i = 1; i <= kPictures; ++i) {
      picture.assign(64, i);
      publish(array, picture);
    }
  });
  double last = 0;
  while (last < kPictures) {
    if (!read_published(array, copy)) {
      std::this_thread::yield();
      continue;
    }
    for (size_t i = 2; i < copy.size(); ++i) ASSERT_EQ(copy[i], copy[1]);
    ASSERT_GE(copy[1], last);
    last = copy[1];
  }
  writer.join();
}

}  // namespace
}  // namespace animado::interexpserv
