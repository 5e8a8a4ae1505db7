#include "controle/preparation.hpp"

namespace animado::controle {
namespace {

std::vector<double> numbers(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

std::vector<LiveProgram> compiled(const SceneScope& scope, const std::vector<Expression>& expressions) {
  std::vector<LiveProgram> programs;
  for (const Expression& expression : expressions) programs.emplace_back(scope, expression);
  return programs;
}

bool is_driven(const Body& body) {
  const bool pushed = !(body.forces.empty() && body.torques.empty() && body.local_forces.empty() &&
                        body.local_torques.empty());
  return pushed || body.linear_damping_1_s != 0 || body.angular_damping_1_s != 0;
}

// Writes a shape into colisao's record of a body.
struct ShapeRecord {
  colisao::BodyRecord& record;

  void put(colisao::ShapeKind kind, std::vector<double> size_m) const {
    record.shape = kind;
    record.size_m = std::move(size_m);
  }
  void operator()(const Sphere& s) const { put(colisao::ShapeKind::sphere, {s.radius_m}); }
  void operator()(const Box& s) const { put(colisao::ShapeKind::box, numbers(s.half_m)); }
  void operator()(const Capsule& s) const { put(colisao::ShapeKind::capsule, {s.radius_m, s.half_height_m}); }
  void operator()(const Cylinder& s) const {
    put(colisao::ShapeKind::cylinder, {s.radius_m, s.half_height_m});
  }
  void operator()(const Cone& s) const { put(colisao::ShapeKind::cone, {s.radius_m, s.height_m}); }
  void operator()(const HalfSpace& s) const {
    put(colisao::ShapeKind::plane, {s.normal.x(), s.normal.y(), s.normal.z(), s.offset_m});
  }
  void operator()(const Hull& s) const {
    put(colisao::ShapeKind::hull, {});
    for (const Vec3& vertex : s.vertices_m) {
      for (int k = 0; k < 3; ++k) record.vertices_m.push_back(vertex[k]);
    }
    for (const auto& face : s.faces) record.faces.emplace_back(face.begin(), face.end());
  }
};

colisao::MotionKind kind_of(Motion motion) {
  switch (motion) {
    case Motion::dynamic:
      return colisao::MotionKind::dynamic;
    case Motion::fixed:
      return colisao::MotionKind::fixed;
    case Motion::kinematic:
      break;
  }
  return colisao::MotionKind::kinematic;
}

colisao::Rule rule_of(RestitutionRule rule) {
  switch (rule) {
    case RestitutionRule::product:
      return colisao::Rule::product;
    case RestitutionRule::min:
      return colisao::Rule::min;
    case RestitutionRule::max:
      return colisao::Rule::max;
    case RestitutionRule::mean:
      break;
  }
  return colisao::Rule::mean;
}

colisao::BodyRecord collider(const Body& body) {
  colisao::BodyRecord record;
  record.name = body.name;
  std::visit(ShapeRecord{record}, body.shape);
  record.motion = kind_of(body.motion);
  record.restitution = body.restitution;
  record.friction = body.friction;
  record.group = body.group;
  record.collides_with = body.collides_with;
  if (body.motion != Motion::dynamic) return record;
  record.mass_kg = body.mass_kg;
  record.center_of_mass_m = numbers(body.center_of_mass_m);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      record.inertia_kg_m2.push_back(body.inertia_kg_m2(row, column));
  }
  return record;
}

}  // namespace

std::vector<Inertia> inertias(const Scene& scene) {
  std::vector<Inertia> all;
  for (const Body& body : scene.bodies) {
    if (body.motion == Motion::dynamic) {
      all.push_back({body.mass_kg, body.center_of_mass_m, body.inertia_kg_m2});
    } else {
      all.emplace_back();
    }
  }
  return all;
}

std::vector<Drive> drives(const Scene& scene, const SceneScope& scope) {
  std::vector<Drive> all;
  for (size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    if (body.motion != Motion::dynamic || !is_driven(body)) continue;
    all.push_back({i, compiled(scope, body.forces), compiled(scope, body.torques),
                   compiled(scope, body.local_forces), compiled(scope, body.local_torques),
                   body.linear_damping_1_s, body.angular_damping_1_s});
  }
  return all;
}

std::vector<Path> paths(const Scene& scene, const SceneScope& scope) {
  std::vector<Path> all;
  for (size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    if (body.motion != Motion::kinematic) continue;
    Path path;
    path.body = i;
    if (body.path_position) path.position.emplace(scope, *body.path_position);
    if (body.path_rotation) path.rotation.emplace(scope, *body.path_rotation);
    path.rotation_order = body.rotation_order;
    path.script = body.script;
    path.start.pose = {body.position_m, body.orientation};
    all.push_back(std::move(path));
  }
  return all;
}

colisao::Prepare::Request colliders(const Scene& scene) {
  colisao::Prepare::Request request;
  for (const Body& body : scene.bodies) request.bodies.push_back(collider(body));
  request.restitution_rule = rule_of(scene.world.restitution_rule);
  request.contact_threshold_m_s = scene.world.contact_threshold_m_s;
  return request;
}

}  // namespace animado::controle
