// events.jsonl: what happened between the frames, a JSON object a line, in the order of time.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/spatial.hpp"
#include "controle/results/output_file.hpp"

namespace animado::controle {

enum class EventKind { impact, contact_begin, contact_end, edit, restart };

inline constexpr std::array<std::string_view, 5> kEventKinds = {"impact", "contact_begin", "contact_end",
                                                                "edit", "restart"};

// What does not apply to a kind stays empty and is left out of the line.
struct Event {
  double time_s = 0;
  EventKind kind = EventKind::impact;
  std::vector<std::string> bodies = {};       // names: object 1, then object 2
  std::optional<Vec3> point_m = {};           // world
  std::optional<Vec3> normal = {};            // the paper's k: unit, from object 2 towards object 1
  std::optional<Vec3> impulse_N_s = {};       // P, on object 1, world
  std::optional<double> approach_m_s = {};    // normal speed before
  std::optional<double> separation_m_s = {};  // normal speed after
  std::optional<std::string> name = {};       // edit: what was set; restart: the service
  std::optional<std::string> value = {};      // edit: its expression
};

std::string event_line(const Event& event);  // without the line's end; a number that is not finite is a bug

class EventsJsonl {
 public:
  explicit EventsJsonl(const std::filesystem::path& file) : file_(file) {}

  void write(const Event& event);
  void flush() { file_.flush(); }
  void close() { file_.close(); }

 private:
  OutputFile file_;
};

}  // namespace animado::controle
