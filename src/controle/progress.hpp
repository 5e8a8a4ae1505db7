// How far a run is, for whoever watches: a callback in the same process, or a line on the descriptor of
// `controle --progress-fd`.
#pragma once

#include <fmt/format.h>

#include <chrono>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>

namespace animado::controle {

class Stepper;

struct Progress {
  int64_t frame = 0, frames = 0;  // written so far, and in all
  double time_s = 0, end_s = 0;   // now, and of the scene
  int64_t bodies = 0, steps = 0, impacts = 0;
  int64_t contacts = 0;  // points that touch
  double step_s = 0;     // mean since the frame before
  double start_s = 0;    // of the scene
};

using OnProgress = std::function<void(const Progress&)>;

// Tells at every frame, and within one that takes long: a stiff scene may need any number of steps there.
class ProgressReports {
 public:
  // frames, end_s, bodies: of the run.
  ProgressReports(const OnProgress& tell, const Stepper& stepper, int64_t frames, double end_s,
                  int64_t bodies);
  void at_frame(int64_t written);
  void after_step();

 private:
  using Clock = std::chrono::steady_clock;
  void report();

  const OnProgress& tell_;
  const Stepper& stepper_;
  Progress progress_;
  double frame_s_ = 0;       // of the last frame,
  int64_t frame_steps_ = 0;  // and the steps until then
  Clock::time_point told_ = Clock::now();
};

// frame frames time_s end_s bodies steps impacts contacts step_s start_s, and the line's end.
inline std::string progress_line(const Progress& p) {
  return fmt::format("{} {} {} {} {} {} {} {} {} {}\n", p.frame, p.frames, p.time_s, p.end_s, p.bodies,
                     p.steps, p.impacts, p.contacts, p.step_s, p.start_s);
}

inline std::optional<Progress> parse_progress_line(const std::string& line) {
  Progress p;
  const int read = std::sscanf(
      line.c_str(), "%" SCNd64 " %" SCNd64 " %lf %lf %" SCNd64 " %" SCNd64 " %" SCNd64 " %" SCNd64 " %lf %lf",
      &p.frame, &p.frames, &p.time_s, &p.end_s, &p.bodies, &p.steps, &p.impacts, &p.contacts, &p.step_s,
      &p.start_s);
  return read == 10 ? std::optional(p) : std::nullopt;
}

}  // namespace animado::controle
