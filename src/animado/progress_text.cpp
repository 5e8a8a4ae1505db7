#include "animado/progress_text.hpp"

#include <fmt/format.h>

#include "console/progress_line.hpp"

namespace animado {

double part_of(const controle::Progress& progress) {
  return progress.frames > 0 ? static_cast<double>(progress.frame) / static_cast<double>(progress.frames) : 0;
}

std::string progress_text(const controle::Progress& progress, double elapsed_s) {
  const double part = part_of(progress);
  std::string text =
      fmt::format("{} frame {} of {}, t = {:.4g} s, {} {}, {} {}", progress_bar(part), progress.frame,
                  progress.frames, progress.time_s, progress.bodies, progress.bodies == 1 ? "body" : "bodies",
                  progress.contacts, progress.contacts == 1 ? "contact" : "contacts");
  if (elapsed_s <= 0 || part <= 0) return text;
  text += fmt::format(", {:.0f} steps/s", static_cast<double>(progress.steps) / elapsed_s);
  return text + time_left(part, elapsed_s);
}

}  // namespace animado
