// COLISÃO: finds collisions and answers them. The messages, as the module's manual page. It knows shapes,
// poses, velocities, masses.
//
// States are arrays of shape (13, bodies), rows as in base/state.hpp: position, quaternion (w, x, y, z),
// velocity of the frame's origin (world), angular velocity (BODY axes). Wrenches and accelerations are arrays
// of shape (6, bodies).
#pragma once

#include <array>
#include <optional>

#include "rpc/message.hpp"

namespace animado::colisao {

using rpc::Array;
using rpc::kDefault;
using namespace std::string_view_literals;

enum class ShapeKind { sphere, box, capsule, cylinder, cone, hull, plane };
constexpr auto names(const ShapeKind*) {
  return std::array{"sphere"sv, "box"sv, "capsule"sv, "cylinder"sv, "cone"sv, "hull"sv, "plane"sv};
}
enum class MotionKind { dynamic, fixed, kinematic };
constexpr auto names(const MotionKind*) {
  return std::array{"dynamic"sv, "static"sv, "kinematic"sv};
}

enum class Rule { product, min, max, mean };
constexpr auto names(const Rule*) {
  return std::array{"product"sv, "min"sv, "max"sv, "mean"sv};
}

enum class Response { impulse, system15, spring };
constexpr auto names(const Response*) {
  return std::array{"impulse"sv, "system15"sv, "spring"sv};
}

enum class Meeting { vertex_face, edge_edge, vertex_vertex };
constexpr auto names(const Meeting*) {
  return std::array{"vertex_face"sv, "edge_edge"sv, "vertex_vertex"sv};
}

struct BodyRecord {
  std::string name;
  ShapeKind shape = ShapeKind::sphere;
  std::vector<double> size_m;      // by shape, see the field
  std::vector<double> vertices_m;  // hull
  std::vector<std::vector<int64_t>> faces;
  MotionKind motion = MotionKind::dynamic;
  double mass_kg = 0;
  std::vector<double> center_of_mass_m = {0, 0, 0}, inertia_kg_m2;
  double restitution = 0.5, friction = 0;
  std::string group;
  std::vector<std::string> collides_with;
  template <class Self, class F>
  static void fields(Self& s, F&& field) {
    field("name", s.name, "for messages");
    field("shape", s.shape, "sphere, box, capsule, cylinder, cone, hull or plane");
    field("size_m", s.size_m,
          "sphere: radius; box: half extents x, y, z; capsule, cylinder: radius, half height; cone: radius, "
          "height; plane: "
          "normal x, y, z, offset; hull: nothing",
          kDefault);
    field("vertices_m", s.vertices_m, "hull: x, y, z of each vertex, body frame", kDefault);
    field("faces", s.faces, "hull: vertex indices of each face, counter-clockwise from outside", kDefault);
    field("motion", s.motion, "dynamic, static or kinematic (moves as it is told; infinite mass)", kDefault);
    field("mass_kg", s.mass_kg, "of a dynamic body", kDefault);
    field("center_of_mass_m", s.center_of_mass_m, "x, y, z in the body frame", kDefault);
    field("inertia_kg_m2", s.inertia_kg_m2, "nine elements of the tensor about the centre of mass, body axes",
          kDefault);
    field("restitution", s.restitution, "0 … 1", kDefault);
    field("friction", s.friction, "Coulomb's coefficient; a pair uses the geometric mean", kDefault);
    field("group", s.group, "its group", kDefault);
    field("collides_with", s.collides_with, "groups it may meet; empty means all", kDefault);
  }
};

struct Prepare {
  static constexpr auto name = "prepare"sv;
  static constexpr auto doc =
      "Makes the bodies known. The handle is a hash of the request: the same bodies give the same handle on "
      "any server, so that a "
      "client whose server was restarted (code unknown_handle) prepares again and repeats its request."sv;
  struct Request {
    std::vector<BodyRecord> bodies;
    Rule restitution_rule = Rule::product;
    double contact_threshold_m_s = 0.01;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("bodies", s.bodies, "in the order of the state's columns");
      field("restitution_rule", s.restitution_rule, "how a pair's restitution is made of its bodies'",
            kDefault);
      field("contact_threshold_m_s", s.contact_threshold_m_s,
            "approach speed under which bodies are in continuous contact and do not bounce", kDefault);
    }
  };
  struct Reply {
    std::string handle;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("handle", s.handle, "names the bodies in other messages");
    }
  };
};

struct ContactRecord {
  int64_t a = 0, b = 0;
  std::vector<double> point_m, normal;
  double gap_m = 0, approach_m_s = 0;
  Meeting kind = Meeting::vertex_face;
  template <class Self, class F>
  static void fields(Self& s, F&& field) {
    field("a", s.a, "index of the paper's object 1");
    field("b", s.b, "index of object 2");
    field("point_m", s.point_m, "world");
    field("normal", s.normal, "the paper's k: unit, from b towards a");
    field("gap_m", s.gap_m, "negative when they overlap");
    field("approach_m_s", s.approach_m_s, "speed at which the surfaces near each other at the point");
    field("kind", s.kind, "what met: vertex and face, edges, vertices");
  }
};

struct Contacts {
  static constexpr auto name = "contacts"sv;
  static constexpr auto doc = "Lists the contacts of a state."sv;
  struct Request {
    std::string handle;
    Array state;
    double margin_m = 1e-6;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("handle", s.handle, "from prepare");
      field("state", s.state, "shape (13, bodies)");
      field("margin_m", s.margin_m, "surfaces nearer than this count as touching", kDefault);
    }
  };
  struct Reply {
    std::vector<ContactRecord> contacts;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("contacts", s.contacts, "by pair, then by feature");
    }
  };
};

struct Sweep {
  static constexpr auto name = "sweep"sv;
  static constexpr auto doc =
      "Finds the first time at which two bodies that were apart meet on the way between two states, on the "
      "cubic Hermite "
      "interpolant of positions and quaternions (the dense output of a step), by conservative advancement "
      "and bracketing. Bodies that touch "
      "at the start count again once they have parted. Resting pairs are left to advance."sv;
  struct Request {
    std::string handle;
    Array from, to;
    double step_s = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("handle", s.handle, "from prepare");
      field("from", s.from, "state at 0, shape (13, bodies)");
      field("to", s.to, "state at step_s");
      field("step_s", s.step_s, "time between them");
    }
  };
  struct Reply {
    bool hit = false, near = false;
    double time_s = 0;
    int64_t a = -1, b = -1, candidates = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("hit", s.hit, "whether anything met");
      field("near", s.near, "whether any two bodies are so near at the end that contacts is worth asking");
      field("time_s", s.time_s, "when, from 0; step_s when nothing met");
      field("a", s.a, "first body of the pair that met, or -1");
      field("b", s.b, "second body, or -1");
      field("candidates", s.candidates, "pairs whose bounding boxes met");
    }
  };
};

struct ImpactRecord {
  int64_t a = 0, b = 0;
  double time_s = 0;
  std::vector<double> point_m, normal, impulse_N_s;
  double approach_m_s = 0, separation_m_s = 0;
  template <class Self, class F>
  static void fields(Self& s, F&& field) {
    field("a", s.a, "index of object 1, which takes +impulse");
    field("b", s.b, "index of object 2, which takes -impulse");
    field("time_s", s.time_s, "from the start of the request's interval", kDefault);
    field("point_m", s.point_m, "world");
    field("normal", s.normal, "the paper's k");
    field("impulse_N_s", s.impulse_N_s, "P, world");
    field("approach_m_s", s.approach_m_s, "normal speed before");
    field("separation_m_s", s.separation_m_s, "normal speed after");
  }
};

struct Respond {
  static constexpr auto name = "respond"sv;
  static constexpr auto doc =
      "Answers the impacts of a state: every contact whose approach is faster than the threshold, together "
      "with those that their "
      "impulses make approach (simultaneous impact by generalized reflections). Writes the state after them."sv;
  struct Request {
    std::string handle;
    Array state;
    Response response = Response::impulse;
    std::optional<Array> out;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("handle", s.handle, "from prepare");
      field("state", s.state, "shape (13, bodies), at the time of the impact");
      field("response", s.response,
            "impulse (closed form) or system15 (the paper's 15 equations, solved by egesp)", kDefault);
      field("out", s.out, "shared array for the state after; inline reply when missing");
    }
  };
  struct Reply {
    Array state;
    std::vector<ImpactRecord> impacts;
    double dissipated_impact_J = 0, dissipated_friction_J = 0, kinematic_work_J = 0;
    int64_t rounds = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("state", s.state, "after the impacts");
      field("impacts", s.impacts, "what was answered; empty when nothing approached");
      field("dissipated_impact_J", s.dissipated_impact_J, "kinetic energy lost along the normals");
      field("dissipated_friction_J", s.dissipated_friction_J, "kinetic energy lost to friction");
      field("kinematic_work_J", s.kinematic_work_J, "work of kinematic bodies on the others");
      field("rounds", s.rounds, "rounds of reflection");
    }
  };
};

struct Advance {
  static constexpr auto name = "advance"sv;
  static constexpr auto doc =
      "Moves the islands of bodies in continuous contact through a step: from the same start and the same "
      "accelerations as the free "
      "motion, in sub-steps, with contacts as constraints on the velocities (non-penetration, Coulomb's "
      "cone). Bodies that touch "
      "nothing keep the free result."sv;
  struct Request {
    std::string handle;
    Array state, accelerations, free;
    double step_s = 0;
    int64_t substeps = 1;
    bool crowded = false;
    std::optional<Array> out;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("handle", s.handle, "from prepare");
      field("state", s.state, "at the start, shape (13, bodies)");
      field("accelerations", s.accelerations,
            "at the start, shape (6, bodies): of the frame's origin (world), angular (body axes), without "
            "contact forces");
      field("free", s.free, "state at the end as if nothing touched, shape (13, bodies)");
      field("step_s", s.step_s, "length of the step");
      field("substeps", s.substeps, "sub-steps of the islands", kDefault);
      field("crowded", s.crowded,
            "take impacts inside the islands too, at the sub-steps, instead of leaving them to sweep",
            kDefault);
      field("out", s.out, "shared array for the state at the end; inline reply when missing");
    }
  };
  struct Reply {
    Array state;
    std::vector<int64_t> moved;
    std::vector<ImpactRecord> impacts;
    double dissipated_impact_J = 0, dissipated_friction_J = 0, kinematic_work_J = 0;
    int64_t islands = 0, contacts = 0, iterations = 0;
    double residual_m_s = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("state", s.state, "at the end");
      field("moved", s.moved, "bodies that were in islands, in order");
      field("impacts", s.impacts, "impacts inside the islands (crowded)");
      field("dissipated_impact_J", s.dissipated_impact_J, "kinetic energy lost along the normals");
      field("dissipated_friction_J", s.dissipated_friction_J, "kinetic energy lost to friction");
      field("kinematic_work_J", s.kinematic_work_J, "work of kinematic bodies on the others");
      field("islands", s.islands, "islands");
      field("contacts", s.contacts, "contact points of the last sub-step");
      field("iterations", s.iterations, "iterations of the contact solver, the most of any sub-step");
      field("residual_m_s", s.residual_m_s, "largest change of a relative velocity in its last iteration");
    }
  };
};

struct Springs {
  static constexpr auto name = "springs"sv;
  static constexpr auto doc =
      "Forces of elastic contact, the paper's equation (2): a spring along the normal in proportion to the "
      "overlap and a damper in "
      "proportion to the approach; Coulomb's friction at most mu times the normal force."sv;
  struct Request {
    std::string handle;
    Array state;
    double stiffness_N_m = 0, damping_N_s_m = 0;
    std::optional<Array> out;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("handle", s.handle, "from prepare");
      field("state", s.state, "shape (13, bodies)");
      field("stiffness_N_m", s.stiffness_N_m, "k of the spring");
      field("damping_N_s_m", s.damping_N_s_m, "k of the damper");
      field("out", s.out, "shared array for the wrenches; inline reply when missing");
    }
  };
  struct Reply {
    Array wrenches;
    double stored_J = 0;
    std::vector<ContactRecord> contacts;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("wrenches", s.wrenches, "shape (6, bodies): force, and torque about the centre of mass, world");
      field("stored_J", s.stored_J, "energy in the springs");
      field("contacts", s.contacts, "overlapping contacts");
    }
  };
};

using Messages = std::tuple<Prepare, Contacts, Sweep, Respond, Advance, Springs>;

}  // namespace animado::colisao
