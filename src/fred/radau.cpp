#include "fred/radau.hpp"

#include <Eigen/LU>
#include <cmath>

namespace animado::fred {
namespace {

constexpr double kRoot6 = 2.44948974278317809820;
constexpr double kNodes[3] = {(4 - kRoot6) / 10, (4 + kRoot6) / 10, 1};
constexpr double kMatrix[3][3] = {
    {(88 - 7 * kRoot6) / 360, (296 - 169 * kRoot6) / 1800, (-2 + 3 * kRoot6) / 225},
    {(296 + 169 * kRoot6) / 1800, (88 + 7 * kRoot6) / 360, (-2 - 3 * kRoot6) / 225},
    {(16 - kRoot6) / 36, (16 + kRoot6) / 36, 1. / 9}};

// The real eigenvalue of the matrix, (6 + ∛81 − ∛9) / 30, and the weights of z in the error estimate
// (IV.8.20).
constexpr double kGamma = (6 + 4.32674871092222514696 - 2.08008382305190411453) / 30;
constexpr double kEstimate[3] = {-(13 + 7 * kRoot6) / 3, (-13 + 7 * kRoot6) / 3, -1. / 3};

constexpr int kMostIterations = 10;
constexpr double kIterationShare = 0.01;  // of the tolerance: what is left of the iteration's error

using Vector = Eigen::Map<Eigen::VectorXd>;

}  // namespace

struct Radau::Matrices {
  Eigen::MatrixXd jacobian, newton;
  Eigen::PartialPivLU<Eigen::MatrixXd> stages, filter;
};

Radau::Radau(Derivative derivative, Jacobian jacobian, std::span<const double> start, Tolerance tolerance)
    : derivative_(derivative),
      jacobian_(std::move(jacobian)),
      tolerance_(std::move(tolerance)),
      size_(start.size()),
      y_(start.begin(), start.end()),
      end_(y_),
      rate_(size_),
      z_(3 * size_),
      f_(3 * size_),
      estimate_(size_),
      matrices_(std::make_unique<Matrices>()) {}

Radau::~Radau() = default;
Radau::Radau(Radau&&) noexcept = default;

void Radau::evaluate(double t, std::span<const double> y, std::span<double> rate) {
  derivative_(t, y, rate);
  ++evaluations_;
}

std::span<const double> Radau::rate(double t) {
  if (!knows_rate_) evaluate(t, y_, rate_);
  knows_rate_ = true;
  return rate_;
}

void Radau::set_rate(std::span<const double> rate) {
  rate_.assign(rate.begin(), rate.end());
  knows_rate_ = true;
}

std::span<const double> Radau::known_rate(bool at_start) const {
  if (at_start && knows_rate_) return rate_;
  return {};
}

void Radau::factor(double t, double h) {
  const auto n = static_cast<Eigen::Index>(size_);
  Eigen::MatrixXd& jacobian = matrices_->jacobian;
  if (!knows_jacobian_) {
    std::vector<double> rows(size_ * size_);
    jacobian_(t, y_, rows);
    jacobian =
        Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(rows.data(), n, n);
    knows_jacobian_ = true;
  }
  Eigen::MatrixXd& newton = matrices_->newton;
  newton.setIdentity(3 * n, 3 * n);
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = 0; j < 3; ++j) newton.block(i * n, j * n, n, n) -= h * kMatrix[i][j] * jacobian;
  }
  matrices_->stages.compute(newton);
  matrices_->filter.compute(Eigen::MatrixXd::Identity(n, n) - h * kGamma * jacobian);
}

double Radau::norm(std::span<const double> v) const {
  double sum = 0;
  for (size_t i = 0; i < v.size(); ++i) {
    const double scaled = v[i] / tolerance_.scale(i % size_, std::abs(y_[i % size_]));
    sum += scaled * scaled;
  }
  return std::sqrt(sum / static_cast<double>(v.size()));
}

double Radau::correct() {
  for (size_t s = 0; s < 3; ++s) {
    for (size_t i = 0; i < size_; ++i) end_[i] = y_[i] + z_[s * size_ + i];
    evaluate(t_ + kNodes[s] * h_, end_, std::span(f_).subspan(s * size_, size_));
  }
  Eigen::VectorXd residual(3 * size_);
  for (size_t s = 0; s < 3; ++s) {
    for (size_t i = 0; i < size_; ++i) {
      double sum = 0;
      for (size_t j = 0; j < 3; ++j) sum += kMatrix[s][j] * f_[j * size_ + i];
      residual[static_cast<Eigen::Index>(s * size_ + i)] = h_ * sum - z_[s * size_ + i];
    }
  }
  const Eigen::VectorXd correction = matrices_->stages.solve(residual);
  Vector(z_.data(), correction.size()) += correction;
  return norm({correction.data(), 3 * size_});
}

bool Radau::attempt(double t, double h) {
  rate(t);
  ++tries_;
  t_ = t;
  h_ = h;
  factor(t, h);
  std::ranges::fill(z_, 0.0);
  double last = 0;
  for (int k = 0; k < kMostIterations; ++k) {
    const double change = correct();
    if (!std::isfinite(change)) return false;
    const double contraction = k == 0 ? 0.5 : change / last;
    if (change == 0 || (contraction < 1 && contraction / (1 - contraction) * change <= kIterationShare)) {
      for (size_t i = 0; i < size_; ++i) end_[i] = y_[i] + z_[2 * size_ + i];
      return true;
    }
    if (contraction >= 1) return false;
    last = change;
  }
  return false;
}

double Radau::error(const Tolerance&) {
  const auto filtered = [&](std::span<const double> rate) {
    for (size_t i = 0; i < size_; ++i) {
      double sum = h_ * rate[i];
      for (size_t s = 0; s < 3; ++s) sum += kEstimate[s] * z_[s * size_ + i];
      estimate_[i] = kGamma * sum;
    }
    Vector estimate(estimate_.data(), static_cast<Eigen::Index>(size_));
    estimate = matrices_->filter.solve(estimate).eval();
    return norm(estimate_);
  };
  const double first = filtered(rate_);
  if (tries_ == 1 || !(first >= 1)) return first;
  // Once more through the filter: a step is not refused again for a stiff part that decays at once (IV.8.20).
  std::vector<double> moved(size_);
  for (size_t i = 0; i < size_; ++i) moved[i] = y_[i] + estimate_[i];
  evaluate(t_, moved, f_);
  return filtered(f_);
}

void Radau::interpolate(double theta, std::span<double> out) {
  // Lagrange's form on 0, c1, c2, c3; what stands at 0 is zero.
  double weights[3];
  for (int i = 0; i < 3; ++i) {
    weights[i] = theta / kNodes[i];
    for (int j = 0; j < 3; ++j) {
      if (j != i) weights[i] *= (theta - kNodes[j]) / (kNodes[i] - kNodes[j]);
    }
  }
  for (size_t i = 0; i < size_; ++i) {
    out[i] = y_[i] + (weights[0] * z_[i] + weights[1] * z_[size_ + i] + weights[2] * z_[2 * size_ + i]);
  }
}

void Radau::accept() {
  std::swap(y_, end_);
  knows_rate_ = knows_jacobian_ = false;
  tries_ = 0;
}

}  // namespace animado::fred
