#include "controle/embedded_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "controle/step_size.hpp"

namespace animado::controle {
namespace {

// A step that time hardly notices cannot be shortened: some digits of it must be left.
constexpr double kLeastOfTime = 16 * std::numeric_limits<double>::epsilon();

bool is_too_short(double step_s, double time_s) {
  return step_s <= kLeastOfTime * std::max(1.0, std::abs(time_s));
}

}  // namespace

EmbeddedSteps::EmbeddedSteps(FreeMotion& motion, double tolerance)
    : motion_(motion), next_s_(kLongestStep_s) {
  request_.absolute_tolerance = request_.relative_tolerance = {tolerance};
}

double EmbeddedSteps::proposed_s(double rest_s, double most_s) const {
  const double longest_s = std::min({next_s_, kLongestStep_s, most_s});
  // A hair of slack, so that rounding adds no step.
  return rest_s / std::max(1.0, std::ceil(rest_s / longest_s * (1 - 1e-12)));
}

double EmbeddedSteps::step(const Lanes& from, double time_s, double step_s, const Lanes& to) {
  if (!goes_on_ || !motion_.start_at_end(from, time_s)) motion_.start(from, time_s);
  goes_on_ = false;
  while (true) {
    const auto diverged = attempt(step_s, to);
    if (!request_.last_refused) return step_s;
    step_s = next_s_;
    if (!is_too_short(step_s, time_s)) continue;
    if (diverged) throw *diverged;
    throw Error(
        Code::diverged,
        fmt::format("no step at t = {:.9g} s is short enough for a tolerance of {:g}", time_s,
                    request_.absolute_tolerance.front()),
        "world: tolerance",
        "Look for a force without bound, as 1/r^2 at r = 0, or one that is not smooth; or let `world` have a "
        "larger `tolerance`.");
  }
}

// Returns how the motion diverged, if it did.
std::optional<Error> EmbeddedSteps::attempt(double step_s, const Lanes& to) try {
  motion_.go(step_s, to);
  take(motion_.estimate(request_), step_s);
  return std::nullopt;
} catch (const Error& error) {
  if (error.code() != Code::diverged) throw;
  next_s_ = kAfterDivergence * step_s;
  request_.last_refused = true;
  return error;
}

// A step that was cut short, by the end of a frame or an impact, says little about how long one may be.
void EmbeddedSteps::take(const fred::Estimate::Reply& estimate, double step_s) {
  const bool accepted = estimate.error <= 1, cut = step_s < 0.5 * next_s_;
  next_s_ = accepted && cut ? std::max(next_s_, estimate.next_step) : estimate.next_step;
  request_.last_refused = !accepted;
  if (!accepted) return;
  request_.last_error = estimate.error;
  request_.last_step = step_s;
}

}  // namespace animado::controle
