// The lines of the modules' logs that tell who called whom, taken apart.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace animado::report {

// controle.log: `TIME info controle RUN#12 to fred: stage 8.4 µs`.
struct SentCall {
  std::string ended_at;  // as the log writes it
  double took_us = 0;
  std::string to, method;
};
std::optional<SentCall> sent_call(std::string_view line);

// controle.log: `TIME info controle RUN#12 step 3 ends at 0.05 s`, after the step's calls.
struct StepEnd {
  int64_t step = 0;
  double time_s = 0;
};
std::optional<StepEnd> step_end(std::string_view line);

// A service's log: `TIME info egesp RUN#12 solve matrices=(15,15,1) 8.4 µs ok`.
struct ServedCall {
  std::string ended_at;
  double took_us = 0;
  std::string method;
};
std::optional<ServedCall> served_call(std::string_view line);

std::string_view time_of(std::string_view line);  // earlier times are less, as texts too
double microseconds(std::string_view time);       // since midnight, UTC

}  // namespace animado::report
