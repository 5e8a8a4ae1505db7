#include "free_tops.hpp"

namespace animado::bench {
namespace {

// 64-bit linear congruential generator, constants of Knuth's MMIX.
class Generator {
 public:
  double between(double a, double b) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return a + (b - a) * (static_cast<double>(state_ >> 33) / 2147483648.0);
  }

 private:
  uint64_t state_ = 12345;
};

}  // namespace

std::vector<Top> free_tops(size_t count) {
  Generator random;
  std::vector<Top> tops(count);
  for (size_t i = 0; i < count; ++i) {
    const auto at = [](size_t k) { return 5 * static_cast<double>(k); };
    tops[i].position_m = {at(i % 22), at(i / 22 % 22), at(i / 484)};
    for (int k = 0; k < 3; ++k) tops[i].angular_velocity_rad_s[k] = random.between(-5, 5);
  }
  return tops;
}

double top_mass_kg() {
  return 8 * kHalf_m.prod();
}

Vec3 top_inertia_kg_m2() {
  const Vec3 squares = kHalf_m.cwiseProduct(kHalf_m);
  return top_mass_kg() / 3 *
         Vec3(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y());
}

controle::Scene free_tops_scene(size_t count) {
  controle::Scene scene;
  scene.path = "free_tops";
  scene.world.substep_s = kStep_s;
  scene.time = {0, 10, kStep_s, {}};
  const auto tops = free_tops(count);
  for (size_t i = 0; i < count; ++i) {
    controle::Body body;
    body.name = body.folded_name = "top" + std::to_string(i);
    body.shape = Box{kHalf_m};
    body.mass_kg = top_mass_kg();
    body.inertia_kg_m2 = top_inertia_kg_m2().asDiagonal();
    body.position_m = tops[i].position_m;
    body.angular_velocity_rad_s = tops[i].angular_velocity_rad_s;
    scene.bodies.push_back(std::move(body));
  }
  return scene;
}

AngularMomentumError::AngularMomentumError(const std::vector<Top>& start) {
  for (const Top& top : start) start_.push_back(top_inertia_kg_m2().cwiseProduct(top.angular_velocity_rad_s));
}

void AngularMomentumError::add(size_t top, const Quat& orientation, const Vec3& angular_velocity_rad_s) {
  const Vec3 now =
      orientation * top_inertia_kg_m2().cwiseProduct(orientation.conjugate() * angular_velocity_rad_s);
  sum_ += (now - start_[top]).norm() / start_[top].norm();
  ++count_;
}

}  // namespace animado::bench
