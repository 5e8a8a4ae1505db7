#include "animado/restart_policy.hpp"

namespace animado {

std::optional<std::chrono::milliseconds> RestartPolicy::died(Time now) {
  while (!deaths_.empty() && now - deaths_.front() >= kDeathWindow) deaths_.pop_front();
  deaths_.push_back(now);
  if (deaths_.size() >= kMostDeaths) return std::nullopt;
  if (deaths_.size() == 1) return std::chrono::milliseconds{0};
  return kFirstPause * (1 << (deaths_.size() - 2));
}

}  // namespace animado
