#include "controle/results/recorded_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "controle/results/states_csv.hpp"
#include "controle/results/table_reader.hpp"
#include "controle/scene/text_file.hpp"

namespace animado::controle {
namespace {

using EventLine = nlohmann::json;

constexpr auto kRemedy = "simulate the scene again: animado run SCENE";

RecordedState state_of(const std::array<double, 16>& n) {
  return {{{n[0], n[1], n[2]}, Quat(n[3], n[4], n[5], n[6])},
          {n[7], n[8], n[9]},
          {n[10], n[11], n[12]},
          {n[13], n[14], n[15]}};
}

// A frame that was begun and not ended, as a run that was lost leaves it, is not there.
void read_states(const std::filesystem::path& file, RecordedRun& run) {
  TableReader table(file, kStatesHeader);
  std::array<double, 16> numbers;
  while (table.next_row()) {
    table.cell();  // the frame
    const double time_s = table.number();
    const size_t body = run.states.size() % std::max<size_t>(run.bodies.size(), 1);
    if (run.bodies.empty() || table.cell() != run.bodies[body].name)
      table.refuse("a row of another body than bodies.json says");
    table.numbers(numbers);
    run.states.push_back(state_of(numbers));
    if (body + 1 == run.bodies.size()) run.times_s.push_back(time_s);
  }
  run.states.resize(run.times_s.size() * run.bodies.size());
}

void read_facts(const std::filesystem::path& file, RecordedRun& run) {
  TableReader table(file, frames_header());
  std::array<double, kFactColumns> numbers;
  while (table.next_row() && run.facts.size() < run.frames()) {
    table.cell();  // the frame
    const double time_s = table.number();
    table.numbers(numbers);
    run.facts.push_back(facts_of(time_s, numbers));
  }
  if (run.facts.size() != run.frames())
    throw Error(Code::syntax, fmt::format("{} frames, but states.csv has {}", run.facts.size(), run.frames()),
                file.string(), kRemedy);
}

std::optional<Vec3> vector_in(const EventLine& line, const char* key) {
  if (!line.contains(key)) return std::nullopt;
  const EventLine& v = line.at(key);
  return Vec3(v.at(0).get<double>(), v.at(1).get<double>(), v.at(2).get<double>());
}

template <class T>
std::optional<T> value_in(const EventLine& line, const char* key) {
  return line.contains(key) ? std::optional(line.at(key).get<T>()) : std::nullopt;
}

EventKind kind_named(const std::string& name) {
  const auto found = std::ranges::find(kEventKinds, name);
  if (found == kEventKinds.end())
    throw Error(Code::syntax, fmt::format("no kind of event is named '{}'", name));
  return static_cast<EventKind>(found - kEventKinds.begin());
}

Event event_of(const EventLine& line) {
  return {.time_s = line.at("time_s"),
          .kind = kind_named(line.at("kind")),
          .bodies = line.at("bodies").get<std::vector<std::string>>(),
          .point_m = vector_in(line, "point_m"),
          .normal = vector_in(line, "normal"),
          .impulse_N_s = vector_in(line, "impulse_N_s"),
          .approach_m_s = value_in<double>(line, "approach_m_s"),
          .separation_m_s = value_in<double>(line, "separation_m_s"),
          .name = value_in<std::string>(line, "name"),
          .value = value_in<std::string>(line, "value")};
}

}  // namespace

std::vector<Event> read_events(const std::filesystem::path& file) {
  const std::string text = read_text(file.string());
  std::vector<Event> events;
  size_t number = 0;
  for (const std::string_view line : split(text, "\n")) {
    const std::string where = fmt::format("{}:{}", file.string(), ++number);
    try {
      events.push_back(event_of(EventLine::parse(line)));
    } catch (const EventLine::exception& error) {
      throw Error(Code::syntax, fmt::format("this is not an event: {}", error.what()), where, kRemedy);
    } catch (const Error& error) {
      throw Error(error.code(), error.message(), where, kRemedy);
    }
  }
  return events;
}

std::vector<Event> edits_of(std::vector<Event> events) {
  std::erase_if(events, [](const Event& event) { return event.kind != EventKind::edit; });
  return events;
}

RecordedRun read_run(const std::filesystem::path& directory) {
  const auto text = [&](const char* name) { return read_text((directory / name).string()); };
  if (!std::filesystem::exists(directory / "states.csv")) {
    throw Error(Code::unavailable, "there are no results here", directory.string(),
                "name the folder of a run, for example runs/colisao");
  }
  RecordedRun run;
  run.bodies = parse_bodies(text("bodies.json"), (directory / "bodies.json").string());
  read_states(directory / "states.csv", run);
  read_facts(directory / "frames.csv", run);
  run.events = read_events(directory / "events.jsonl");
  run.summary_json = text("summary.json");
  run.scene_text = text("scene.animado");
  return run;
}

}  // namespace animado::controle
