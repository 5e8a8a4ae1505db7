// src/rpc/histogram.cpp
#include "rpc/histogram.hpp"

#include <gtest/gtest.h>

namespace animado::rpc {
namespace {

using std::chrono::microseconds;
using std::chrono::nanoseconds;

TEST(Histogram, CountsEachTimeWhereItBelongs) {
  for (int64_t ns : {int64_t{0}, int64_t{1}, int64_t{15}, int64_t{16}, int64_t{17}, int64_t{1000},
                     int64_t{123'456'789}, int64_t{1} << 39, (int64_t{1} << 40) - 1}) {
    Histogram histogram;
    histogram.count(nanoseconds(ns));
    ASSERT_EQ(histogram.rows().size(), 1u) << ns;
    const double below_ns = 1e3 * histogram.rows()[0].below_us;
    EXPECT_GT(below_ns, static_cast<double>(ns)) << ns;
    EXPECT_LE(below_ns, 1.125 * static_cast<double>(ns) + 1) << ns;  // an eighth of an octave
  }
  Histogram histogram;
  histogram.count(nanoseconds(-5));
  histogram.count(std::chrono::hours(5));
  EXPECT_EQ(histogram.rows().size(), 2u);
}

TEST(Histogram, QuantilesOfAKnownDistribution) {
  Histogram histogram;
  for (int i = 1; i <= 1000; ++i) histogram.count(microseconds(i));
  const auto rows = histogram.rows();
  for (const double part : {0.01, 0.5, 0.9, 0.99, 1.0}) {
    EXPECT_GE(quantile_us(rows, part), 1000 * part);
    EXPECT_LE(quantile_us(rows, part), 1.126 * 1000 * part);
  }
  EXPECT_EQ(quantile_us({}, 0.5), 0);
}

TEST(Histogram, TellsWhatWasCountedSince) {
  Histogram histogram;
  for (int i = 0; i < 10; ++i) histogram.count(microseconds(5));
  const auto before = histogram.rows();
  histogram.count(microseconds(5));
  histogram.count(microseconds(1));
  histogram.count(microseconds(700));
  const auto rows = since(histogram.rows(), before);
  ASSERT_EQ(rows.size(), 3u);
  for (const auto& row : rows) EXPECT_EQ(row.requests, 1);
  EXPECT_LT(rows[0].below_us, rows[1].below_us);
  EXPECT_TRUE(since(before, before).empty());
  EXPECT_EQ(since(before, {}).size(), before.size());
}

}  // namespace
}  // namespace animado::rpc
