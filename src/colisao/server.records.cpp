#include "colisao/server.records.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"
#include "base/hash.hpp"
#include "colisao/manifold.hpp"
#include "rpc/codec.hpp"
#include "rpc/encoder.hpp"

namespace animado::colisao {

namespace {

void want_numbers(const std::vector<double>& values, size_t count, const char* field) {
  if (values.size() != count) {
    throw Error(Code::bad_shape, fmt::format("{} numbers where {} are needed", values.size(), count), field,
                "the manual page of colisao says what each shape needs");
  }
}

void want_within(double value, double most, const char* field) {
  if (!(value >= 0 && value <= most)) {
    throw Error(Code::bad_params, fmt::format("{} is outside 0 … {}", value, most), field,
                "give a number within the bounds");
  }
}

Vec3 vec3(const std::vector<double>& values, const char* field) {
  want_numbers(values, 3, field);
  return {values[0], values[1], values[2]};
}

Hull hull(const BodyRecord& record) {
  if (record.vertices_m.size() % 3 != 0)
    want_numbers(record.vertices_m, record.vertices_m.size() / 3 * 3, "vertices_m");
  Hull hull;
  for (size_t n = 0; n < record.vertices_m.size(); n += 3) {
    hull.vertices_m.push_back({record.vertices_m[n], record.vertices_m[n + 1], record.vertices_m[n + 2]});
  }
  for (const std::vector<int64_t>& face : record.faces) {
    hull.faces.emplace_back();
    for (int64_t vertex : face) {
      if (vertex < 0 || vertex >= static_cast<int64_t>(hull.vertices_m.size())) {
        throw Error(Code::bad_params, fmt::format("there is no vertex {}", vertex), "faces",
                    "vertices count from 0");
      }
      hull.faces.back().push_back(static_cast<int>(vertex));
    }
  }
  return hull;
}

Shape shape(const BodyRecord& record) {
  const std::vector<double>& size = record.size_m;
  const auto sized = [&](size_t count) { want_numbers(size, count, "size_m"); };
  switch (record.shape) {
    case ShapeKind::sphere:
      return sized(1), Sphere{size[0]};
    case ShapeKind::box:
      return Box{vec3(size, "size_m")};
    case ShapeKind::capsule:
      return sized(2), Capsule{size[0], size[1]};
    case ShapeKind::cylinder:
      return sized(2), Cylinder{size[0], size[1]};
    case ShapeKind::cone:
      return sized(2), Cone{size[0], size[1]};
    case ShapeKind::plane:
      return sized(4), HalfSpace{Vec3(size[0], size[1], size[2]), size[3]};
    case ShapeKind::hull:
      return hull(record);
  }
  throw Error(Code::bad_params, "unknown shape", "shape");
}

Motion motion(MotionKind kind) {
  switch (kind) {
    case MotionKind::dynamic:
      return Motion::dynamic;
    case MotionKind::fixed:
      return Motion::fixed;
    case MotionKind::kinematic:
      return Motion::kinematic;
  }
  throw Error(Code::bad_params, "unknown motion", "motion");
}

RestitutionRule rule(Rule rule) {
  switch (rule) {
    case Rule::product:
      return RestitutionRule::product;
    case Rule::min:
      return RestitutionRule::min;
    case Rule::max:
      return RestitutionRule::max;
    case Rule::mean:
      return RestitutionRule::mean;
  }
  throw Error(Code::bad_params, "unknown rule", "restitution_rule");
}

Body body(const BodyRecord& record, const Solid& solid) {
  want_within(record.restitution, 1, "restitution");
  want_within(record.friction, INFINITY, "friction");
  Body body;
  if (record.motion == MotionKind::dynamic) {
    want_numbers(record.inertia_kg_m2, 9, "inertia_kg_m2");
    const Mat3 inertia =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(record.inertia_kg_m2.data());
    body = dynamic_body(record.mass_kg, inertia, vec3(record.center_of_mass_m, "center_of_mass_m"));
  } else {
    body = immovable_body(motion(record.motion));
  }
  body.restitution = record.restitution;
  body.friction = record.friction;
  if (std::isfinite(solid.radius_m())) body.radius_m = solid.radius_m() + body.center_of_mass_m.norm();
  return body;
}

std::vector<double> numbers(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

}  // namespace

std::vector<Contact> Prepared::contacts(const double* state, double margin_m) const {
  std::vector<Contact> all;
  for (const auto& [a, b] : broad_phase.pairs_at(state, margin_m)) {
    manifold(a, colliders[static_cast<size_t>(a)].solid,
             load_body(state, size(), static_cast<size_t>(a)).pose, b,
             colliders[static_cast<size_t>(b)].solid, load_body(state, size(), static_cast<size_t>(b)).pose,
             margin_m, all);
  }
  return all;
}

ContactFinder Prepared::finder() const {
  ContactFinder finder;
  finder.pairs_at = [this](const double* state, double margin_m) {
    return broad_phase.pairs_at(state, margin_m);
  };
  finder.pairs_between = [this](const double* from, const double* to, double step_s, double margin_m) {
    return broad_phase.pairs_between(from, to, step_s, margin_m);
  };
  finder.manifold = [this](int a, const Pose& pose_a, int b, const Pose& pose_b, double margin_m,
                           std::vector<Contact>& out) {
    manifold(a, colliders[static_cast<size_t>(a)].solid, pose_a, b, colliders[static_cast<size_t>(b)].solid,
             pose_b, margin_m, out);
  };
  return finder;
}

std::vector<BodyState> Prepared::states(const double* state) const {
  std::vector<BodyState> all;
  for (size_t i = 0; i < size(); ++i) all.push_back(load_body(state, size(), i));
  return all;
}

std::shared_ptr<const Prepared> prepared(const Prepare::Request& request) {
  want_within(request.contact_threshold_m_s, INFINITY, "contact_threshold_m_s");
  auto result = std::make_shared<Prepared>();
  result->bodies.rule = rule(request.restitution_rule);
  result->bodies.contact_threshold_m_s = request.contact_threshold_m_s;
  for (const BodyRecord& record : request.bodies) {
    try {
      result->colliders.push_back(
          {Solid(shape(record)), motion(record.motion), record.group, record.collides_with});
      result->bodies.list.push_back(body(record, result->colliders.back().solid));
    } catch (const Error& error) {
      throw Error(error.code(), fmt::format("body `{}`: {}", record.name, error.message()), error.where(),
                  error.remedy());
    }
  }
  result->broad_phase = BroadPhase(result->colliders);
  return result;
}

std::string handle_of(const Prepare::Request& request) {
  std::string packed;
  rpc::Encoder encoder(packed);
  rpc::pack(rpc::type_of<Prepare::Request>(), &request, encoder);
  Fnv1a hash;
  hash.add(packed);
  return hex(hash.value());
}

ContactRecord record(const Contact& contact, const Vec3& relative_velocity_m_s) {
  return {contact.a,
          contact.b,
          numbers(contact.point_m),
          numbers(contact.normal),
          contact.gap_m,
          -relative_velocity_m_s.dot(contact.normal),
          static_cast<Meeting>(contact.kind)};
}

ImpactRecord record(int a, int b, double time_s, const Contact& contact, const AnsweredImpact& answer) {
  return {a,
          b,
          time_s,
          numbers(contact.point_m),
          numbers(contact.normal),
          numbers(answer.impulse_N_s),
          answer.approach_m_s,
          answer.separation_m_s};
}

}  // namespace animado::colisao
