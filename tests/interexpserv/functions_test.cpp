// src/interexpserv/functions.cpp: the list, and docs/expressions.md beside it.
#include "interexpserv/functions.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

namespace animado::interexpserv {
namespace {

constexpr std::array<std::string_view, 38> kPromised = {
    "sin",       "cos", "tan",   "asin",  "acos",   "atan",  "atan2",      "sinh",  "cosh",  "tanh",
    "exp",       "log", "log10", "sqrt",  "cbrt",   "abs",   "sign",       "floor", "ceil",  "round",
    "min",       "max", "clamp", "mod",   "hypot",  "step",  "smoothstep", "dot",   "cross", "norm",
    "normalize", "not", "if",    "table", "random", "gauss", "noise",      "d"};

TEST(Functions, AllThatTheLanguagePromisesAreThere) {
  for (const std::string_view name : kPromised) EXPECT_TRUE(is_function(name)) << name;
}

TEST(Functions, NoTwoRowsTakeTheSame) {
  std::set<std::string> seen;
  for (const Function& f : functions()) {
    EXPECT_TRUE(seen.insert(std::string(f.name) + std::string(f.parameters)).second) << f.name;
    EXPECT_FALSE(f.doc.empty()) << f.name;
  }
}

TEST(Functions, SignaturesAreWrittenOut) {
  const std::array<Operand, 2> two = {Operand::scalar(0), Operand::scalar(0)};
  EXPECT_EQ(signature_of(*find_function("min", two)), "(scalar, scalar, …)");
  EXPECT_EQ(signature_of(*find_function("atan2", two)), "(scalar, scalar)");
  EXPECT_EQ(find_function("sin", two), nullptr);
}

// One row of the page's table for each row of the list, in its order.
TEST(Functions, ThePageListsThem) {
  std::string expected = "| name | takes | yields | meaning |\n|---|---|---|---|\n";
  for (const Function& f : functions()) {
    expected += "| `" + std::string(f.name) + "` | " + signature_of(f) + " | " +
                std::string(name_of(f.result)) + " | " + std::string(f.doc) + " |\n";
  }
  std::ifstream file(ANIMADO_SOURCE_DIR "/docs/expressions.md");
  std::stringstream page;
  page << file.rdbuf();
  EXPECT_NE(page.str().find(expected), std::string::npos) << "put this table into docs/expressions.md:\n"
                                                          << expected;
}

}  // namespace
}  // namespace animado::interexpserv
