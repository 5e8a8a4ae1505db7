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
      sums_(start.size()),
      size_(start.size()),
      memory_(nullptr, std::free),
      estimates_(error_sums(method)) {
  const size_t stride = (size_ + kCacheLine - 1) / kCacheLine * kCacheLine;
  memory_.reset(zeros((method.derivatives() + 3) * stride));
  double* next = memory_.get();
  const auto row = [&] { return std::exchange(next, next + stride); };
  for (size_t s = 0; s < method.derivatives(); ++s) {
    k_.push_back(row());
    places_.push_back(s == 0 ? Sum{} : sum_of(method.coefficients(s)));
  }
  y_ = row();
  end_ = row();
  stage_ = row();
  std::ranges::copy(start, y_);
}

void RungeKutta::combine(size_t s, double* out) {
  sums_.combine(y_, k_.data(), places_[s], h_, out);
}

void RungeKutta::evaluate(size_t s, double t, const double* at) {
  derivative_(t, {at, size_}, {k_[s], size_});
  ++evaluations_;
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
  return {k_[at_start ? 0 : method_.stages()], size_};
}

bool RungeKutta::attempt(double t, double h) {
  rate(t);
  h_ = h;
  knows_end_ = knows_dense_ = false;
  const std::span<const double> nodes = method_.nodes;
  const size_t stages = nodes.size();
  for (size_t s = 1; s < stages; ++s) {
    combine(s, stage_);
    evaluate(s, t + nodes[s] * h, stage_);
  }
  end_is_finite_ = sums_.combine_end(y_, k_.data(), places_[stages], h_, end_);
  return true;
}

void RungeKutta::evaluate_end() {
  if (!knows_end_) evaluate(method_.stages(), t_ + h_, end_);
  knows_end_ = true;
}

double RungeKutta::error(const Tolerance& tolerance) {
  assert(method_.is_adaptive());
  if (method_.error_reads_end()) evaluate_end();
  const auto squares = sums_.square_errors(y_, end_, k_.data(), estimates_, tolerance);
  return error_of(std::span(squares).first(estimates_.size()), h_, size_);
}

void RungeKutta::prepare_dense() {
  if (knows_dense_) return;
  knows_dense_ = true;
  evaluate_end();
  for (size_t s = method_.stages() + 1; s < method_.derivatives(); ++s) {
    combine(s, stage_);
    evaluate(s, t_ + method_.node(s) * h_, stage_);
  }
}

void RungeKutta::interpolate(double theta, std::span<double> out) {
  prepare_dense();
  const DenseWeights weights = dense_weights(method_, theta);
  const Sum sum = sum_of(weights.rates);
  sums_.combine(y_, k_.data(), sum, h_, stage_);
  for (size_t i = 0; i < size_; ++i) out[i] = stage_[i] + weights.difference * (end_[i] - y_[i]);
}

void RungeKutta::accept() {
  std::swap(y_, end_);
  std::swap(k_[0], k_[method_.stages()]);
  knows_rate_ = knows_end_;
  knows_end_ = knows_dense_ = false;
}

}  // namespace animado::fred
