#include "controle/progress.hpp"

#include "controle/stepper.hpp"

namespace animado::controle {
namespace {

constexpr std::chrono::milliseconds kBetweenReports{200};  // within a frame

}  // namespace

ProgressReports::ProgressReports(const OnProgress& tell, const Stepper& stepper, int64_t frames, double end_s,
                                 int64_t bodies)
    : tell_(tell), stepper_(stepper), frame_s_(stepper.time_s()) {
  progress_.start_s = frame_s_;
  progress_.frames = frames;
  progress_.end_s = end_s;
  progress_.bodies = bodies;
}

void ProgressReports::at_frame(int64_t written) {
  progress_.frame = written;
  report();
  frame_s_ = stepper_.time_s();
  frame_steps_ = stepper_.counts().steps;
}

void ProgressReports::after_step() {
  if (Clock::now() - told_ >= kBetweenReports) report();
}

void ProgressReports::report() {
  const Counts& counts = stepper_.counts();
  progress_.time_s = stepper_.time_s();
  progress_.steps = counts.steps;
  progress_.impacts = counts.impacts;
  progress_.contacts = stepper_.contacts();
  const int64_t steps = counts.steps - frame_steps_;
  progress_.step_s = steps > 0 ? (progress_.time_s - frame_s_) / static_cast<double>(steps) : 0;
  tell_(progress_);
  told_ = Clock::now();
}

}  // namespace animado::controle
