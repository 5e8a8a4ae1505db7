// The equations are those of tableau.hpp. Vectors are padded to whole lanes; the padding stays zero.
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

const LaneKernels& widest_kernels() {
  return __builtin_cpu_supports("avx2") ? kLanesAvx2 : kLanesSse2;
}

// Terms whose coefficient is zero are left out: their derivatives are not read.
Sum sum_of(std::span<const double> coefficients) {
  Sum sum;
  for (size_t j = 0; j < coefficients.size(); ++j) {
    if (coefficients[j] == 0) continue;
    assert(sum.count < kMostTerms);
    sum.rows[sum.count] = static_cast<unsigned char>(j);
    sum.coefficients[sum.count++] = coefficients[j];
  }
  if (sum.count == 0) sum.count = 1;  // 0 k_0
  return sum;
}

double* zeros(size_t count) {
  const size_t bytes = (count * sizeof(double) + 63) / 64 * 64;
  void* const memory = std::aligned_alloc(64, bytes);
  if (memory == nullptr) throw std::bad_alloc();
  return static_cast<double*>(std::memset(memory, 0, bytes));
}

}  // namespace

RungeKutta::RungeKutta(const Tableau& method, Derivative derivative, std::span<const double> start)
    : method_(method),
      derivative_(derivative),
      kernels_(widest_kernels()),
      size_(start.size()),
      padded_((size_ + kLaneGroup - 1) / kLaneGroup * kLaneGroup),
      memory_(zeros((method.derivatives() + 3) * padded_), std::free) {
  double* next = memory_.get();
  const auto row = [&] { return std::exchange(next, next + padded_); };
  for (size_t s = 0; s < method.derivatives(); ++s) {
    k_.push_back(row());
    sums_.push_back(s == 0 ? Sum{} : sum_of(method.coefficients(s)));
  }
  y_ = row();
  end_ = row();
  stage_ = row();
  for (const auto& weights : method.errors) error_sums_.push_back(sum_of(weights));
  std::ranges::copy(start, y_);
}

void RungeKutta::combine(size_t s, double* out) {
  kernels_.combine[sums_[s].count](y_, k_.data(), sums_[s], h_, out, padded_);
}

void RungeKutta::evaluate(size_t s) {
  const double* const at = s == 0 ? y_ : s == method_.stages() ? end_ : stage_;
  const double t = s == 0 ? t_ : t_ + method_.node(s) * h_;
  derivative_(t, {at, size_}, {k_[s], size_});
  ++evaluations_;
}

std::span<const double> RungeKutta::rate(double t) {
  t_ = t;
  if (!knows_rate_) evaluate(0);
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
  const size_t stages = method_.stages();
  for (size_t s = 1; s < stages; ++s) {
    combine(s, stage_);
    evaluate(s);
  }
  combine(stages, end_);
  return true;
}

void RungeKutta::evaluate_end() {
  if (!knows_end_) evaluate(method_.stages());
  knows_end_ = true;
}

double RungeKutta::error(const Tolerance& tolerance) {
  assert(method_.is_adaptive());
  if (method_.error_reads_end()) evaluate_end();
  const ErrorScale scale = {tolerance.absolute.data(), tolerance.relative.data(), tolerance.stride()};
  const auto square = [&](const Sum& sum) {
    return kernels_.square_error[sum.count](y_, end_, k_.data(), sum, scale, padded_);
  };
  double squares[2] = {};
  for (size_t i = 0; i < error_sums_.size(); ++i) squares[i] = square(error_sums_[i]);
  return error_of({squares, error_sums_.size()}, h_, size_);
}

void RungeKutta::prepare_dense() {
  if (knows_dense_) return;
  knows_dense_ = true;
  evaluate_end();
  for (size_t s = method_.stages() + 1; s < method_.derivatives(); ++s) {
    combine(s, stage_);
    evaluate(s);
  }
}

void RungeKutta::interpolate(double theta, std::span<double> out) {
  prepare_dense();
  const DenseWeights weights = dense_weights(method_, theta);
  const Sum sum = sum_of(weights.rates);
  kernels_.combine[sum.count](y_, k_.data(), sum, h_, stage_, padded_);
  for (size_t i = 0; i < size_; ++i) out[i] = stage_[i] + weights.difference * (end_[i] - y_[i]);
}

void RungeKutta::accept() {
  std::swap(y_, end_);
  std::swap(k_[0], k_[method_.stages()]);
  knows_rate_ = knows_end_;
  knows_end_ = knows_dense_ = false;
}

}  // namespace animado::fred
