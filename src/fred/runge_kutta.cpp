// The equations are those of tableau.hpp. Vectors begin at addresses of 64 bytes.
#include "fred/runge_kutta.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "fred/embedded.hpp"

namespace animado::fred {
namespace {

constexpr size_t kCacheLine = 64 / sizeof(double);

double* zeros(size_t count) {
  const size_t bytes = count * sizeof(double);
  void* const memory = std::aligned_alloc(64, bytes);
  if (memory == nullptr) throw std::bad_alloc();
  return static_cast<double*>(std::memset(memory, 0, bytes));
}

}  // namespace

RungeKutta::RungeKutta(const Tableau& method, Derivative derivative, std::span<const double> start)
    : method_(method),
      derivative_(derivative),
      places_(method.places.data()),
      size_(start.size()),
      stages_(method.stages()),
      errors_(size_),
      lanes_(size_),
      memory_(nullptr, std::free) {
  const size_t stride = (size_ + kCacheLine - 1) / kCacheLine * kCacheLine,
               derivatives = method.derivatives();
  assert(derivatives <= k_.size());
  memory_.reset(zeros((derivatives + 3) * stride));
  double* next = memory_.get();
  const auto row = [&] { return std::exchange(next, next + stride); };
  for (size_t s = 0; s < derivatives; ++s) k_[s] = row();
  y_ = row();
  end_ = row();
  stage_ = row();
  std::ranges::copy(start, y_);
}

void RungeKutta::evaluate(size_t s, double t, const double* at) {
  derivative_(t, {at, size_}, {k_[s], size_});
  ++evaluations_;
}

void RungeKutta::combine(const Sum& sum) {
  lanes_.kernels.combine[sum.count](y_, k_.data(), sum, h_, stage_, 0, lanes_.end);
}

void RungeKutta::evaluate_stage(size_t s) {
  const auto& [sum, node] = places_[s];
  combine(sum);
  evaluate(s, t_ + node * h_, stage_);
}

std::span<const double> RungeKutta::rate(double t) {
  t_ = t;
  if (!knows_rate_) evaluate(0, t, y_);
  knows_rate_ = true;
  return {k_[0], size_};
}

void RungeKutta::set_rate(std::span<const double> rate) {
  std::ranges::copy(rate, k_[0]);
  knows_rate_ = true;
}

std::span<const double> RungeKutta::known_rate(bool at_start) const {
  if (at_start ? !knows_rate_ : !knows_end_) return {};
  return {k_[at_start ? 0 : stages_], size_};
}

void RungeKutta::set_y(std::span<const double> y) {
  std::ranges::copy(y, y_);
  knows_rate_ = knows_end_ = knows_dense_ = false;
}

void RungeKutta::attempt(double origin, double h, int64_t first, int64_t count) {
  rate(origin + static_cast<double>(first) * h);
  h_ = h;
  t_ = origin + static_cast<double>(first + count - 1) * h;
  knows_end_ = knows_dense_ = false;
  lanes_.kernels.steps[method_.number](
      {derivative_.function(), origin, h, first, count, y_, end_, k_.data(), stage_, size_, lanes_.end});
  evaluations_ += count * static_cast<int64_t>(stages_) - 1;
  if (count % 2 == 0) std::swap(y_, end_);
}

void RungeKutta::evaluate_end() {
  if (!knows_end_) evaluate(stages_, t_ + h_, end_);
  knows_end_ = true;
}

double RungeKutta::error(const Tolerance& tolerance) {
  assert(method_.is_adaptive());
  if (method_.error_reads_end()) evaluate_end();
  const auto squares = errors_.square_errors(y_, end_, k_.data(), method_.estimates, tolerance);
  return error_of(std::span(squares).first(method_.estimates.size()), h_, size_);
}

void RungeKutta::prepare_dense() {
  if (knows_dense_) return;
  knows_dense_ = true;
  evaluate_end();
  for (size_t s = stages_ + 1; s < method_.derivatives(); ++s) evaluate_stage(s);
}

void RungeKutta::interpolate(double theta, std::span<double> out) {
  prepare_dense();
  const DenseWeights weights = dense_weights(method_, theta);
  combine(sum_of(weights.rates));
  for (size_t i = 0; i < size_; ++i) out[i] = stage_[i] + weights.difference * (end_[i] - y_[i]);
}

}  // namespace animado::fred
