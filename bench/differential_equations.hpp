// What the solvers of differential equations are measured on, as plain functions of arrays: each of them sees
// the same code.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "free_tops.hpp"

namespace animado::bench {

// A satellite between earth and moon that comes back to where it was (Hairer, Nørsett, Wanner, Solving ODE I,
// II.0).
struct Arenstorf {
  using State = std::array<double, 4>;
  static constexpr auto kName = "Arenstorf";
  static constexpr double kEnd = 17.0652165601579625588917206249;
  static constexpr double kTightError = 1e-8;

  static State start() { return {0.994, 0, 0, -2.00158510637908252240537862224}; }

  void operator()(const double* y, double* rate) const {
    constexpr double kMoon = 0.012277471, kEarth = 1 - kMoon;
    const double a = y[0] + kMoon, b = y[0] - kEarth, square = y[1] * y[1];
    const double to_earth = a * a + square, to_moon = b * b + square;
    const double earth = kEarth / (to_earth * std::sqrt(to_earth)),
                 moon = kMoon / (to_moon * std::sqrt(to_moon));
    rate[0] = y[2];
    rate[1] = y[3];
    rate[2] = y[0] + 2 * y[3] - earth * a - moon * b;
    rate[3] = y[1] - 2 * y[2] - (earth + moon) * y[1];
  }
};

// Seven stars in a plane that pass each other closely (the same, II.10): x, y, x', y' of each.
struct Pleiades {
  using State = std::array<double, 28>;
  static constexpr auto kName = "Pleiades";
  static constexpr double kEnd = 3;
  static constexpr double kTightError = 1e-10;

  static State start() {
    return {3, 3, -1, -3, 2, -2,   2,    3, -3, 2, 0,     0, -4, 4,
            0, 0, 0,  0,  0, 1.75, -1.5, 0, 0,  0, -1.25, 1, 0,  0};
  }

  void operator()(const double* y, double* rate) const {
    // Sums of its own, so that no store could be one to y.
    const double *px = y, *py = y + 7;
    double ax[7] = {}, ay[7] = {};
    for (size_t i = 0; i < 7; ++i) {
      for (size_t j = i + 1; j < 7; ++j) {
        const double dx = px[j] - px[i], dy = py[j] - py[i], square = dx * dx + dy * dy;
        const double pull = 1 / (square * std::sqrt(square));
        const double of_j = static_cast<double>(j + 1) * pull, of_i = static_cast<double>(i + 1) * pull;
        ax[i] += of_j * dx;
        ay[i] += of_j * dy;
        ax[j] -= of_i * dx;
        ay[j] -= of_i * dy;
      }
    }
    for (size_t i = 0; i < 14; ++i) rate[i] = y[14 + i];
    for (size_t i = 0; i < 7; ++i) rate[14 + i] = ax[i], rate[21 + i] = ay[i];
  }
};

// 1,000 boxes that turn freely: orientation and angular velocity in body axes. kLanes: each of the seven
// numbers of all tops side by side; else top after top, as one would write it.
template <bool kLanes>
struct Tops {
  using State = std::vector<double>;
  static constexpr auto kName = "FreeTops";
  static constexpr double kEnd = 10;
  static constexpr double kTightError = 1e-10;
  static constexpr size_t kCount = 1000;
  static constexpr bool kIsEnsemble = kLanes;

  static State start() {
    State y(7 * kCount);
    const auto tops = free_tops(kCount);
    for (size_t i = 0; i < kCount; ++i) {
      const Vec3& w = tops[i].angular_velocity_rad_s;
      const double top[7] = {1, 0, 0, 0, w.x(), w.y(), w.z()};
      for (size_t k = 0; k < 7; ++k) y[kLanes ? k * kCount + i : 7 * i + k] = top[k];
    }
    return y;
  }

  Tops() {
    const Vec3 inertia = top_inertia_kg_m2();
    a_ = (inertia.y() - inertia.z()) / inertia.x();
    b_ = (inertia.z() - inertia.x()) / inertia.y();
    c_ = (inertia.x() - inertia.y()) / inertia.z();
  }

  __attribute__((target_clones("avx512f", "default"))) void operator()(const double* y, double* rate,
                                                                       size_t count = kCount) const {
    constexpr size_t kTop = kLanes ? 1 : 7;
    const size_t next = kLanes ? count : 1;
    const double a = a_, b = b_, c = c_;
#pragma GCC ivdep
    for (size_t i = 0; i < count; ++i) {
      const double* s = y + i * kTop;
      double* r = rate + i * kTop;
      const double qw = s[0], qx = s[next], qy = s[2 * next], qz = s[3 * next];
      const double wx = s[4 * next], wy = s[5 * next], wz = s[6 * next];
      r[0] = -0.5 * (qx * wx + qy * wy + qz * wz);
      r[next] = 0.5 * (qw * wx + qy * wz - qz * wy);
      r[2 * next] = 0.5 * (qw * wy + qz * wx - qx * wz);
      r[3 * next] = 0.5 * (qw * wz + qx * wy - qy * wx);
      r[4 * next] = a * wy * wz;
      r[5 * next] = b * wz * wx;
      r[6 * next] = c * wx * wy;
    }
  }

 private:
  double a_, b_, c_;  // Euler's equations: wx' = a wy wz, …
};

}  // namespace animado::bench
