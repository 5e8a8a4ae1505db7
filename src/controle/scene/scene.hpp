// A scene as its file gives it (docs/scene-format.md), checked: what is constant is a number, what may change
// is the text of an expression that is known to compile. SI units, radians.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/euler.hpp"
#include "base/shape.hpp"
#include "base/spatial.hpp"

namespace animado::controle {

struct Place {  // in the scene's file, both from 1; line 0: a default, not from the file
  int line = 0, column = 0;
};

// Where each property was given, by its canonical name ("center of mass"); "object": where the object was
// opened.
using Places = std::map<std::string, Place, std::less<>>;

struct Expression {
  std::string text;
  Place place;     // of its first character
  int owner = -1;  // the body whose block it stands in: its prefix may be left out. -1: none
};

// `spring.k = 4*pi^2*ball.mass`: a name that expressions may use.
struct Definition {
  std::string name;  // folded
  Expression value;  // of any type, may depend on t and on state; no prefix left out
};

enum class Response { impulse, system15, spring };
enum class RestitutionRule { product, min, max, mean };

struct World {
  Vec3 gravity_m_s2 = Vec3::Zero();  // as the paper's example has none
  std::string method = "rk4";
  std::optional<double> substep_s, tolerance;
  Response response = Response::impulse;
  double spring_stiffness_N_m = 0, spring_damping_N_s_m = 0;  // response spring
  double contact_threshold_m_s = 0.01;
  RestitutionRule restitution_rule = RestitutionRule::product;
  Places places;
};

struct Time {
  double start_s = 0, end_s = 0, step_s = 0;
  Places places;

  // start, start + step, … ≤ end; an end that rounding alone puts before a frame (3.3/0.3) still has it.
  size_t frames() const;
  double frame_time(size_t k) const { return start_s + static_cast<double>(k) * step_s; }
  std::vector<double> frame_times() const;
};

struct Color {
  double r = 0.7, g = 0.7, b = 0.7;  // 0 … 1, sRGB
};

struct ScriptRow {  // of the paper's description file
  double time_s = 0;
  Pose pose;
};

struct Body {
  std::string name, folded_name;  // as written; as expressions and look-ups see it
  Shape shape = Sphere{1};
  Motion motion = Motion::dynamic;

  double mass_kg = 0;                    // 0 for a body that is not dynamic and gives none
  Vec3 center_of_mass_m = Vec3::Zero();  // body frame
  Mat3 inertia_kg_m2 = Mat3::Zero();     // about the centre of mass, body axes
  double restitution = 0.5, friction = 0;

  Vec3 position_m = Vec3::Zero();  // of the body frame's origin
  RotationOrder rotation_order = {0, 1, 2};
  Vec3 euler_rad = Vec3::Zero();               // about x, y and z, in the rotation order
  Quat orientation = Quat::Identity();         // the same, body → world
  Vec3 velocity_m_s = Vec3::Zero();            // of the body frame's origin, world
  Vec3 angular_velocity_rad_s = Vec3::Zero();  // WORLD axes

  // They add up. World axes, or body axes (local); a force acts through the centre of mass.
  std::vector<Expression> forces, torques, local_forces, local_torques;
  double linear_damping_1_s = 0, angular_damping_1_s = 0;

  // Kinematic bodies: either expressions (vectors; rotation: Euler angles in the rotation order; what is
  // missing stays as at the start) or the rows of a description file, by time.
  std::optional<Expression> path_position, path_rotation;
  std::vector<ScriptRow> script;

  Color color;
  std::string group;
  std::vector<std::string> collides_with;  // groups; empty: all
  Places places;
};

struct Scene {
  std::string path, text;
  World world;
  Time time;
  std::vector<Body> bodies;  // in the order of their first mention
  std::vector<Definition> names;

  int body_named(std::string_view name) const;  // any case, accents or none; -1 when there is none
  std::string where(Place place) const;         // file:line:column
};

// Reads a scene, checks it, fills in what the file leaves out. Throws Error with file:line:column and a
// remedy.
Scene read_scene(const std::string& path);
// The same from text; `path` is for messages, and the files that the scene names lie relative to it.
Scene parse_scene(const std::string& text, const std::string& path = "scene.animado");

}  // namespace animado::controle
