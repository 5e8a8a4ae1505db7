#include "egesp/least_squares.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "egesp/pivot_rule.hpp"

namespace animado::egesp {
namespace {

// Eight sums side by side: one alone would wait for itself.
double dot(const double* u, const double* v, size_t count) {
  double sums[8] = {};
  size_t i = 0;
  for (; i + 8 <= count; i += 8) {
    for (size_t s = 0; s < 8; ++s) sums[s] += u[i + s] * v[i + s];
  }
  for (size_t s = 0; i < count; ++i, ++s) sums[s] += u[i] * v[i];
  return ((sums[0] + sums[1]) + (sums[2] + sums[3])) + ((sums[4] + sums[5]) + (sums[6] + sums[7]));
}

// 1 − τ v vᵀ with v₀ = 1, which turns a vector into (β, 0, …). v₁ … take the vector's place, β that of its
// head.
double reflector(double& head, double* tail, size_t count) {
  const double tail_norm = std::sqrt(dot(tail, tail, count));
  if (tail_norm == 0) return 0;
  const double beta = head > 0 ? -std::hypot(head, tail_norm) : std::hypot(head, tail_norm);
  const double tau = (beta - head) / beta, scale = 1 / (head - beta);
  for (size_t i = 0; i < count; ++i) tail[i] *= scale;
  head = beta;
  return tau;
}

void reflect(double tau, const double* v, double& head, double* tail, size_t count) {
  const double factor = tau * (head + dot(v, tail, count));
  head -= factor;
  for (size_t i = 0; i < count; ++i) tail[i] -= factor * v[i];
}

class Decomposition {
 public:
  explicit Decomposition(const LeastSquaresProblem& p)
      : p_(p),
        a_(p.rows * p.columns),
        b_(p.rows * p.m),
        norms_(p.columns),
        full_norms_(p.columns),
        order_(p.columns) {
    // A power of two brings the elements near 1, so that no square leaves the doubles.
    double largest = 0;
    for (double v : p.a) largest = std::max(largest, std::abs(v));
    if (largest > 0) std::frexp(largest, &exponent_);
    for (size_t i = 0; i < p.rows; ++i) {
      for (size_t j = 0; j < p.columns; ++j) column(j)[i] = std::ldexp(p.a[i * p.columns + j], -exponent_);
      for (size_t c = 0; c < p.m; ++c) right(c)[i] = p.b[i * p.m + c];
    }
    std::iota(order_.begin(), order_.end(), size_t{0});
    for (size_t j = 0; j < p.columns; ++j)
      norms_[j] = full_norms_[j] = std::sqrt(dot(column(j), column(j), p.rows));
    triangularize();
    if (p.minimum_norm) clear_beyond_rank();
  }

  size_t rank() const { return rank_; }

  // Column c of X.
  void solve(size_t c, std::span<double> x) {
    std::vector<double> w(p_.columns);
    std::copy_n(right(c), rank_, w.begin());
    for (size_t k = rank_; k-- > 0;) {
      w[k] /= column(k)[k];
      for (size_t i = 0; i < k; ++i) w[i] -= column(k)[i] * w[k];
    }
    for (size_t k = 0; k < beyond_.size(); ++k)
      reflect(beyond_[k].tau, beyond_[k].v.data(), w[k], w.data() + rank_, p_.columns - rank_);
    for (size_t k = 0; k < p_.columns; ++k) x[order_[k] * p_.m + c] = std::ldexp(w[k], -exponent_);
  }

 private:
  double* column(size_t j) { return a_.data() + j * p_.rows; }
  double* right(size_t c) { return b_.data() + c * p_.rows; }

  void triangularize() {
    const double tolerance = PivotRule{.threshold = p_.threshold}.tolerance(std::max(p_.rows, p_.columns));
    double floor = 0;
    for (size_t k = 0; k < std::min(p_.rows, p_.columns); ++k) {
      exchange(
          k, static_cast<size_t>(std::max_element(norms_.begin() + static_cast<ptrdiff_t>(k), norms_.end()) -
                                 norms_.begin()));
      double* v = column(k) + k + 1;
      const size_t count = p_.rows - k - 1;
      const double tau = reflector(column(k)[k], v, count);
      if (k == 0) floor = std::abs(column(0)[0]) * tolerance;
      if (!(std::abs(column(k)[k]) > floor)) return;
      for (size_t j = k + 1; j < p_.columns; ++j) {
        reflect(tau, v, column(j)[k], column(j) + k + 1, count);
        shorten(j, k);
      }
      for (size_t c = 0; c < p_.m; ++c) reflect(tau, v, right(c)[k], right(c) + k + 1, count);
      ++rank_;
    }
  }

  void exchange(size_t j, size_t k) {
    if (j == k) return;
    std::swap_ranges(column(j), column(j) + p_.rows, column(k));
    std::swap(norms_[j], norms_[k]);
    std::swap(full_norms_[j], full_norms_[k]);
    std::swap(order_[j], order_[k]);
  }

  // The norm of column j below row k; anew where the difference has lost half of its digits.
  void shorten(size_t j, size_t k) {
    if (norms_[j] == 0) return;
    const double part = std::abs(column(j)[k]) / norms_[j], left = std::max(0.0, (1 - part) * (1 + part));
    const double shrunk = norms_[j] / full_norms_[j];
    if (left * shrunk * shrunk > 0x1p-26) {
      norms_[j] *= std::sqrt(left);
    } else {
      const size_t count = p_.rows - k - 1;
      norms_[j] = full_norms_[j] = std::sqrt(dot(column(j) + k + 1, column(j) + k + 1, count));
    }
  }

  // R₁₂ ← 0 by reflections from the right, from the last row up.
  void clear_beyond_rank() {
    if (rank_ == p_.columns) return;
    beyond_.resize(rank_);
    std::vector<double> row(p_.columns - rank_);
    const auto read = [&](size_t i) {
      for (size_t j = 0; j < row.size(); ++j) row[j] = column(rank_ + j)[i];
    };
    for (size_t k = rank_; k-- > 0;) {
      read(k);
      beyond_[k].tau = reflector(column(k)[k], row.data(), row.size());
      beyond_[k].v = row;
      for (size_t i = 0; i < k; ++i) {
        read(i);
        reflect(beyond_[k].tau, beyond_[k].v.data(), column(k)[i], row.data(), row.size());
        for (size_t j = 0; j < row.size(); ++j) column(rank_ + j)[i] = row[j];
      }
    }
  }

  struct Reflector {
    double tau = 0;
    std::vector<double> v;
  };

  const LeastSquaresProblem& p_;
  int exponent_ = 0;                        // A is 2^exponent times what is decomposed
  std::vector<double> a_, b_;               // column by column; Q is applied to both
  std::vector<double> norms_, full_norms_;  // of what is left of each column; when last computed anew
  std::vector<size_t> order_;               // column k of the form is this one of A
  std::vector<Reflector> beyond_;           // Z
  size_t rank_ = 0;
};

double residual_norm(const LeastSquaresProblem& p, std::span<const double> x, size_t c) {
  long double squares = 0;
  for (size_t i = 0; i < p.rows; ++i) {
    long double r = p.b[i * p.m + c];
    for (size_t j = 0; j < p.columns; ++j)
      r -= static_cast<long double>(p.a[i * p.columns + j]) * x[j * p.m + c];
    squares += r * r;
  }
  return static_cast<double>(std::sqrt(squares));
}

}  // namespace

LeastSquaresSolution least_squares(const LeastSquaresProblem& problem) {
  assert(problem.a.size() == problem.rows * problem.columns && problem.b.size() == problem.rows * problem.m);
  Decomposition decomposition(problem);
  LeastSquaresSolution solution{decomposition.rank(), std::vector<double>(problem.columns * problem.m), {}};
  for (size_t c = 0; c < problem.m; ++c) {
    decomposition.solve(c, solution.x);
    solution.residual_norms.push_back(residual_norm(problem, solution.x, c));
  }
  return solution;
}

}  // namespace animado::egesp
