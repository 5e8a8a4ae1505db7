// src/animado/end_report.cpp, from a summary as controle writes it
#include "animado/end_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "controle/results/summary_json.hpp"
#include "tests/temporary_directory.hpp"

namespace animado {
namespace {

TEST(EndReport, TellsImpactsEnergyAndHash) {
  const TemporaryDirectory directory;
  controle::Summary summary;
  summary.frames = 12;
  summary.bodies = 2;
  summary.steps = 34;
  summary.impacts = 1;
  summary.wall_time_s = 0.25;
  summary.energy.initial_J = 100;
  summary.energy.dissipated_impacts_J = 40;
  summary.energy.dissipated_friction_J = -3.6e-15;  // rounding is not told
  summary.energy.final_J = 60;
  summary.state_hash = 0xabcdef;
  write_summary(directory / "summary.json", summary);
  EXPECT_EQ(end_report(directory.path()),
            "done: 12 frames of 2 bodies in 34 steps and 0.25 s; 1 impact\n"
            "energy: 100 J at the start, 60 J at the end, 40 J lost in impacts; nothing is unaccounted for\n"
            "state hash 0000000000abcdef\n"
            "results in " +
                std::filesystem::proximate(directory.path()).string() + "\n");
}

TEST(EndReport, TellsWhatIsUnaccountedForAndWhatThereIsToSee) {
  const TemporaryDirectory directory;
  controle::Summary summary;
  summary.energy.initial_J = 100;
  summary.energy.final_J = 100.5;
  write_summary(directory / "summary.json", summary);
  for (const char* file : {"sheet.png", "report.html"}) write_text(directory / file, "");
  const std::string report = end_report(directory.path());
  EXPECT_THAT(report, testing::HasSubstr("; 0.5 J (0.5 %) unaccounted for\n"));
  EXPECT_THAT(report, testing::EndsWith(": report.html, sheet.png\n"));
}

TEST(EndReport, TellsThatAnEnergyIsNotANumber) {
  const TemporaryDirectory directory;
  controle::Summary summary;
  summary.energy.final_J = std::numeric_limits<double>::infinity();
  write_summary(directory / "summary.json", summary);
  EXPECT_THAT(end_report(directory.path()), testing::HasSubstr("energy: more than a number holds\n"));
}

TEST(EndReport, RefusesADirectoryWithoutSummary) {
  const TemporaryDirectory directory;
  EXPECT_THROW(end_report(directory.path()), Error);
  write_text(directory / "summary.json", "{");
  EXPECT_THROW(end_report(directory.path()), Error);
}

}  // namespace
}  // namespace animado
