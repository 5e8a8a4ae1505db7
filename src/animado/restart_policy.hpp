// When a service that died is started again. The first time at once; then after pauses that double, so that a
// service that dies at its start does not take the machine; not any more after five deaths in ten seconds.
#pragma once

#include <chrono>
#include <deque>
#include <optional>

namespace animado {

inline constexpr size_t kMostDeaths = 5;
inline constexpr std::chrono::seconds kDeathWindow{10};
// The pauses are 0, 50, 100 and 200 ms: together far below the time limit of a client's call, which waits for
// the service.
inline constexpr std::chrono::milliseconds kFirstPause{50};

class RestartPolicy {
 public:
  using Time = std::chrono::steady_clock::time_point;

  // The service died. How long to wait before it is started again; nothing when it died too often.
  std::optional<std::chrono::milliseconds> died(Time now);

 private:
  std::deque<Time> deaths_;  // those of the last window
};

}  // namespace animado
