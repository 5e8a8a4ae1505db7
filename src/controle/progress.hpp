// How far a run is, for whoever watches: a callback in the same process, or a line a frame on the descriptor
// of `controle --progress-fd`.
#pragma once

#include <fmt/format.h>

#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>

namespace animado::controle {

struct Progress {
  int64_t frame = 0, frames = 0;  // written so far, and in all
  double time_s = 0, end_s = 0;   // of the last frame, and of the scene
  int64_t bodies = 0, steps = 0, impacts = 0;
  int64_t contacts = 0;  // points that touch at the last frame
};

using OnProgress = std::function<void(const Progress&)>;  // called at every frame

// frame frames time_s end_s bodies steps impacts contacts, and the line's end.
inline std::string progress_line(const Progress& p) {
  return fmt::format("{} {} {} {} {} {} {} {}\n", p.frame, p.frames, p.time_s, p.end_s, p.bodies, p.steps,
                     p.impacts, p.contacts);
}

inline std::optional<Progress> parse_progress_line(const std::string& line) {
  Progress p;
  const int read = std::sscanf(
      line.c_str(), "%" SCNd64 " %" SCNd64 " %lf %lf %" SCNd64 " %" SCNd64 " %" SCNd64 " %" SCNd64, &p.frame,
      &p.frames, &p.time_s, &p.end_s, &p.bodies, &p.steps, &p.impacts, &p.contacts);
  return read == 8 ? std::optional(p) : std::nullopt;
}

}  // namespace animado::controle
