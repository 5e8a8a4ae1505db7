// src/animado/run_report.cpp: a page that cannot be made is told with its remedy, and no exception leaves.
#include "animado/run_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/temporary_directory.hpp"

namespace animado {
namespace {

#if ANIMADO_WEB
TEST(RunReport, ThatCannotBeMadeSpoilsNothing) {
  const TemporaryDirectory empty;
  testing::internal::CaptureStderr();
  EXPECT_NO_THROW(add_report(empty, "runs/colisao"));
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, testing::HasSubstr("error: runs/colisao/report.html: no page of the run: "));
  EXPECT_THAT(said, testing::HasSubstr("animado report runs/colisao\n"));
  EXPECT_TRUE(std::filesystem::is_empty(empty.path()));
}
#else
TEST(RunReport, OfAProgramWithoutThePageSaysNothing) {
  const TemporaryDirectory empty;
  testing::internal::CaptureStderr();
  add_report(empty, "runs/colisao");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}
#endif

}  // namespace
}  // namespace animado
