// src/report/page.cpp: the page holds the run, is small enough to be sent to somebody, and is written whole.
#include "report/page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "report/payload.hpp"
#include "report/template.hpp"
#include "tests/report/sample_run.hpp"
#include "tests/report/unpacked.hpp"
#include "tests/temporary_directory.hpp"

namespace animado::report {
namespace {

#if ANIMADO_WEB
constexpr size_t kMegabyte = 1'000'000;

TEST(Page, HoldsTheRun) {
  const controle::RecordedRun run = sample_run(2, 12);
  const std::string_view page = page_template();
  const std::string text = page_with(run, {});
  const size_t place = page.find("<!--ANIMADO-RUN-->");
  ASSERT_NE(place, std::string_view::npos);
  EXPECT_EQ(text.substr(0, place), page.substr(0, place));
  const size_t end = text.find("</script>", place);
  EXPECT_EQ(gunzipped(from_base64(text.substr(place, end - place))), payload(run, {}));
}

TEST(Page, OfTheSameRunIsTheSame) {
  EXPECT_EQ(page_with(sample_run(2, 12), {}), page_with(sample_run(2, 12), {}));
}

TEST(Page, OfTwoBodiesIsUnderTwoMegabytes) {
  EXPECT_LT(page_with(sample_run(2, 12), {}).size(), 2 * kMegabyte);
}

// And ten thousand impacts.
TEST(Page, OfAThousandBodiesAndSixHundredFramesIsUnderThirtyMegabytes) {
  const size_t size = page_with(sample_run(1000, 600), {}).size();
  RecordProperty("bytes", std::to_string(size));
  EXPECT_LT(size, 30 * kMegabyte);
}
#else
TEST(Page, ThatIsNotInTheProgramIsToldWithItsRemedy) {
  try {
    page_template();
    FAIL() << "there is a page";
  } catch (const Error& error) {
    EXPECT_THAT(error.remedy(), testing::HasSubstr("ANIMADO_WEB=ON"));
  }
}
#endif

TEST(Page, OfAFolderWithoutResultsIsRefusedAndNothingIsWritten) {
  const TemporaryDirectory directory;
  EXPECT_THROW(write_report(directory), Error);
  EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
}

}  // namespace
}  // namespace animado::report
