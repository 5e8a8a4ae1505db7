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
            "energy: 100 J at the start, 60 J at the end, 40 J lost in impacts; unaccounted for: 0 J\n"
            "state hash 0000000000abcdef\n");
}

TEST(EndReport, RefusesADirectoryWithoutSummary) {
  const TemporaryDirectory directory;
  EXPECT_THROW(end_report(directory.path()), Error);
  write_text(directory / "summary.json", "{");
  EXPECT_THROW(end_report(directory.path()), Error);
}

}  // namespace
}  // namespace animado
