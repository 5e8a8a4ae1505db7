// src/egesp/sparse_matrix.cpp: three ways to write a matrix down are one matrix, and wrong indices are named.
#include "egesp/sparse_matrix.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"

namespace animado::egesp {
namespace {

using testing::ElementsAre;
using Numbers = std::vector<double>;

SparseMatrix matrix(SparseFormat format, const Numbers& rows, const Numbers& columns, const Numbers& values) {
  return SparsePattern(format, 3, rows, columns, values.size()).matrix(values);
}

// (1 0 2; 0 3 0; 4 0 5)
void expect_example(const SparseMatrix& a) {
  EXPECT_THAT(a.starts, ElementsAre(0, 2, 3, 5));
  EXPECT_THAT(a.rows, ElementsAre(0, 2, 1, 0, 2));
  EXPECT_THAT(a.values, ElementsAre(1, 4, 3, 2, 5));
}

TEST(SparseMatrix, OfTripletsInAnyOrder) {
  expect_example(matrix(SparseFormat::triplets, {2, 0, 1, 0, 2}, {2, 2, 1, 0, 0}, {5, 2, 3, 1, 4}));
}

TEST(SparseMatrix, OfCompressedRowsAndColumns) {
  expect_example(matrix(SparseFormat::csr, {0, 2, 3, 5}, {2, 0, 1, 0, 2}, {2, 1, 3, 4, 5}));
  expect_example(matrix(SparseFormat::csc, {2, 0, 1, 0, 2}, {0, 2, 3, 5}, {4, 1, 3, 2, 5}));
}

TEST(SparseMatrix, WhatIsGivenTwiceIsAddedUp) {
  const auto a = matrix(SparseFormat::triplets, {1, 0, 1, 1}, {1, 0, 1, 2}, {2, 1, 3, 9});
  EXPECT_THAT(a.rows, ElementsAre(0, 1, 1));
  EXPECT_THAT(a.values, ElementsAre(1, 5, 9));
}

struct Wrong {
  SparseFormat format;
  Numbers rows, columns;
  size_t count;
  Code code;
  const char* where;
};

class WrongPattern : public testing::TestWithParam<Wrong> {};

INSTANTIATE_TEST_SUITE_P(
    , WrongPattern,
    testing::Values(Wrong{SparseFormat::triplets, {0, 3}, {0, 0}, 2, Code::bad_params, "rows[1]"},
                    Wrong{SparseFormat::triplets, {0, 1}, {-1, 0}, 2, Code::bad_params, "columns[0]"},
                    Wrong{SparseFormat::triplets, {0, 0.5}, {0, 0}, 2, Code::bad_params, "rows[1]"},
                    Wrong{SparseFormat::triplets, {0, 1e300}, {0, 0}, 2, Code::bad_params, "rows[1]"},
                    Wrong{SparseFormat::triplets, {0, std::nan("")}, {0, 0}, 2, Code::bad_params, "rows[1]"},
                    Wrong{SparseFormat::triplets, {0}, {0, 0}, 2, Code::bad_shape, "rows"},
                    Wrong{SparseFormat::csr, {0, 1, 2}, {0, 0}, 2, Code::bad_shape, "rows"},
                    Wrong{SparseFormat::csr, {0, 2, 1, 2}, {0, 0}, 2, Code::bad_params, "rows[1]"},
                    Wrong{SparseFormat::csr, {1, 1, 1, 2}, {0, 0}, 2, Code::bad_params, "rows[0]"},
                    Wrong{SparseFormat::csr, {0, 1, 1, 1}, {0, 0}, 2, Code::bad_shape, "rows"},
                    Wrong{SparseFormat::csr, {0, 1, 1, 3}, {0, 0}, 2, Code::bad_params, "rows[3]"},
                    Wrong{SparseFormat::csc, {0, 0}, {0, 1, 2}, 2, Code::bad_shape, "columns"}));

TEST_P(WrongPattern, IsRefusedAndNamed) {
  const Wrong& wrong = GetParam();
  try {
    SparsePattern(wrong.format, 3, wrong.rows, wrong.columns, wrong.count);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), wrong.code) << error.what();
    EXPECT_EQ(error.where(), wrong.where);
    EXPECT_FALSE(error.remedy().empty());
  }
}

TEST(SparseMatrix, SizesOutOfRangeAreRefused) {
  for (const int64_t size : {int64_t{-1}, int64_t{0}, int64_t{1} << 40})
    EXPECT_THROW(SparsePattern(SparseFormat::triplets, size, {}, {}, 0), Error) << size;
}

}  // namespace
}  // namespace animado::egesp
