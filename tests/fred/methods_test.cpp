// src/fred/methods.cpp: methods by name.
#include "fred/methods.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace animado::fred {
namespace {

TEST(Methods, IsFoundByNameWhateverTheCase) {
  EXPECT_EQ(method_named("RK4").name, "rk4");
}

TEST(Methods, AnUnknownNameGetsTheNearest) {
  try {
    method_named("rk39");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::unknown_name);
    EXPECT_NE(error.remedy().find("rk38"), std::string::npos) << error.remedy();
  }
}

}  // namespace
}  // namespace animado::fred
