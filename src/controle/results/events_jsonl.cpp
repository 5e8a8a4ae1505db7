#include "controle/results/events_jsonl.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>

namespace animado::controle {
namespace {

std::string number(double value) {
  assert(std::isfinite(value));
  return fmt::format("{:.17g}", value);
}

std::string vector(const Vec3& v) {
  return fmt::format("[{}, {}, {}]", number(v.x()), number(v.y()), number(v.z()));
}

std::string text(const std::string& value) {
  return nlohmann::json(value).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

std::string event_line(const Event& event) {
  std::string line = fmt::format(R"({{"time_s": {}, "kind": "{}", "bodies": [)", number(event.time_s),
                                 kEventKinds[static_cast<size_t>(event.kind)]);
  for (size_t i = 0; i < event.bodies.size(); ++i) line += (i == 0 ? "" : ", ") + text(event.bodies[i]);
  line += ']';
  const auto put = [&](std::string_view key, const auto& value, const auto& print) {
    if (value) line += fmt::format(R"(, "{}": {})", key, print(*value));
  };
  put("point_m", event.point_m, vector);
  put("normal", event.normal, vector);
  put("impulse_N_s", event.impulse_N_s, vector);
  put("approach_m_s", event.approach_m_s, number);
  put("separation_m_s", event.separation_m_s, number);
  put("name", event.name, text);
  put("value", event.value, text);
  return line + '}';
}

void EventsJsonl::write(const Event& event) {
  file_.write(event_line(event) + '\n');
}

}  // namespace animado::controle
