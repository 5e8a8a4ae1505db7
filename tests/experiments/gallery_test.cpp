// Every scene of the gallery runs to its end, both ways to the same bits, with a ledger that closes.
#include "laboratory.hpp"

namespace animado::experiments {
namespace {

std::vector<std::string> scenes() {
  std::vector<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(ANIMADO_SOURCE_DIR) + "/scenes")) {
    if (entry.path().extension() == ".animado") found.push_back(entry.path().stem().string());
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

class Gallery : public testing::TestWithParam<std::string> {};

TEST_P(Gallery, RunsBothWaysToTheSameBits) {
  const std::string file = std::string(ANIMADO_SOURCE_DIR) + "/scenes/" + GetParam() + ".animado";
  const Record sockets = simulate_file(file, Way::sockets), in_process = simulate_file(file, Way::in_process);
  EXPECT_EQ(sockets.summary["status"], "done");
  EXPECT_EQ(sockets.summary["state_hash"], in_process.summary["state_hash"]);
  EXPECT_EQ(sockets.events, in_process.events);
  // Sub-steps of a heap are of first order: a thousandth of what was lost may be unaccounted for.
  const auto& energy = sockets.summary["energy"];
  const auto amount = [&](const char* key) { return std::abs(energy[key].get<double>()); };
  const double moved_J =
      amount("work_in") + amount("dissipated_impacts") + amount("dissipated_friction") + amount("initial");
  EXPECT_LT(amount("residual"), 1e-3 * moved_J + 1e-9);
}

INSTANTIATE_TEST_SUITE_P(, Gallery, testing::ValuesIn(scenes()),
                         [](const auto& scene) { return scene.param; });

// A crate that a path pushes: it keeps the pusher's speed until that stops, then friction stops it
// (scenes/kinematic_push.animado says where).
TEST(KinematicPush, GivesTheCrateNoMoreThanThePushersSpeed) {
  const Record record =
      simulate_file(std::string(ANIMADO_SOURCE_DIR) + "/scenes/kinematic_push.animado", Way::in_process);
  for (const Row& row : record.of("crate"))
    EXPECT_LT(row.velocity_m_s.norm(), 0.8 + 1e-3) << "t = " << row.time_s;
  EXPECT_NEAR(record.of("crate").back().position_m.x(), 1.9587, 1e-3);
}

}  // namespace animado::experiments
