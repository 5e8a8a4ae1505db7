#include "report/traffic.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <utility>

#include "report/log_line.hpp"

namespace animado::report {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMostMessages = 80;                  // more are no picture any more
constexpr size_t kMostLog_bytes = size_t{256} << 20;  // a second of reading; a long run has gigabytes of log
constexpr double kDay_us = 24 * 3600e6;

struct Step {
  StepEnd end;
  double begin_s = 0;  // the end of the one before
  std::vector<SentCall> calls;
};

bool has_impact(const Step& step, std::span<const controle::Event> events) {
  const bool responds = std::ranges::any_of(step.calls, [](const auto& c) { return c.method == "respond"; });
  return responds && std::ranges::any_of(events, [&](const controle::Event& event) {
           return event.kind == controle::EventKind::impact && event.time_s >= step.begin_s &&
                  event.time_s <= step.end.time_s;
         });
}

// The first step is preceded by what prepares a run, so a plain one is better if it comes second.
std::optional<Step> choose_step(const fs::path& controle_log, std::span<const controle::Event> events) {
  std::ifstream log(controle_log);
  std::optional<Step> plain;
  Step step;
  size_t bytes = 0, steps = 0;
  for (std::string line; bytes < kMostLog_bytes && std::getline(log, line); bytes += line.size() + 1) {
    if (auto call = sent_call(line)) {
      if (step.calls.size() <= kMostMessages) step.calls.push_back(std::move(*call));
    } else if (const auto end = step_end(line)) {
      step.end = *end;
      if (!step.calls.empty() && step.calls.size() <= kMostMessages) {
        if (has_impact(step, events)) return step;
        if (!plain || steps == 1) plain = step;
      }
      step = {.end = {}, .begin_s = end->time_s, .calls = {}};
      ++steps;
    }
  }
  return plain;
}

// Microseconds from one time of a log to a later one; midnight may lie between them.
double between_us(double earlier_us, double later_us) {
  return later_us < earlier_us - kDay_us / 2 ? later_us + kDay_us - earlier_us : later_us - earlier_us;
}

// The logs have no more.
double tenths(double us) {
  return std::round(us * 10) / 10;
}

// egesp answers colisao as it answers controle, with other methods. controle waits for one reply at a time:
// what egesp does while colisao is busy, it does for colisao.
void add_inner_calls(const fs::path& egesp_log, const Step& step, double start_us,
                     std::vector<Message>& messages) {
  const std::string_view first = step.calls.front().ended_at, last = step.calls.back().ended_at;
  const std::vector<Message> outer = messages;
  std::ifstream log(egesp_log);
  for (std::string line; std::getline(log, line) && time_of(line) <= last;) {
    if (time_of(line) < first) continue;
    const auto call = served_call(line);
    if (!call) continue;
    const double end_us = between_us(start_us, microseconds(call->ended_at));
    const double middle_us = end_us - call->took_us / 2;
    const auto is_controles = [&](const Message& m) { return m.to == "egesp" && m.method == call->method; };
    const auto waits = [&](const Message& m) {
      return m.to == "colisao" && m.at_us < middle_us && middle_us < m.at_us + m.took_us;
    };
    if (std::ranges::any_of(outer, waits) && std::ranges::none_of(outer, is_controles))
      messages.push_back({tenths(end_us - call->took_us), call->took_us, "colisao", "egesp", call->method});
  }
}

}  // namespace

std::optional<Traffic> read_traffic(const fs::path& logs, std::span<const controle::Event> events) {
  const auto step = choose_step(logs / "controle.log", events);
  if (!step) return std::nullopt;
  const double start_us = microseconds(step->calls.front().ended_at) - step->calls.front().took_us;
  Traffic traffic{.time_s = step->end.time_s, .step = step->end.step};
  for (const SentCall& call : step->calls) {
    const double end_us = between_us(start_us, microseconds(call.ended_at));
    traffic.messages.push_back(
        {std::max(0.0, tenths(end_us - call.took_us)), call.took_us, "controle", call.to, call.method});
    traffic.span_us = std::max(traffic.span_us, tenths(end_us));
  }
  add_inner_calls(logs / "egesp.log", *step, start_us, traffic.messages);
  std::ranges::stable_sort(traffic.messages, {}, &Message::at_us);
  return traffic;
}

}  // namespace animado::report
