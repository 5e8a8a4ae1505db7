// src/report/blocks.cpp: numbers are where the index says, and as near to what they were as sixteen bits
// allow.
#include "report/blocks.hpp"

#include <gtest/gtest.h>

#include <cstring>

namespace animado::report {
namespace {

template <class Number>
std::vector<Number> numbers_in(const Blocks& blocks, const std::string& name) {
  const auto& entry = blocks.index().at(name);
  std::vector<Number> numbers(entry.at("count").get<size_t>());
  std::memcpy(numbers.data(), blocks.bytes().data() + entry.at("offset").get<size_t>(),
              numbers.size() * sizeof(Number));
  return numbers;
}

TEST(Blocks, NumbersAreAsTheyWere) {
  Blocks blocks;
  blocks.add("a", std::vector{1e-300, -0.1, 1e300});
  EXPECT_EQ(blocks.index().at("a").at("type"), "f64");
  EXPECT_EQ(numbers_in<double>(blocks, "a"), (std::vector{1e-300, -0.1, 1e300}));
}

TEST(Blocks, EachBeginsAtAMultipleOfEight) {
  Blocks blocks;
  blocks.add_vectors("odd", {{Vec3(1, 2, 3)}});  // six bytes
  blocks.add("next", std::vector{0.5});
  EXPECT_EQ(blocks.index().at("next").at("offset"), 8);
  EXPECT_EQ(blocks.bytes().size(), 16u);
}

TEST(Blocks, VectorsLieBetweenTheirBodysLowestAndHighest) {
  const std::vector<std::vector<Vec3>> bodies = {{{0, -5, 7}, {1, 5, 7}, {0.25, 0, 7}}, {{1e6, 0, -1e-6}}};
  Blocks blocks;
  blocks.add_vectors("v", bodies);
  const std::vector<double> low = blocks.index().at("v").at("low"), high = blocks.index().at("v").at("high");
  EXPECT_EQ(low, (std::vector<double>{0, -5, 7, 1e6, 0, -1e-6}));
  EXPECT_EQ(high, (std::vector<double>{1, 5, 7, 1e6, 0, -1e-6}));
  const auto numbers = numbers_in<uint16_t>(blocks, "v");
  ASSERT_EQ(numbers.size(), 12u);
  size_t at = 0;
  for (size_t body = 0; body < bodies.size(); ++body) {
    for (const Vec3& v : bodies[body]) {
      for (size_t k = 0; k < 3; ++k, ++at) {
        const double from = low[3 * body + k], to = high[3 * body + k];
        EXPECT_NEAR(from + numbers[at] / 65535.0 * (to - from), v[static_cast<int>(k)], (to - from) / 131000);
      }
    }
  }
}

TEST(Blocks, RotationsAreUnitAndTakeNoDetour) {
  std::vector<Quat> frames;
  for (int k = 0; k < 100; ++k) {
    Quat q(Eigen::AngleAxisd(0.1 * k, Vec3(1, 2, 3).normalized()));
    if (k % 3 == 0) q.coeffs() = -q.coeffs();  // the same rotation
    frames.push_back(q);
  }
  Blocks blocks;
  blocks.add_rotations("r", {frames});
  const auto numbers = numbers_in<int16_t>(blocks, "r");
  ASSERT_EQ(numbers.size(), 400u);
  Quat last = Quat::Identity();
  for (size_t k = 0; k < frames.size(); ++k) {
    const auto part = [&](size_t c) { return numbers[4 * k + c] / 32767.0; };
    const Quat read(part(0), part(1), part(2), part(3));
    EXPECT_NEAR(read.norm(), 1, 1e-4);
    EXPECT_LT(read.normalized().angularDistance(frames[k]), 1e-4) << k;
    EXPECT_GT(read.dot(last), 0) << k;
    last = read;
  }
}

}  // namespace
}  // namespace animado::report
