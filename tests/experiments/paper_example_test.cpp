// The paper's example (section 6): a sphere and a spinning cube that meet once.
#include <cmath>
#include <fstream>
#include <sstream>

#include "laboratory.hpp"

namespace animado::experiments {
namespace {

const std::string kScene = std::string(ANIMADO_SOURCE_DIR) + "/scenes/colisao.animado";
constexpr double kImpact_s = 1.141953820;

std::string scene_with(const std::string& world) {
  std::ifstream in(kScene);
  std::stringstream text;
  text << in.rdbuf() << "\n" << world;
  return text.str();
}

Vec3 momentum(const Record& record, int frame) {
  Vec3 sum = Vec3::Zero();
  for (const Row& row : record.rows) {
    if (row.frame == frame) sum += (row.body == "esfera" ? 2.0 : 1.7) * row.velocity_m_s;
  }
  return sum;
}

}  // namespace

class PaperExample : public Experiment {};

TEST_P(PaperExample, HasTwelveFramesOfTwoBodies) {
  const Record record = simulate_file(kScene, GetParam());
  EXPECT_EQ(record.rows.size(), 24u);
  EXPECT_EQ(record.rows.back().frame, 11);
  EXPECT_NEAR(record.rows.back().time_s, 3.3, 1e-12);
}

TEST_P(PaperExample, IsTheClosedFormUntilTheImpact) {
  const Record record = simulate_file(kScene, GetParam());
  for (const Row& row : record.rows) {
    const double t = row.time_s;
    if (t > kImpact_s) continue;
    const bool sphere = row.body == "esfera";
    const Vec3 w = sphere ? Vec3(5, 5, 5) : Vec3(10, 0, 0);
    const Vec3 x = sphere ? Vec3(0, 3 - 0.5 * t, 0) : Vec3(0, 0.7 * t, 0);
    const Quat q(Eigen::AngleAxisd(w.norm() * t, w.normalized()));
    EXPECT_LT((row.position_m - x).norm(), 1e-9) << row.body << " t = " << t;
    EXPECT_LT((row.velocity_m_s - Vec3(0, sphere ? -0.5 : 0.7, 0)).norm(), 1e-9) << row.body << " t = " << t;
    EXPECT_LT((row.angular_velocity_rad_s - w).norm(), 1e-9) << row.body << " t = " << t;
    EXPECT_LT((row.orientation.toRotationMatrix() - q.toRotationMatrix()).norm(), 1e-9)
        << row.body << " t = " << t;
  }
}

TEST_P(PaperExample, MeetsOnceAtItsTime) {
  const Record record = simulate_file(kScene, GetParam());
  const auto impacts = record.impacts();
  ASSERT_EQ(impacts.size(), 1u);
  EXPECT_NEAR(impacts[0]["time_s"].get<double>(), kImpact_s, 1e-9);
  EXPECT_NEAR(impacts[0]["separation_m_s"].get<double>(), 0.5 * impacts[0]["approach_m_s"].get<double>(),
              1e-9);
  const Vec3 before = momentum(record, 0);
  EXPECT_LT((momentum(record, 11) - before).norm() / before.norm(), 1e-12);
}

TEST_P(PaperExample, FifteenEquationsAndTheClosedFormAgree) {
  const Record impulse = simulate(scene_with("world\n response impulse\n"));
  const Record system15 = simulate(scene_with("world\n response system15\n"));
  ASSERT_EQ(impulse.rows.size(), system15.rows.size());
  for (size_t i = 0; i < impulse.rows.size(); ++i) {
    const Row &a = impulse.rows[i], &b = system15.rows[i];
    EXPECT_LT((a.position_m - b.position_m).norm(), 1e-9);
    EXPECT_LT((a.velocity_m_s - b.velocity_m_s).norm(), 1e-9);
    EXPECT_LT((a.angular_velocity_rad_s - b.angular_velocity_rad_s).norm(), 1e-9);
  }
}

ANIMADO_BOTH_WAYS(PaperExample);

TEST(PaperExampleBits, AreTheSameOverSocketsAndInOneProcess) {
  const Record sockets = simulate_file(kScene, Way::sockets),
               in_process = simulate_file(kScene, Way::in_process);
  EXPECT_EQ(sockets.summary["state_hash"], in_process.summary["state_hash"]);
}

}  // namespace animado::experiments
