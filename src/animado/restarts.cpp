#include "animado/restarts.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "controle/results/events_jsonl.hpp"
#include "controle/results/output_file.hpp"

namespace animado {

namespace {

struct Line {
  double time_s;
  std::string text;
};

std::vector<Line> read_lines(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw Error(Code::unavailable, "cannot read the events", file.string());
  std::vector<Line> lines;
  for (std::string text; std::getline(in, text);) {
    lines.push_back({nlohmann::json::parse(text).at("time_s").get<double>(), text});
  }
  return lines;
}

}  // namespace

void add_restarts(const std::filesystem::path& events_file, const std::vector<Restart>& restarts) {
  if (restarts.empty()) return;
  std::vector<Line> lines = read_lines(events_file);
  for (const Restart& restart : restarts) {
    controle::Event event;
    event.time_s = restart.time_s;
    event.kind = controle::EventKind::restart;
    event.name = restart.service;
    lines.push_back({event.time_s, controle::event_line(event)});
  }
  std::ranges::stable_sort(lines, {}, &Line::time_s);
  controle::OutputFile out(events_file);
  for (const Line& line : lines) out.write(line.text + '\n');
  out.close();
}

}  // namespace animado
