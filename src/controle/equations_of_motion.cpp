#include "controle/equations_of_motion.hpp"

#include "base/state.hpp"

namespace animado::controle {
namespace {

// J about the origin from the tensor about the centre of mass (parallel axes).
Mat3 about_origin(const Inertia& body) {
  const Mat3 c = cross_matrix(body.center_of_mass_m);
  return body.inertia_kg_m2 - body.mass_kg * c * c;
}

// Body → world. The quaternion of a stage has unit length only to the method's order: divided by its square,
// the matrix is orthogonal all the same, and a force that goes into body axes and comes back is what it was.
struct Rotation {
  double xx, xy, xz, yx, yy, yz, zx, zy, zz;
};

inline Rotation rotation(double w, double x, double y, double z) {
  const double s = 2 / (w * w + x * x + y * y + z * z);
  return {1 - s * (y * y + z * z), s * (x * y - w * z),     s * (x * z + w * y),
          s * (x * y + w * z),     1 - s * (x * x + z * z), s * (y * z - w * x),
          s * (x * z - w * y),     s * (y * z + w * x),     1 - s * (x * x + y * y)};
}

}  // namespace

EquationsOfMotion::EquationsOfMotion(std::span<const Inertia> bodies)
    : bodies_(bodies.size()), mass_(bodies_), center_(3 * bodies_), inertia_(6 * bodies_) {
  for (size_t i = 0; i < bodies_; ++i) {
    const Mat3 j = about_origin(bodies[i]);
    const std::array<double, 6> elements = {j(0, 0), j(1, 1), j(2, 2), j(0, 1), j(0, 2), j(1, 2)};
    mass_[i] = bodies[i].mass_kg;
    for (size_t k = 0; k < 3; ++k) center_[k * bodies_ + i] = bodies[i].center_of_mass_m[static_cast<int>(k)];
    for (size_t k = 0; k < 6; ++k) inertia_[k * bodies_ + i] = elements[k];
  }
}

void EquationsOfMotion::matrices(double* out) const {
  const size_t n = bodies_;
  for (size_t i = 0; i < n; ++i) {
    const auto row = [&](const std::vector<double>& rows, size_t k) { return rows[k * n + i]; };
    const double m = mass_[i];
    const Mat3 mc = m * cross_matrix({row(center_, 0), row(center_, 1), row(center_, 2)});
    Eigen::Matrix<double, 6, 6> a = Eigen::Matrix<double, 6, 6>::Zero();
    a.topLeftCorner<3, 3>() = m * Mat3::Identity();
    a.topRightCorner<3, 3>() = -mc;
    a.bottomLeftCorner<3, 3>() = mc;
    a.bottomRightCorner<3, 3>() << row(inertia_, 0), row(inertia_, 3), row(inertia_, 4),  //
        row(inertia_, 3), row(inertia_, 1), row(inertia_, 5),                             //
        row(inertia_, 4), row(inertia_, 5), row(inertia_, 2);
    for (size_t r = 0; r < 6; ++r) {
      for (size_t c = 0; c < 6; ++c) out[(r * 6 + c) * n + i] = a(static_cast<int>(r), static_cast<int>(c));
    }
  }
}

void EquationsOfMotion::right_sides(const double* state, const double* wrenches, double* out) const {
  const size_t n = bodies_;
  const double* const q = state + kQw * n;
  const double* const w = state + kWx * n;
  const double* const m = mass_.data();
  const double* const c = center_.data();
  const double* const J = inertia_.data();
#pragma GCC ivdep
  for (size_t i = 0; i < n; ++i) {
    const Rotation R = rotation(q[i], q[n + i], q[2 * n + i], q[3 * n + i]);
    const double fx = wrenches[i], fy = wrenches[n + i], fz = wrenches[2 * n + i];
    const double tx = wrenches[3 * n + i], ty = wrenches[4 * n + i], tz = wrenches[5 * n + i];
    const double bx = R.xx * fx + R.yx * fy + R.zx * fz;  // force, body axes
    const double by = R.xy * fx + R.yy * fy + R.zy * fz;
    const double bz = R.xz * fx + R.yz * fy + R.zz * fz;
    const double ux = R.xx * tx + R.yx * ty + R.zx * tz;  // torque about the centre of mass, body axes
    const double uy = R.xy * tx + R.yy * ty + R.zy * tz;
    const double uz = R.xz * tx + R.yz * ty + R.zz * tz;

    const double wx = w[i], wy = w[n + i], wz = w[2 * n + i];
    const double cx = c[i], cy = c[n + i], cz = c[2 * n + i];
    const double wc = wx * cx + wy * cy + wz * cz, ww = wx * wx + wy * wy + wz * wz;
    out[i] = bx - m[i] * (wx * wc - cx * ww);  // w × (w × c) = w (w·c) − c |w|²
    out[n + i] = by - m[i] * (wy * wc - cy * ww);
    out[2 * n + i] = bz - m[i] * (wz * wc - cz * ww);

    const double lx = J[i] * wx + J[3 * n + i] * wy + J[4 * n + i] * wz;  // J w
    const double ly = J[3 * n + i] * wx + J[n + i] * wy + J[5 * n + i] * wz;
    const double lz = J[4 * n + i] * wx + J[5 * n + i] * wy + J[2 * n + i] * wz;
    out[3 * n + i] = ux + (cy * bz - cz * by) - (wy * lz - wz * ly);
    out[4 * n + i] = uy + (cz * bx - cx * bz) - (wz * lx - wx * lz);
    out[5 * n + i] = uz + (cx * by - cy * bx) - (wx * ly - wy * lx);
  }
}

void EquationsOfMotion::complete_rates(const double* state, double* rates) const {
  const size_t n = bodies_;
  const double* const q = state + kQw * n;
  const double* const w = state + kWx * n;
#pragma GCC ivdep
  for (size_t i = 0; i < n; ++i) {
    const double qw = q[i], qx = q[n + i], qy = q[2 * n + i], qz = q[3 * n + i];
    const double wx = w[i], wy = w[n + i], wz = w[2 * n + i];
    for (size_t k = 0; k < 3; ++k) rates[(kPx + k) * n + i] = state[(kVx + k) * n + i];
    rates[kQw * n + i] = -0.5 * (qx * wx + qy * wy + qz * wz);
    rates[kQx * n + i] = 0.5 * (qw * wx + qy * wz - qz * wy);
    rates[kQy * n + i] = 0.5 * (qw * wy + qz * wx - qx * wz);
    rates[kQz * n + i] = 0.5 * (qw * wz + qx * wy - qy * wx);

    const Rotation R = rotation(qw, qx, qy, qz);
    const double ax = rates[kVx * n + i], ay = rates[kVy * n + i], az = rates[kVz * n + i];
    rates[kVx * n + i] = R.xx * ax + R.xy * ay + R.xz * az;
    rates[kVy * n + i] = R.yx * ax + R.yy * ay + R.yz * az;
    rates[kVz * n + i] = R.zx * ax + R.zy * ay + R.zz * az;
  }
}

}  // namespace animado::controle
