// src/animado/matrix_market.cpp: what the format allows is read, and what is wrong is named with its line,
// whatever a file claims of itself.
#include "animado/matrix_market.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"

namespace animado {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

MarketMatrix parse(std::string_view text) {
  return parse_matrix_market(text, "A.mtx");
}

TEST(MatrixMarket, ReadsCoordinates) {
  const auto a = parse(
      "%%MatrixMarket matrix coordinate real general\n% a comment\n\n  3 2 3 \n1 1 2.5\n% another\n3 2 "
      "-1e3\r\n2 1 +7\n\n");
  EXPECT_TRUE(a.sparse);
  EXPECT_EQ(a.rows, 3);
  EXPECT_EQ(a.columns, 2);
  EXPECT_THAT(a.at_row, ElementsAre(0, 2, 1));
  EXPECT_THAT(a.at_column, ElementsAre(0, 1, 0));
  EXPECT_THAT(a.values, ElementsAre(2.5, -1000, 7));
  EXPECT_THAT(a.dense(), ElementsAre(2.5, 0, 7, 0, 0, -1000));
}

TEST(MatrixMarket, ReadsAnArrayColumnByColumn) {
  const auto a = parse("%%matrixmarket MATRIX Array Integer General\n2 3\n1\n4\n2\n5\n3\n6");
  EXPECT_FALSE(a.sparse);
  EXPECT_THAT(a.values, ElementsAre(1, 2, 3, 4, 5, 6));
}

TEST(MatrixMarket, FillsTheOtherHalfIn) {
  EXPECT_THAT(parse("%%MatrixMarket matrix array real symmetric\n2 2\n1\n2\n3\n").values,
              ElementsAre(1, 2, 2, 3));
  EXPECT_THAT(parse("%%MatrixMarket matrix array real skew-symmetric\n2 2\n5\n").values,
              ElementsAre(0, -5, 5, 0));
  EXPECT_THAT(parse("%%MatrixMarket matrix coordinate real symmetric\n2 2 2\n1 1 4\n2 1 3\n").dense(),
              ElementsAre(4, 3, 3, 0));
  EXPECT_THAT(parse("%%MatrixMarket matrix coordinate real skew-symmetric\n2 2 1\n2 1 3\n").dense(),
              ElementsAre(0, -3, 3, 0));
  EXPECT_THAT(parse("%%MatrixMarket matrix coordinate pattern symmetric\n2 2 2\n2 2\n2 1\n").dense(),
              ElementsAre(0, 1, 1, 1));
}

TEST(MatrixMarket, WhatStandsTwiceIsAddedUp) {
  EXPECT_THAT(parse("%%MatrixMarket matrix coordinate real general\n1 1 2\n1 1 2\n1 1 3\n").dense(),
              ElementsAre(5));
}

TEST(MatrixMarket, WhatItWritesItReads) {
  const std::vector<double> numbers{0.1, -1e300, 4.9e-324, 1.0 / 3, 0, -7};
  const auto back = parse(matrix_market_text(2, 3, numbers));
  EXPECT_EQ(back.rows, 2);
  EXPECT_EQ(back.values, numbers);
}

struct Bad {
  const char *text, *where, *what;
  Code code = Code::syntax;
};

class BadFile : public testing::TestWithParam<Bad> {};

#define REAL "%%MatrixMarket matrix coordinate real general\n"
#define ARRAY "%%MatrixMarket matrix array real general\n"
INSTANTIATE_TEST_SUITE_P(
    , BadFile,
    testing::Values(
        Bad{"", "A.mtx:1", "no Matrix Market file"}, Bad{"1 1\n1\n", "A.mtx:1", "no Matrix Market file"},
        Bad{"%%MatrixMarket vector array real general\n", "A.mtx:1", "`vector` as the kind of object"},
        Bad{"%%MatrixMarket matrix coordinate complex general\n", "A.mtx:1",
            "`complex` as the kind of numbers"},
        Bad{"%%MatrixMarket matrix coordinate real hermitian\n", "A.mtx:1", "`hermitian` as the symmetry"},
        Bad{"%%MatrixMarket matrix coordinate real\n", "A.mtx:1", "`` as the symmetry"},
        Bad{"%%MatrixMarket matrix coordinate real general \x1b[31m\n", "A.mtx:1", "`?[31m` is too much"},
        Bad{"%%MatrixMarket matrix array pattern general\n", "A.mtx:1", "a pattern"},
        Bad{REAL "%\n", "A.mtx:2", "ends before the size"},
        Bad{REAL "2 2\n", "A.mtx:2", "the number of entries is missing"},
        Bad{REAL "2 x 1\n", "A.mtx:2", "`x` is no integer"},
        Bad{REAL "2 2 1 1\n1 1 1\n", "A.mtx:2", "`1` is too much"},
        Bad{REAL "2 -2 1\n", "A.mtx:2", "the number of columns is -2"},
        Bad{REAL "2 99999999999999999999 1\n", "A.mtx:2", "the number of columns is 9999"},
        Bad{REAL "2 2 60000000\n1 1 1\n", "A.mtx:3", "the file ends after 1 of 60000000 entries"},
        Bad{REAL "2 2 1\n\n% here\n3 1 1\n", "A.mtx:5", "the row is 3"},
        Bad{REAL "2 2 1\n0 1 1\n", "A.mtx:3", "the row is 0"},
        Bad{REAL "2 2 1\n1 1.0 1\n", "A.mtx:3", "`1.0` is no integer"},
        Bad{REAL "2 2 1\n1 1\n", "A.mtx:3", "a value is missing"},
        Bad{REAL "2 2 1\n1 1 1e\n", "A.mtx:3", "`1e` is no number"},
        Bad{REAL "2 2 1\n1 1 1 1\n", "A.mtx:3", "`1` is too much"},
        Bad{REAL "2 2 1\n1 1 1\n2 2 1\n", "A.mtx:4", "there is more"},
        Bad{REAL "2 2 1\n1 1 nan\n", "A.mtx:3", "not a finite double", Code::not_finite},
        Bad{REAL "2 2 1\n1 1 1e999\n", "A.mtx:3", "not a finite double", Code::not_finite},
        Bad{"%%MatrixMarket matrix coordinate real symmetric\n2 2 1\n1 2 1\n", "A.mtx:3",
            "above the diagonal"},
        Bad{"%%MatrixMarket matrix coordinate real skew-symmetric\n2 2 1\n1 1 1\n", "A.mtx:3",
            "on the diagonal"},
        Bad{"%%MatrixMarket matrix coordinate real symmetric\n2 3 1\n", "A.mtx:2",
            "symmetric matrix of 2 × 3"},
        Bad{ARRAY "16777216 16777216\n1\n", "A.mtx:2", "more than the file can hold", Code::limit},
        Bad{ARRAY "8000 8000\n1\n", "A.mtx:2", "more than the file can hold", Code::limit},
        Bad{ARRAY "2 2\n1\n2\n3\n", "A.mtx:5", "the file ends before element (2, 2)"},
        Bad{ARRAY "1 1\n1 2\n", "A.mtx:3", "`2` is too much"}));

TEST_P(BadFile, IsRefusedWithItsLine) {
  try {
    parse(GetParam().text);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), GetParam().code) << error.what();
    EXPECT_EQ(error.where(), GetParam().where) << error.what();
    EXPECT_THAT(error.message(), HasSubstr(GetParam().what));
    EXPECT_FALSE(error.remedy().empty());
  }
}

// Cut anywhere, and with any byte changed, a file is read or refused: nothing else happens.
TEST(MatrixMarket, DamageIsReadOrRefused) {
  const std::string text =
      "%%MatrixMarket matrix coordinate real symmetric\n3 3 3\n1 1 2.5\n2 1 -1\n3 3 1e2\n";
  const auto try_it = [](std::string_view damaged) {
    try {
      parse(damaged);
    } catch (const Error& error) {
      EXPECT_THAT(error.where(), HasSubstr("A.mtx:"));
    }
  };
  for (size_t length = 0; length < text.size(); ++length) try_it(std::string_view(text).substr(0, length));
  for (size_t at = 0; at < text.size(); ++at) {
    for (const char byte : {'\0', '\n', ' ', '-', '9', 'e', '%', '\xff'}) {
      std::string damaged = text;
      damaged[at] = byte;
      try_it(damaged);
    }
  }
}

TEST(MatrixMarket, AFileThatIsNotThereIsNamed) {
  try {
    read_matrix_market("/nowhere/A.mtx");
    FAIL() << "read";
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "/nowhere/A.mtx");
  }
}

}  // namespace
}  // namespace animado
