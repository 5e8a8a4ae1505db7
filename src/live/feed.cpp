#include "live/feed.hpp"

#include <algorithm>
#include <array>

#include "controle/results/table_reader.hpp"
#include "live/messages.hpp"

namespace animado::live {
namespace {

constexpr size_t kMostLogBytes = 32 * 1024;  // of a module, at a look: a page shows the last lines only

// The new rows, without the header that they may begin with.
std::string take_rows(GrowingFile& file, bool& begun) {
  std::string rows = file.take_lines();
  if (!begun && !rows.empty()) {
    begun = true;
    rows.erase(0, rows.find('\n') + 1);
  }
  return rows;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const size_t end = text.find('\n');
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

}  // namespace

Feed::Feed(const std::filesystem::path& directory, size_t bodies)
    : bodies_(bodies),
      states_(directory / "states.csv"),
      facts_(directory / "frames.csv"),
      events_(directory / "events.jsonl") {
  for (const std::string_view module : kModules) {
    const std::string name(module);
    logs_.emplace_back(name, directory / "logs" / (name + ".log"));
  }
}

Feed::Messages Feed::take() {
  Messages messages;
  take_logs(messages);
  take_events(messages);
  take_frames(messages);
  return messages;
}

void Feed::take_logs(Messages& messages) {
  for (auto& [module, file] : logs_) {
    const std::string text = file.take_lines();
    if (text.empty()) continue;
    std::string_view last = text;
    if (text.size() > kMostLogBytes) {
      last.remove_prefix(text.size() - kMostLogBytes);
      last.remove_prefix(last.find('\n') + 1);
    }
    messages.push_back({{"type", "log"}, {"module", module}, {"lines", lines_of(last)}});
  }
}

void Feed::take_events(Messages& messages) {
  const std::string text = events_.take_lines();
  for (const std::string_view line : lines_of(text)) {
    Json event = Json::parse(line);
    event["type"] = "event";
    messages.push_back(std::move(event));
  }
}

// A frame's states are written before its facts, so that the facts are read first: what they belong to is
// there.
void Feed::take_frames(Messages& messages) {
  read_facts();
  read_states();
  for (; !frame_facts_.empty() && !poses_.empty() && poses_.front().bodies == bodies_; ++frame_) {
    const controle::FrameFacts& facts = frame_facts_.front();
    Json columns = Json::object();
    const auto numbers = numbers_of(facts);
    for (size_t i = 0; i < numbers.size(); ++i) columns[std::string(controle::kFactNames[i])] = numbers[i];
    messages.push_back({{"type", "frame"},
                        {"frame", frame_},
                        {"time_s", facts.time_s},
                        {"position", std::move(poses_.front().positions_m)},
                        {"rotation", std::move(poses_.front().rotations)},
                        {"facts", std::move(columns)}});
    frame_facts_.pop_front();
    poses_.pop_front();
  }
}

void Feed::read_facts() {
  controle::TableReader table(take_rows(facts_, facts_begun_), facts_.path());
  std::array<double, controle::kFactColumns> numbers;
  while (table.next_row()) {
    table.cell();  // the frame
    const double time_s = table.number();
    table.numbers(numbers);
    frame_facts_.push_back(controle::facts_of(time_s, numbers));
  }
}

void Feed::read_states() {
  controle::TableReader table(take_rows(states_, states_begun_), states_.path());
  std::array<double, 7> pose;
  while (table.next_row()) {
    for (int skipped = 0; skipped < 3; ++skipped) table.cell();  // frame, time, body
    table.numbers(pose);
    if (poses_.empty() || poses_.back().bodies == bodies_) poses_.emplace_back();
    Poses& frame = poses_.back();
    for (size_t i = 0; i < 3; ++i) frame.positions_m.push_back(pose[i]);
    for (size_t i = 3; i < 7; ++i) frame.rotations.push_back(pose[i]);
    ++frame.bodies;
  }
}

}  // namespace animado::live
