#include "visao/stage.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace animado::visao {

namespace {

using controle::RecordedBody;
using controle::RecordedRun;

const Vec3f kFloorColor{0.74f, 0.73f, 0.71f};
constexpr double kAir =
    1.25;  // a body's room in the picture, of its own size: what hardly moves is not all of it
constexpr float kTint = 0.12f;  // of a floor's own colour: it is there for what stands on it

Ball ball_of(const RecordedRun& run, size_t frame, size_t body, double radius_m) {
  return {run.at(frame, body).pose.position_m, radius_m};
}

double radius_m(const controle::TriangleMesh& mesh) {
  double farthest_m = 0;
  for (const Vec3& p : mesh.positions_m) farthest_m = std::max(farthest_m, p.norm());
  return farthest_m;
}

std::vector<StagedBody> staged_bodies(const RecordedRun& run) {
  std::vector<StagedBody> staged;
  for (size_t i = 0; i < run.bodies.size(); ++i) {
    const RecordedBody& body = run.bodies[i];
    if (std::holds_alternative<HalfSpace>(body.shape)) continue;
    StagedBody& made = staged.emplace_back(StagedBody{i, linear_of(body.color_srgb)});
    if (const auto* sphere = std::get_if<Sphere>(&body.shape)) {
      made.sphere_radius_m = made.radius_m = sphere->radius_m;
    } else {
      made.mesh = controle::tessellate(body.shape, 0);
      made.radius_m = radius_m(made.mesh);
    }
  }
  return staged;
}

// What is wider than this cannot be told apart in single precision; only a motion that diverged is.
constexpr double kWidest_m = 1e15;

void enclose(Stage& stage) {
  Eigen::AlignedBox3d room;
  for (const Ball& ball : stage.motion) {
    const Vec3 reach = Vec3::Constant(ball.radius_m);
    room.extend(ball.center_m - reach).extend(ball.center_m + reach);
  }
  stage.origin_m = room.center();
  stage.radius_m = 0;
  for (const Ball& ball : stage.motion) {
    stage.radius_m = std::max(stage.radius_m, (ball.center_m - stage.origin_m).norm() + ball.radius_m);
  }
  if (!(stage.radius_m < kWidest_m)) {
    throw Error(Code::refused,
                fmt::format("the motion is {:.2g} m wide: no picture shows that", stage.radius_m), "",
                "did it diverge? the tables are there; choose other frames by --frames");
  }
}

// The bodies that move, and those of the others that are near and no larger than all that moves: a sun
// belongs to its planet's picture, a mountain does not.
void find_motion(const RecordedRun& run, Stage& stage) {
  const size_t frames = run.times_s.size();
  const auto is_fixed = [&](const StagedBody& b) { return run.bodies[b.index].motion == Motion::fixed; };
  const bool all_fixed = std::ranges::all_of(stage.bodies, is_fixed);
  for (const StagedBody& body : stage.bodies) {
    if (is_fixed(body) && !all_fixed) continue;
    const double reach_m = kAir * body.radius_m;
    for (size_t f = 0; f < frames; ++f) stage.motion.push_back(ball_of(run, f, body.index, reach_m));
  }
  if (stage.motion.empty()) stage.motion.push_back({Vec3::Zero(), 1});
  enclose(stage);
  if (all_fixed || frames == 0) return;
  const size_t moving = stage.motion.size();
  for (const StagedBody& body : stage.bodies) {
    if (!is_fixed(body)) continue;
    const Ball ball = ball_of(run, 0, body.index, kAir * body.radius_m);
    const double distance_m = (ball.center_m - stage.origin_m).norm();
    if (ball.radius_m < stage.radius_m && distance_m < 2 * stage.radius_m) stage.motion.push_back(ball);
  }
  if (stage.motion.size() > moving) enclose(stage);
}

// 1, 2 or 5 times a power of ten, about a quarter of the room.
float grid_m(double room_m) {
  const double wanted_m = room_m / 4, power = std::pow(10, std::floor(std::log10(wanted_m)));
  const double digit = wanted_m / power;
  return static_cast<float>(power * (digit < 2 ? 1 : digit < 5 ? 2 : 5));
}

void add_plane(Stage& stage, const Vec3& normal, double offset_m, const Vec3f& color, float grid) {
  stage.planes.push_back(
      {normal.cast<float>(), static_cast<float>(offset_m - normal.dot(stage.origin_m)), color, grid});
}

void add_planes(const RecordedRun& run, Stage& stage) {
  for (size_t i = 0; i < run.bodies.size() && !run.times_s.empty(); ++i) {
    const auto* half_space = std::get_if<HalfSpace>(&run.bodies[i].shape);
    if (half_space == nullptr) continue;
    const Pose& pose = run.at(0, i).pose;
    const Vec3 normal = pose.orientation * half_space->normal;
    const Vec3f own = linear_of(run.bodies[i].color_srgb);
    add_plane(stage, normal, half_space->offset_m + normal.dot(pose.position_m),
              kFloorColor * (1 - kTint) + own * kTint, grid_m(stage.radius_m));
  }
  // Where there is weight but nothing to stand on, a floor far enough below to be no part of the motion: its
  // shadow tells where things are.
  const auto has_weight = [](const controle::FrameFacts& facts) { return facts.potential_J != 0; };
  if (!stage.planes.empty() || std::ranges::none_of(run.facts, has_weight)) return;
  double lowest_m = stage.motion[0].center_m.y();
  for (const Ball& ball : stage.motion) lowest_m = std::min(lowest_m, ball.center_m.y() - ball.radius_m);
  add_plane(stage, {0, 1, 0}, lowest_m - 0.1 * stage.radius_m, kFloorColor, 0);
}

}  // namespace

Stage staged(const RecordedRun& run) {
  Stage stage{Vec3::Zero(), 1, staged_bodies(run), {}, {}};
  find_motion(run, stage);
  add_planes(run, stage);
  return stage;
}

}  // namespace animado::visao
