#include "fred/events.hpp"

#include <algorithm>

namespace animado::fred {
namespace {

constexpr int kParts = 8;
constexpr int kMostHalvings = 200;

int sign_of(double value) {
  return (value > 0) - (value < 0);  // 0 for NaN: nothing is known
}

}  // namespace

void EventFinder::start(double t, std::span<const double> y) {
  signs_.clear();
  y_.resize(y.size());
  for (const EventRule& rule : rules_) signs_.push_back(sign_of(rule.value(t, y)));
}

int EventFinder::sign(size_t rule, Stepper& stepper, double t) {
  stepper.interpolate(t, y_);
  return sign_of(rules_[rule].value(t, y_));
}

// Halves the interval, and every other time cuts it where a straight line would cross: the first makes sure,
// the second is quick. Returns the far end, so that going on from there does not meet the same crossing
// again.
double EventFinder::locate(size_t rule, Stepper& stepper, double before, double after, int sign_before) {
  const auto value = [&](double t) {
    stepper.interpolate(t, y_);
    return rules_[rule].value(t, y_);
  };
  double low = value(before), high = value(after);
  for (int k = 0; k < kMostHalvings; ++k) {
    const double middle = before + (after - before) / 2;
    if (middle == before || middle == after) break;
    double cut = k % 2 == 0 ? before + (after - before) * (low / (low - high)) : middle;
    if (!(std::abs(cut - middle) < std::abs(middle - before))) cut = middle;
    const double at_cut = value(cut);
    if (sign_of(at_cut) == sign_before) {
      before = cut;
      low = at_cut;
    } else {
      after = cut;
      high = at_cut;
    }
  }
  return after;
}

std::vector<Occurrence> EventFinder::in_step(Stepper& stepper) {
  std::vector<Occurrence> found;
  const double from = stepper.from(), length = stepper.t() - from;
  for (size_t rule = 0; rule < rules_.size(); ++rule) {
    double before = from;
    for (int part = 1; part <= kParts; ++part) {
      const double after = part == kParts ? stepper.t() : from + length * part / kParts;
      const int now = sign(rule, stepper, after);
      int& last = signs_[rule];
      const Crossing wanted = rules_[rule].crossing;
      const bool rising = last < 0;
      if (last != 0 && now != last && (wanted == Crossing::any || (wanted == Crossing::rising) == rising)) {
        const double t = locate(rule, stepper, before, after, last);
        stepper.interpolate(t, y_);
        found.push_back({rule, t, rising, y_});
      }
      last = now;
      before = after;
    }
  }
  const double direction = length < 0 ? -1 : 1;
  std::ranges::stable_sort(found, {}, [&](const Occurrence& event) { return direction * event.t; });
  return found;
}

}  // namespace animado::fred
