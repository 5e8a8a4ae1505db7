// src/report/gzip.cpp: what is packed is unpacked as it was, and the same bytes make the same stream.
#include "report/gzip.hpp"

#include <gtest/gtest.h>

#include "tests/report/unpacked.hpp"

namespace animado::report {
namespace {

TEST(Gzip, IsUnpackedAsItWas) {
  std::string text;
  for (int k = 0; k < 100'000; ++k) text += std::to_string(k);
  for (const std::string& bytes : {std::string(), std::string("a"), std::string(3, '\0'), text})
    EXPECT_EQ(gunzipped(gzip(bytes)), bytes);
}

TEST(Gzip, IsASmallerTextThatNamesNoTime) {
  const std::string packed = gzip(std::string(10'000, 'x'));
  EXPECT_LT(packed.size(), 100u);
  EXPECT_EQ(packed.substr(0, 3), "\x1f\x8b\x08");
  EXPECT_EQ(packed.substr(4, 4), std::string(4, '\0'));  // the time stamp
}

}  // namespace
}  // namespace animado::report
