#include "report/payload.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "report/blocks.hpp"

namespace animado::report {
namespace {

using Json = nlohmann::ordered_json;
using controle::Event;
using controle::RecordedRun;
using controle::RecordedState;

constexpr size_t kLength_bytes = 4;

using Frames = std::vector<size_t>;

bool moves(const controle::RecordedBody& body) {
  return body.motion != Motion::fixed;
}

// Evenly chosen, the first among them.
Frames shown_frames(const RecordedRun& run) {
  const auto moving = static_cast<size_t>(std::ranges::count_if(run.bodies, moves));
  const size_t stride = (run.frames() * moving + kMostStates - 1) / kMostStates;
  Frames frames;
  for (size_t k = 0; k < run.frames(); k += std::max<size_t>(stride, 1)) frames.push_back(k);
  return frames;
}

// What does not move needs one frame.
Frames frames_of(const controle::RecordedBody& body, const Frames& shown) {
  return moves(body) ? shown : Frames{0};
}

Json bodies_of(const RecordedRun& run, const Frames& shown) {
  Json bodies = std::move(Json::parse(controle::bodies_text(run.bodies)).at("bodies"));
  for (size_t i = 0; i < bodies.size(); ++i) bodies[i]["frames"] = frames_of(run.bodies[i], shown).size();
  return bodies;
}

// A value a frame, body after body.
template <class Value>
std::vector<std::vector<Value>> gather(const RecordedRun& run, const Frames& shown,
                                       Value (*value_of)(const RecordedState&)) {
  std::vector<std::vector<Value>> bodies(run.bodies.size());
  for (size_t i = 0; i < bodies.size(); ++i) {
    for (const size_t k : frames_of(run.bodies[i], shown)) bodies[i].push_back(value_of(run.at(k, i)));
  }
  return bodies;
}

void add_facts(const RecordedRun& run, const Frames& shown, Blocks& blocks) {
  std::vector<double> times_s;
  std::vector<std::vector<double>> columns(controle::kFactColumns);
  for (const size_t k : shown) {
    times_s.push_back(run.times_s[k]);
    const auto numbers = numbers_of(run.facts[k]);
    for (size_t c = 0; c < numbers.size(); ++c) columns[c].push_back(numbers[c]);
  }
  blocks.add("time_s", times_s);
  for (size_t c = 0; c < columns.size(); ++c)
    blocks.add(fmt::format("facts.{}", controle::kFactNames[c]), columns[c]);
}

Blocks arrays(const RecordedRun& run, const Frames& shown) {
  const auto vectors = [&](Vec3 (*of)(const RecordedState&)) { return gather<Vec3>(run, shown, of); };
  Blocks blocks;
  add_facts(run, shown, blocks);
  blocks.add_vectors("position", vectors([](const auto& s) { return s.pose.position_m; }));
  blocks.add_rotations("rotation",
                       gather<Quat>(run, shown, [](const auto& s) { return s.pose.orientation; }));
  blocks.add_vectors("velocity", vectors([](const auto& s) { return s.velocity_m_s; }));
  blocks.add_vectors("angular_velocity", vectors([](const auto& s) { return s.angular_velocity_rad_s; }));
  return blocks;
}

// The strength below which impacts are left out; what is no impact always stays.
double weakest_shown(const std::vector<Event>& events) {
  if (events.size() <= kMostEvents) return 0;
  std::vector<double> impulses_N_s;
  for (const Event& event : events) {
    if (event.impulse_N_s) impulses_N_s.push_back(event.impulse_N_s->norm());
  }
  if (impulses_N_s.size() <= kMostEvents) return 0;
  const auto last_shown = impulses_N_s.begin() + static_cast<ptrdiff_t>(kMostEvents) - 1;
  std::ranges::nth_element(impulses_N_s, last_shown, std::greater());
  return *last_shown;
}

std::string events_text(const std::vector<Event>& events) {
  const double weakest_N_s = weakest_shown(events);
  std::string text = "[";
  for (const Event& event : events) {
    if (event.impulse_N_s && event.impulse_N_s->norm() < weakest_N_s) continue;
    if (text.size() > 1) text += ',';
    text += event_line(event);
  }
  text += ']';
  return text;
}

Json json_of(const std::optional<Traffic>& traffic) {
  if (!traffic) return nullptr;
  Json messages = Json::array();
  for (const Message& m : traffic->messages)
    messages.push_back(
        {{"at_us", m.at_us}, {"took_us", m.took_us}, {"from", m.from}, {"to", m.to}, {"method", m.method}});
  return {{"time_s", traffic->time_s},
          {"step", traffic->step},
          {"span_us", traffic->span_us},
          {"messages", messages}};
}

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json summary_of(const RecordedRun& run) try {
  return Json::parse(run.summary_json);
} catch (const Json::exception& error) {
  throw Error(Code::syntax, fmt::format("the summary cannot be read: {}", error.what()), "summary.json",
              "simulate the scene again: animado run SCENE");
}

std::string header(const RecordedRun& run, const Frames& shown, const std::optional<Traffic>& traffic,
                   const Json& index) {
  const Json summary = summary_of(run);
  const Json page = {{"format", kPayloadFormat},
                     {"version", ANIMADO_VERSION},
                     {"scene", summary.value("scene", "")},
                     {"scene_text", run.scene_text},
                     {"summary", summary},
                     {"bodies", bodies_of(run, shown)},
                     {"events_total", run.events.size()},
                     {"frames", shown.size()},
                     {"frames_total", run.frames()},
                     {"traffic", json_of(traffic)},
                     {"arrays", index}};
  std::string text = text_of(page);
  text.pop_back();  // the closing brace; an event is JSON already
  text += R"(,"events":)" + events_text(run.events);
  text += '}';
  return text;
}

}  // namespace

std::string payload(const RecordedRun& run, const std::optional<Traffic>& traffic) {
  if (run.frames() == 0) {
    throw Error(Code::refused, "the run has no frames, so there is nothing to show", "states.csv",
                "simulate the scene again: animado run SCENE");
  }
  const Frames shown = shown_frames(run);
  const Blocks blocks = arrays(run, shown);
  std::string text = header(run, shown, traffic, blocks.index());
  while ((kLength_bytes + text.size()) % kAlignment_bytes != 0) text += ' ';
  const auto length = static_cast<uint32_t>(text.size());
  std::string bytes(kLength_bytes, '\0');
  std::memcpy(bytes.data(), &length, kLength_bytes);
  return bytes + text + blocks.bytes();
}

}  // namespace animado::report
