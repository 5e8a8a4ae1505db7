#include "eigen_v3.hpp"

#include <Eigen/LU>

namespace animado::bench {

void eigen_v3_solve(const double* a, const double* b, double* x, size_t n) {
  const auto size = static_cast<Eigen::Index>(n);
  using Vector = Eigen::Map<const Eigen::VectorXd>;
  Eigen::Map<Eigen::VectorXd>(x, size) =
      Eigen::Map<const Eigen::MatrixXd>(a, size, size).partialPivLu().solve(Vector(b, size));
}

}  // namespace animado::bench
