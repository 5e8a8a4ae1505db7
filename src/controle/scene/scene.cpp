#include "controle/scene/scene.hpp"

#include "base/fold.hpp"

namespace animado::controle {

size_t Time::frames() const {
  // A billionth of a frame: far above the rounding of the quotient, far below anything meant.
  return static_cast<size_t>(std::floor((end_s - start_s) / step_s + 1e-9)) + 1;
}

std::vector<double> Time::frame_times() const {
  std::vector<double> times(frames());
  for (size_t k = 0; k < times.size(); ++k) times[k] = frame_time(k);
  return times;
}

int Scene::body_named(std::string_view name) const {
  const std::string folded = fold(name);
  for (size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].folded_name == folded) return static_cast<int>(i);
  }
  return -1;
}

std::string Scene::where(Place place) const {
  return fmt::format("{}:{}:{}", path, place.line, place.column);
}

}  // namespace animado::controle
