#include "animado/progress_text.hpp"

#include <fmt/format.h>

#include "console/progress_line.hpp"

namespace animado {

double part_of(const controle::Progress& progress) {
  const double length_s = progress.end_s - progress.start_s;
  return length_s > 0 ? (progress.time_s - progress.start_s) / length_s : 1;
}

std::string progress_text(const controle::Progress& progress, double elapsed_s) {
  const double part = part_of(progress);
  // What matters most comes first: a narrow terminal shows only that.
  std::string text = fmt::format("{} frame {} of {}, t = {:.4g} s{}, {} {}, {} {}", progress_bar(part),
                                 progress.frame, progress.frames, progress.time_s, time_left(part, elapsed_s),
                                 progress.bodies, progress.bodies == 1 ? "body" : "bodies", progress.contacts,
                                 progress.contacts == 1 ? "contact" : "contacts");
  if (elapsed_s <= 0 || progress.steps == 0) return text;
  return text + fmt::format(", {:.0f} steps/s of {:.2g} s", static_cast<double>(progress.steps) / elapsed_s,
                            progress.step_s);
}

}  // namespace animado
