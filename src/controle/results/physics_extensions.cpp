#include "controle/results/physics_extensions.hpp"

#include <tiny_gltf.h>

#include <cmath>
#include <utility>

#include "controle/mass/mass_properties.hpp"

namespace animado::controle {
namespace {

using tinygltf::Value;
using Object = Value::Object;

constexpr auto kShapes = "KHR_implicit_shapes", kBodies = "KHR_physics_rigid_bodies";

Value list(const auto& numbers) {
  Value::Array values;
  for (const double number : numbers) values.emplace_back(number);
  return Value(values);
}

int index_of_next(const auto& items) {
  return static_cast<int>(items.size());
}

// What stands for a solid: a shape of the drafts, where in the body's frame; without a shape, the hull of the
// body's own mesh.
struct Collider {
  std::string type;
  Object size;
  Pose place = {};
};

Object round(double height_m, double bottom_m, double top_m) {
  return {{"height", Value(height_m)}, {"radiusBottom", Value(bottom_m)}, {"radiusTop", Value(top_m)}};
}

struct ColliderOf {
  Collider operator()(const Sphere& s) const { return {"sphere", {{"radius", Value(s.radius_m)}}}; }
  Collider operator()(const Box& s) const { return {"box", {{"size", list(Vec3(2 * s.half_m))}}}; }
  Collider operator()(const Capsule& s) const {
    return {"capsule", round(2 * s.half_height_m, s.radius_m, s.radius_m)};
  }
  Collider operator()(const Cylinder& s) const {
    return {"cylinder", round(2 * s.half_height_m, s.radius_m, s.radius_m)};
  }
  // A cylinder whose upper radius is zero; its origin is at half its height, a cone's at a quarter.
  Collider operator()(const Cone& s) const {
    return {"cylinder", round(s.height_m, s.radius_m, 0), {Vec3(0, s.height_m / 4, 0)}};
  }
  Collider operator()(const Hull&) const { return {}; }
  // Infinite where no size is given; its normal is the node's y.
  Collider operator()(const HalfSpace& s) const {
    return {"plane",
            {{"doubleSided", Value(false)}},
            {s.normal * s.offset_m, Quat::FromTwoVectors(Vec3::UnitY(), s.normal)}};
  }
};

// The draft has velocities in the node's axes, and the velocity is that of the centre of mass.
Value motion_of(const BodyPhysics& body) {
  const Quat& turn = body.start.pose.orientation;
  const Vec3& spin_rad_s = body.start.angular_velocity_body_rad_s;
  const Vec3 velocity_m_s =
      turn.conjugate() * body.start.velocity_m_s + spin_rad_s.cross(body.center_of_mass_m);
  Object motion = {{"linearVelocity", list(velocity_m_s)}, {"angularVelocity", list(spin_rad_s)}};
  if (body.motion == Motion::kinematic) {
    motion["isKinematic"] = Value(true);
  } else {
    const PrincipalAxes axes = principal_axes(body.inertia_kg_m2);
    motion["mass"] = Value(body.mass_kg);
    motion["centerOfMass"] = list(body.center_of_mass_m);
    motion["inertiaDiagonal"] = list(axes.moments_kg_m2);
    motion["inertiaOrientation"] = list(axes.orientation.coeffs());
  }
  return Value(motion);
}

// Two bodies rub with the geometric mean of their frictions, which no rule of the draft is: the product of
// the roots is the same number.
Value material_of(const BodyPhysics& body, const std::string& restitution_combine) {
  const double root = std::sqrt(body.friction);
  return Value(Object{{"staticFriction", Value(root)},
                      {"dynamicFriction", Value(root)},
                      {"frictionCombine", Value(std::string("multiply"))},
                      {"restitution", Value(body.restitution)},
                      {"restitutionCombine", Value(restitution_combine)}});
}

class Writer {
 public:
  Writer(tinygltf::Model& model, const std::string& restitution_combine)
      : model_(model), restitution_combine_(restitution_combine) {}

  void add(size_t node, const BodyPhysics& body) {
    const Collider collider = std::visit(ColliderOf(), body.shape);
    Object geometry = {{"node", Value(static_cast<int>(node))}, {"convexHull", Value(true)}};
    if (!collider.type.empty()) {
      geometry = {{"shape", Value(index_of_next(shapes_))}};
      shapes_.push_back(Value(Object{{"type", Value(collider.type)}, {collider.type, Value(collider.size)}}));
    }
    const Value part(
        Object{{"geometry", Value(geometry)}, {"physicsMaterial", Value(index_of_next(materials_))}});
    materials_.push_back(material_of(body, restitution_combine_));

    const bool elsewhere =
        collider.place.position_m != Vec3::Zero() || !collider.place.orientation.isApprox(Quat::Identity());
    Object own;
    if (body.motion != Motion::fixed) own["motion"] = motion_of(body);
    if (elsewhere) {
      add_child(node, collider.place, part);
    } else {
      own["collider"] = part;
    }
    if (!own.empty()) model_.nodes[node].extensions[kBodies] = Value(own);
  }

  void finish() {
    model_.extensionsUsed = {kBodies};
    model_.extensions[kBodies] = Value(Object{{"physicsMaterials", Value(materials_)}});
    if (shapes_.empty()) return;
    model_.extensionsUsed.push_back(kShapes);
    model_.extensions[kShapes] = Value(Object{{"shapes", Value(shapes_)}});
  }

 private:
  void add_child(size_t parent, const Pose& place, const Value& collider) {
    tinygltf::Node child;
    child.name = model_.nodes[parent].name + " collider";
    child.translation.assign(place.position_m.begin(), place.position_m.end());
    child.rotation.assign(place.orientation.coeffs().begin(), place.orientation.coeffs().end());
    child.extensions[kBodies] = Value(Object{{"collider", collider}});
    model_.nodes[parent].children.push_back(index_of_next(model_.nodes));
    model_.nodes.push_back(std::move(child));
  }

  tinygltf::Model& model_;
  const std::string& restitution_combine_;
  Value::Array shapes_, materials_;
};

}  // namespace

void add_physics(tinygltf::Model& model, std::span<const BodyPhysics> bodies,
                 const std::string& restitution_combine) {
  if (bodies.empty()) return;
  Writer writer(model, restitution_combine);
  for (size_t i = 0; i < bodies.size(); ++i) writer.add(i, bodies[i]);
  writer.finish();
}

}  // namespace animado::controle
