// What the five modules said to each other during one step, read from the run's logs: the report draws it as
// a sequence diagram.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "controle/results/events_jsonl.hpp"

namespace animado::report {

struct Message {
  double at_us = 0;    // when it was sent, since the step's first
  double took_us = 0;  // until its reply
  std::string from, to, method;

  bool operator==(const Message&) const = default;
};

struct Traffic {
  double time_s = 0;  // at the step's end
  int64_t step = 0;   // counted from 1
  double span_us = 0;
  std::vector<Message> messages = {};  // in the order in which they were sent
};

// Of the first step with an impact; of a plain step near the beginning where there is none. Nothing when the
// logs have no step that is short enough to be drawn. logs: the folder with controle.log.
std::optional<Traffic> read_traffic(const std::filesystem::path& logs,
                                    std::span<const controle::Event> events);

}  // namespace animado::report
