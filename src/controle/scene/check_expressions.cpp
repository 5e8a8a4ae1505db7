#include "controle/scene/check_expressions.hpp"

#include "base/number_text.hpp"
#include "controle/scene/refusal.hpp"
#include "controle/scene/scope.hpp"

namespace animado::controle {
namespace {

using interexpserv::Program;
using interexpserv::Type;

class Checker {
 public:
  explicit Checker(Scene& scene) : scene_(scene), scope_(scene) {}

  void run() {
    for (Body& body : scene_.bodies) {
      if (body.motion == Motion::kinematic) place(body);
    }
    for (const Body& body : scene_.bodies) {
      for (const auto* lines : {&body.forces, &body.torques, &body.local_forces, &body.local_torques}) {
        for (const Expression& line : *lines) at_start(scope_.compile(line, Type::vector), line);
      }
    }
  }

 private:
  // Puts a body where its path begins, after those whose state the path reads.
  void place(Body& body) {
    if (std::find(placed_.begin(), placed_.end(), &body) != placed_.end()) return;
    open_.push_back(&body);
    if (body.path_position) body.position_m = along(*body.path_position);
    if (body.path_rotation) body.euler_rad = along(*body.path_rotation);
    if (!body.script.empty()) follow_script(body);
    if (body.script.empty()) body.orientation = orientation_of(body.euler_rad, body.rotation_order);
    open_.pop_back();
    placed_.push_back(&body);
  }

  Vec3 along(const Expression& path) {
    const Program program = scope_.compile(path, Type::vector);
    for (const interexpserv::Input& input : program.inputs()) {
      const auto reading = scope_.state_names().find(input.name);
      if (reading->body < 0) continue;
      Body& other = scene_.bodies[static_cast<size_t>(reading->body)];
      if (other.motion != Motion::kinematic) continue;
      refuse_cycle(other, path);
      place(other);
    }
    return at_start(program, path);
  }

  void refuse_cycle(const Body& body, const Expression& path) const {
    const auto first = std::find(open_.begin(), open_.end(), &body);
    if (first == open_.end()) return;
    std::string chain;
    for (auto it = first; it != open_.end(); ++it) chain += (*it)->name + " → ";
    refuse(scene_.path, path.place, Code::cycle, "paths that need each other: " + chain + body.name,
           "let one of them depend on t and on other bodies alone");
  }

  void follow_script(Body& body) const {
    const auto row = std::find_if(body.script.rbegin(), body.script.rend(),
                                  [&](const ScriptRow& r) { return r.time_s <= scene_.time.start_s; });
    const Pose& pose = row == body.script.rend() ? body.script.front().pose : row->pose;
    body.position_m = pose.position_m;
    body.orientation = pose.orientation;
    body.euler_rad = angles_of(pose.orientation, body.rotation_order);
  }

  Vec3 at_start(const Program& program, const Expression& expression) const {
    std::vector<double> inputs;
    for (const interexpserv::Input& input : program.inputs())
      put(*scope_.state_names().find(input.name), inputs);
    Vec3 value;
    program.evaluate(inputs.data(), value.data());
    if (!value.allFinite()) {
      refuse(scene_.path, expression.place, Code::not_finite,
             fmt::format("`{}` is ({}, {}, {}) at the start", expression.text, number_text(value.x()),
                         number_text(value.y()), number_text(value.z())),
             "look for a division by zero or a root of a negative number");
    }
    return value;
  }

  void put(const Reading& reading, std::vector<double>& inputs) const {
    if (reading.member == Member::time) return inputs.push_back(scene_.time.start_s);
    const Body& body = scene_.bodies[static_cast<size_t>(reading.body)];
    const Quat& q = body.orientation;
    switch (reading.member) {
      case Member::qw:
        return inputs.push_back(q.w());
      case Member::qx:
        return inputs.push_back(q.x());
      case Member::qy:
        return inputs.push_back(q.y());
      case Member::qz:
        return inputs.push_back(q.z());
      default:
        break;
    }
    const Vec3& v = reading.member == Member::position   ? body.position_m
                    : reading.member == Member::velocity ? body.velocity_m_s
                                                         : body.angular_velocity_rad_s;
    inputs.insert(inputs.end(), v.data(), v.data() + 3);
  }

  Scene& scene_;
  SceneScope scope_;
  std::vector<const Body*> open_;  // whose paths are being placed, outermost first
  std::vector<const Body*> placed_;
};

}  // namespace

void check_expressions(Scene& scene) {
  Checker(scene).run();
}

}  // namespace animado::controle
