#include "colisao/anderson.hpp"

#include <Eigen/QR>
#include <algorithm>

namespace animado::colisao {

Anderson::Vector Anderson::next(const Vector& x, const Vector& image) {
  const Vector residual = image - x;
  const bool first = residual_.size() == 0;
  if (first) {
    image_steps_.resize(x.size(), window_);
    residual_steps_.resize(x.size(), window_);
  }
  const bool worse = !first && residual.squaredNorm() > residual_.squaredNorm();
  if (worse) {
    known_ = 0;
  } else if (!first) {
    const int column = known_ % window_;  // the oldest gives way
    image_steps_.col(column) = image - image_;
    residual_steps_.col(column) = residual - residual_;
    ++known_;
  }
  image_ = image;
  residual_ = residual;
  if (known_ == 0) return image;
  const int columns = std::min(known_, window_);
  const Vector weights = residual_steps_.leftCols(columns).colPivHouseholderQr().solve(residual);
  return image - image_steps_.leftCols(columns) * weights;
}

}  // namespace animado::colisao
