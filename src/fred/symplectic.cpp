#include "fred/symplectic.hpp"

#include <utility>

namespace animado::fred {

Symplectic::Symplectic(SymplecticMethod method, Derivative derivative, std::span<const double> start,
                       std::vector<bool> position)
    : method_(method),
      derivative_(derivative),
      position_(std::move(position)),
      y_(start.begin(), start.end()),
      end_(y_),
      rate_(y_.size()),
      start_rate_(y_.size()),
      end_rate_(y_.size()) {}

void Symplectic::evaluate(double t, std::span<const double> y, std::vector<double>& rate) {
  derivative_(t, y, rate);
  ++evaluations_;
}

void Symplectic::move(bool positions, double h) {
  for (size_t i = 0; i < end_.size(); ++i) {
    if (position_[i] == positions) end_[i] += h * rate_[i];
  }
}

bool Symplectic::attempt(double t, double h) {
  t_ = t;
  h_ = h;
  knows_rates_ = false;
  end_ = y_;
  const bool verlet = method_ == SymplecticMethod::verlet;
  evaluate(t, end_, rate_);
  move(false, verlet ? h / 2 : h);
  evaluate(verlet ? t + h / 2 : t + h, end_, rate_);
  move(true, h);
  if (verlet) {
    evaluate(t + h, end_, rate_);
    move(false, h / 2);
  }
  return true;
}

void Symplectic::interpolate(double theta, std::span<double> out) {
  if (!knows_rates_) {
    evaluate(t_, y_, start_rate_);
    evaluate(t_ + h_, end_, end_rate_);
    knows_rates_ = true;
  }
  for (size_t i = 0; i < out.size(); ++i) {
    const double difference = end_[i] - y_[i];
    const double bend = h_ * start_rate_[i] - difference;
    const double twist = 2 * difference - h_ * (start_rate_[i] + end_rate_[i]);
    out[i] = y_[i] + theta * (difference + (1 - theta) * (bend + theta * twist));
  }
}

}  // namespace animado::fred
