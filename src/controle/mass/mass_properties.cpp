// The primitives' moments are the textbook ones (e.g. Beer & Johnston, Vector Mechanics for Engineers, inside
// back cover), axis along y, about the centroid. A capsule is a cylinder and two half balls whose centroids
// lie 3r/8 beyond its flat ends.
#include "controle/mass/mass_properties.hpp"

#include <Eigen/Eigenvalues>
#include <limits>
#include <numbers>

#include "controle/mass/polyhedron_integrals.hpp"

namespace animado::controle {
namespace {

constexpr double kPi = std::numbers::pi;

// Volume, centroid, inertia tensor about it: the mass properties at density 1.
MassProperties solid(const Sphere& s) {
  const double r = s.radius_m, m = 4.0 / 3 * kPi * r * r * r;
  return {m, Vec3::Zero(), Mat3::Identity() * (0.4 * m * r * r)};
}

MassProperties solid(const Box& s) {
  const Vec3 h = s.half_m, squares = h.cwiseProduct(h);
  const double m = 8 * h.prod();
  return {m, Vec3::Zero(), Mat3((m / 3 * (Vec3::Constant(squares.sum()) - squares)).asDiagonal())};
}

MassProperties solid(const Cylinder& s) {
  const double r = s.radius_m, l = 2 * s.half_height_m, m = kPi * r * r * l;
  const double across = m * (3 * r * r + l * l) / 12;
  return {m, Vec3::Zero(), Mat3(Vec3(across, m * r * r / 2, across).asDiagonal())};
}

MassProperties solid(const Capsule& s) {
  const MassProperties middle = solid(Cylinder{s.radius_m, s.half_height_m}),
                       ball = solid(Sphere{s.radius_m});
  const double h = s.half_height_m, shift = h * h + 0.75 * h * s.radius_m;
  const Mat3 moved = ball.mass_kg * shift * Vec3(1, 0, 1).asDiagonal().toDenseMatrix();
  return {middle.mass_kg + ball.mass_kg, Vec3::Zero(), middle.inertia_kg_m2 + ball.inertia_kg_m2 + moved};
}

MassProperties solid(const Cone& s) {
  const double r = s.radius_m, h = s.height_m, m = kPi * r * r * h / 3;
  const double across = 3.0 / 80 * m * (4 * r * r + h * h);
  return {m, Vec3::Zero(), Mat3(Vec3(across, 0.3 * m * r * r, across).asDiagonal())};
}

MassProperties solid(const Hull& s) {
  const VolumeIntegrals v = integrate(s);
  return {v.volume_m3, v.centroid_m, v.second_moment_m5.trace() * Mat3::Identity() - v.second_moment_m5};
}

MassProperties solid(const HalfSpace&) {
  return {std::numeric_limits<double>::infinity(), Vec3::Zero(), Mat3::Zero()};
}

bool fails(std::string* why, std::string text) {
  if (why) *why = std::move(text);
  return false;
}

}  // namespace

double volume_m3(const Shape& shape) {
  return std::visit([](const auto& s) { return solid(s).mass_kg; }, shape);
}

MassProperties mass_properties(const Shape& shape, double density_kg_m3) {
  assert(!std::holds_alternative<HalfSpace>(shape));
  MassProperties p = std::visit([](const auto& s) { return solid(s); }, shape);
  p.mass_kg *= density_kg_m3;
  p.inertia_kg_m2 *= density_kg_m3;
  return p;
}

PrincipalAxes principal_axes(const Mat3& inertia_kg_m2) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(inertia_kg_m2);
  Mat3 axes = solver.eigenvectors();
  if (axes.determinant() < 0) axes.col(2) = -axes.col(2);
  return {solver.eigenvalues(), Quat(axes).normalized()};
}

bool is_inertia(const Mat3& inertia_kg_m2, std::string* why) {
  if (!inertia_kg_m2.allFinite()) return fails(why, "it is not finite");
  if (inertia_kg_m2 != inertia_kg_m2.transpose()) return fails(why, "it is not symmetric");
  const Vec3 p = principal_axes(inertia_kg_m2).moments_kg_m2;
  // The solver's moments carry a few roundings of the largest one.
  const double rounding = 1e-12 * p[2];
  const auto moments = [&] {
    return fmt::format("its principal moments are {:g}, {:g} and {:g}", p[0], p[1], p[2]);
  };
  if (p[0] <= rounding) return fails(why, "it is not positive definite: " + moments());
  if (p[2] > p[0] + p[1] + rounding)
    return fails(why, "no body has it, one moment exceeds the sum of the others: " + moments());
  return true;
}

Mat3 inertia_about(const Mat3& inertia_kg_m2, double mass_kg, const Vec3& offset_m) {
  return inertia_kg_m2 +
         mass_kg * (offset_m.squaredNorm() * Mat3::Identity() - offset_m * offset_m.transpose());
}

}  // namespace animado::controle
