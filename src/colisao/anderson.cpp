#include "colisao/anderson.hpp"

#include <Eigen/QR>
#include <algorithm>

namespace animado::colisao {

namespace {

// Steps of the residual that differ by less than this share of the largest are the same up to rounding.
constexpr double kDistinct = 1e-8;

}  // namespace

Anderson::Vector Anderson::next(const Vector& x, const Vector& image) {
  const Vector residual = image - x;
  if (residual_.size() == 0) {
    image_steps_.resize(x.size(), window_);
    residual_steps_.resize(x.size(), window_);
  } else {
    const int column = known_++ % window_;  // the oldest gives way
    image_steps_.col(column) = image - image_;
    residual_steps_.col(column) = residual - residual_;
  }
  image_ = image;
  residual_ = residual;
  if (known_ == 0) return image;
  const int columns = std::min(known_, window_);
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factor;
  factor.setThreshold(kDistinct);
  factor.compute(residual_steps_.leftCols(columns));
  return image - image_steps_.leftCols(columns) * factor.solve(residual);
}

}  // namespace animado::colisao
