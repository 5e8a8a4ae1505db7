// Every scene looks as it did: its sheet, 320 px wide, against the one in references/ (scripts/gallery makes
// them again, when a change is wanted).
//
// The tolerance lets through what no eye sees: other roundings at edges, a float that a heap of boxes turned
// by a thousandth. It does not let through a body that is missing or has another colour, a light that
// changed, a camera that moved, a contact that is not marked: those below show it.
#include <gtest/gtest.h>

#include <algorithm>

#include "difference.hpp"
#include "shell.hpp"
#include "visao/moments.hpp"
#include "visao/sheet.hpp"

namespace animado::visao {
namespace {

namespace fs = std::filesystem;
using controle::RecordedRun;

constexpr double kMean = 0.25, kWorst = 6;  // a tenth and three times of what an eye sees side by side

bool look_alike(const Difference& found) {
  return found.mean < kMean && found.worst < kWorst;
}

std::vector<std::string> scenes() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(kScenes)) {
    if (entry.path().extension() == ".animado") names.push_back(entry.path().stem());
  }
  std::ranges::sort(names);
  return names;
}

RecordedRun run_of(const std::string& scene) {
  const TemporaryDirectory directory;
  const Outcome outcome = simulate(scene, directory / "run");
  if (outcome.code != 0) throw std::runtime_error(outcome.err);
  return controle::read_run(directory / "run");
}

Picture small_sheet(const RecordedRun& run, const std::string& scene) {
  return sheet(run, {.frames = even_frames(run.frames(), 12), .width_px = 320, .title = scene});
}

class Scene : public testing::TestWithParam<std::string> {};

TEST_P(Scene, LooksAsItDid) {
  const Picture now = small_sheet(run_of(GetParam()), GetParam());
  const Difference found = difference(
      now, read_png(std::string(ANIMADO_SOURCE_DIR) + "/tests/visao/references/" + GetParam() + ".png"));
  if (look_alike(found)) return;
  const fs::path seen = fs::temp_directory_path() / ("animado-" + GetParam() + ".png");
  write_png(seen, now);
  ADD_FAILURE() << "mean difference " << found.mean << ", worst " << found.worst << "; see " << seen
                << "; if that is as it should be: scripts/gallery";
}
INSTANTIATE_TEST_SUITE_P(, Scene, testing::ValuesIn(scenes()), [](const auto& scene) { return scene.param; });

class Change : public testing::Test {
 protected:
  // Whether a sheet of the run, changed, would pass for the one that it was.
  static bool passes(const std::string& scene, void (*change)(RecordedRun&)) {
    RecordedRun run = run_of(scene);
    const Picture before = small_sheet(run, scene);
    change(run);
    return look_alike(difference(before, small_sheet(run, scene)));
  }
};

TEST_F(Change, NoneIsNone) {
  EXPECT_TRUE(passes("orbit", [](RecordedRun&) {}));
}

TEST_F(Change, AMissingBodyIsFound) {  // even a small one, and the rest is where it was
  EXPECT_FALSE(passes("orbit", [](RecordedRun& run) { run.bodies[1].shape = Sphere{1e-6}; }));
  EXPECT_FALSE(passes("colisao", [](RecordedRun& run) { run.bodies[1].shape = Sphere{1e-6}; }));
}

TEST_F(Change, AnotherColorIsFound) {
  EXPECT_FALSE(passes("falling_boxes", [](RecordedRun& run) { run.bodies[4].color_srgb = {0.3, 0.8, 0.3}; }));
}

TEST_F(Change, ABodyThatTurnedAnotherWayIsFound) {
  EXPECT_FALSE(passes("colisao", [](RecordedRun& run) {
    for (auto& state : run.states) state.pose.orientation = state.pose.orientation.conjugate();
  }));
}

TEST_F(Change, AContactThatIsNotMarkedIsFound) {
  EXPECT_FALSE(passes("newton_cradle", [](RecordedRun& run) { run.events.clear(); }));
}

}  // namespace
}  // namespace animado::visao
