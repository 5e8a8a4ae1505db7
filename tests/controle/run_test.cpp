// src/controle/run.cpp, with the services in this process.
#include "controle/run.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "animado/in_process.hpp"
#include "tests/temporary_directory.hpp"

namespace animado::controle {
namespace {

TEST(Run, TellsOfItselfWithinAFrameThatTakesLong) {
  const TemporaryDirectory directory;
  RunOptions options;
  options.scene = directory.path() / "scene.animado";
  options.directory = directory.path();
  std::ofstream(options.scene) << "world\n method dopri5\n"
                                  "object ball\n shape sphere(radius=1)\n mass 2\n velocity (1, 0, 0)\n"
                                  " linear damping 1e9\ntime\n start 2\n end 3\n step 1\n";
  std::filesystem::create_directory(directory.path() / "logs");
  std::vector<Progress> told;
  options.progress = [&](const Progress& progress) { told.push_back(progress); };
  int64_t asked = 0;  // so that this ends where nothing is told
  options.stop = [&] { return told.size() > 1 || ++asked > 1'000'000; };
  EXPECT_EQ(run(options, *suite_in_process()).status, RunStatus::interrupted);
  ASSERT_EQ(told.size(), 2);
  EXPECT_EQ(told[0].step_s, 0);
  const Progress& within = told[1];
  EXPECT_EQ(within.frame, 1);
  EXPECT_EQ(within.frames, 2);
  EXPECT_EQ(within.start_s, 2);
  EXPECT_EQ(within.end_s, 3);
  EXPECT_GT(within.steps, 0);
  EXPECT_GT(within.time_s, 2);
  EXPECT_LT(within.time_s, 2.1);
  EXPECT_NEAR(within.step_s * static_cast<double>(within.steps), within.time_s - 2, 1e-12);
}

}  // namespace
}  // namespace animado::controle
