// A dense matrix beside its factors.
#pragma once

#include "egesp/factored.hpp"
#include "egesp/lu.hpp"

namespace animado::egesp {

class DenseSystem final : public Factored {
 public:
  // a: (n, n), row-major; must outlive this.
  DenseSystem(std::span<const double> a, size_t n, const PivotRule& rule)
      : a_(a), lu_(std::vector<double>(a.begin(), a.end()), n, rule) {}

  const Lu& lu() const { return lu_; }
  size_t size() const override { return lu_.size(); }
  double norm_one() const override;
  double norm_rows() const override;
  void solve(std::span<double> b, size_t m) const override { lu_.solve(b, m); }
  void solve_transposed(std::span<double> b) const override { lu_.solve_transposed(b); }
  void residual(std::span<const double> b, std::span<const double> x, size_t m, size_t column,
                std::span<double> r) const override;

 private:
  std::span<const double> a_;
  Lu lu_;
};

}  // namespace animado::egesp
