#include "animado/run_curves.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>

#include "base/error.hpp"
#include "base/fold.hpp"
#include "base/nearest_name.hpp"

namespace animado {

namespace {

using controle::FrameFacts;
using controle::RecordedRun;
using controle::RecordedState;

struct OfState {
  const char *name, *quantity, *unit;
  double (*value)(const RecordedState&);
};

constexpr std::array<OfState, 14> kOfStates = {{
    {"x", "position", "m", [](const RecordedState& s) { return s.pose.position_m.x(); }},
    {"y", "position", "m", [](const RecordedState& s) { return s.pose.position_m.y(); }},
    {"z", "position", "m", [](const RecordedState& s) { return s.pose.position_m.z(); }},
    {"vx", "velocity", "m/s", [](const RecordedState& s) { return s.velocity_m_s.x(); }},
    {"vy", "velocity", "m/s", [](const RecordedState& s) { return s.velocity_m_s.y(); }},
    {"vz", "velocity", "m/s", [](const RecordedState& s) { return s.velocity_m_s.z(); }},
    {"speed", "velocity", "m/s", [](const RecordedState& s) { return s.velocity_m_s.norm(); }},
    {"wx", "angular velocity", "rad/s", [](const RecordedState& s) { return s.angular_velocity_rad_s.x(); }},
    {"wy", "angular velocity", "rad/s", [](const RecordedState& s) { return s.angular_velocity_rad_s.y(); }},
    {"wz", "angular velocity", "rad/s", [](const RecordedState& s) { return s.angular_velocity_rad_s.z(); }},
    {"spin", "angular velocity", "rad/s",
     [](const RecordedState& s) { return s.angular_velocity_rad_s.norm(); }},
    {"ex", "Euler angle", "rad", [](const RecordedState& s) { return s.euler_rad.x(); }},
    {"ey", "Euler angle", "rad", [](const RecordedState& s) { return s.euler_rad.y(); }},
    {"ez", "Euler angle", "rad", [](const RecordedState& s) { return s.euler_rad.z(); }},
}};

double lost_J(const FrameFacts& f) {
  return f.dissipated_impacts_J + f.dissipated_friction_J + f.dissipated_damping_J;
}

struct OfFrames {
  const char *what, *quantity, *unit, *name;
  double (*value)(const FrameFacts&);
  bool may_be_left_out;  // where it is zero throughout
};

constexpr std::array<OfFrames, 15> kOfFrames = {{
    {"energy", "energy", "J", "total",
     [](const FrameFacts& f) { return f.kinetic_J + f.potential_J + f.elastic_J; }, false},
    {"energy", "energy", "J", "kinetic", [](const FrameFacts& f) { return f.kinetic_J; }, false},
    {"energy", "energy", "J", "potential", [](const FrameFacts& f) { return f.potential_J; }, true},
    {"energy", "energy", "J", "elastic", [](const FrameFacts& f) { return f.elastic_J; }, true},
    {"energy", "energy", "J", "work put in", [](const FrameFacts& f) { return f.work_in_J; }, true},
    {"energy", "energy", "J", "lost", lost_J, true},
    {"residual", "energy unaccounted for", "J", "residual", [](const FrameFacts& f) { return f.residual_J; },
     false},
    {"momentum", "momentum", "kg m/s", "px", [](const FrameFacts& f) { return f.linear_kg_m_s.x(); }, false},
    {"momentum", "momentum", "kg m/s", "py", [](const FrameFacts& f) { return f.linear_kg_m_s.y(); }, false},
    {"momentum", "momentum", "kg m/s", "pz", [](const FrameFacts& f) { return f.linear_kg_m_s.z(); }, false},
    {"momentum", "angular momentum", "kg m²/s", "Lx",
     [](const FrameFacts& f) { return f.angular_kg_m2_s.x(); }, false},
    {"momentum", "angular momentum", "kg m²/s", "Ly",
     [](const FrameFacts& f) { return f.angular_kg_m2_s.y(); }, false},
    {"momentum", "angular momentum", "kg m²/s", "Lz",
     [](const FrameFacts& f) { return f.angular_kg_m2_s.z(); }, false},
    {"contacts", "contact points", "", "contacts",
     [](const FrameFacts& f) { return static_cast<double>(f.contacts); }, false},
    {"step", "step", "s", "step", [](const FrameFacts& f) { return f.step_s > 0 ? f.step_s : NAN; }, false},
}};

class Chooser {
 public:
  explicit Chooser(const RecordedRun& run) : run_(run), found_{run.times_s, {}} {}

  void choose(const std::string& name) {
    if (!of_frames(name) && !of_body(name)) refuse(name);
  }
  RunCurves take() { return std::move(found_); }

 private:
  bool of_frames(const std::string& name) {
    bool known = false;
    for (const OfFrames& source : kOfFrames) {
      if (source.what != name) continue;
      known = true;
      Curve curve{source.name, {}};
      for (const FrameFacts& facts : run_.facts) curve.y.push_back(source.value(facts));
      if (source.may_be_left_out && std::ranges::all_of(curve.y, [](double y) { return y == 0; })) continue;
      add(source.quantity, source.unit, std::move(curve));
    }
    return known;
  }

  bool of_body(const std::string& name) {
    const size_t dot = name.rfind('.');
    if (dot == name.npos) return false;
    const std::string wanted = fold(name.substr(0, dot));
    const auto body =
        std::ranges::find(run_.bodies, wanted, [](const auto& candidate) { return fold(candidate.name); });
    const auto source = std::ranges::find(kOfStates, name.substr(dot + 1), &OfState::name);
    if (body == run_.bodies.end() || source == kOfStates.end()) return false;
    const auto index = static_cast<size_t>(body - run_.bodies.begin());
    Curve curve{fmt::format("{}.{}", body->name, source->name), {}};
    for (size_t frame = 0; frame < run_.frames(); ++frame)
      curve.y.push_back(source->value(run_.at(frame, index)));
    add(source->quantity, source->unit, std::move(curve));
    return true;
  }

  void add(const std::string& quantity, const std::string& unit, Curve curve) {
    const auto same = [&](const Panel& panel) { return panel.quantity == quantity; };
    auto panel = std::ranges::find_if(found_.panels, same);
    if (panel == found_.panels.end()) panel = found_.panels.insert(panel, {quantity, unit, {}});
    panel->curves.push_back(std::move(curve));
  }

  [[noreturn]] void refuse(const std::string& name) const {
    std::vector<std::string> known, endings;
    for (const OfFrames& source : kOfFrames) {
      if (known.empty() || known.back() != source.what) known.emplace_back(source.what);
    }
    const std::string of_runs = fmt::format("{}", fmt::join(known, ", "));
    for (const OfState& source : kOfStates) endings.emplace_back(source.name);
    for (const auto& body : run_.bodies) {
      for (const std::string& ending : endings) known.push_back(body.name + "." + ending);
    }
    const std::string nearest = nearest_name(name, known);
    const std::string example = run_.bodies.empty() ? "BODY" : run_.bodies.front().name;
    throw Error(Code::unknown_name, fmt::format("there is no curve '{}'", name), {},
                nearest.empty() ? fmt::format("there are {}, and of each body, as {}.y: {}", of_runs, example,
                                              fmt::join(endings, ", "))
                                : fmt::format("is it '{}'?", nearest));
  }

  const RecordedRun& run_;
  RunCurves found_;
};

}  // namespace

RunCurves curves_of(const RecordedRun& run, const std::vector<std::string>& names) {
  Chooser chooser(run);
  for (const std::string& name : names) chooser.choose(name);
  return chooser.take();
}

std::string label_of(const Panel& panel) {
  return panel.unit.empty() ? panel.quantity : fmt::format("{} ({})", panel.quantity, panel.unit);
}

std::string csv_of(const RunCurves& curves) {
  std::string text = "time_s";
  auto out = std::back_inserter(text);
  for (const Panel& panel : curves.panels) {
    for (const Curve& curve : panel.curves) fmt::format_to(out, ",{}", curve.name);
  }
  for (size_t frame = 0; frame < curves.times_s.size(); ++frame) {
    fmt::format_to(out, "\n{:.17g}", curves.times_s[frame]);
    for (const Panel& panel : curves.panels) {
      for (const Curve& curve : panel.curves) fmt::format_to(out, ",{:.17g}", curve.y[frame]);
    }
  }
  return text + '\n';
}

}  // namespace animado
