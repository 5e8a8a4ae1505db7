// Anderson acceleration of a fixed-point iteration x ← g(x).
//
// From the last m steps, with f = g(x) − x and Δ the differences between them:
//
//   γ = argmin |f − ΔF γ|,   x ← g(x) − ΔG γ                (type II; Walker, Ni, SIAM J. Numer. Anal. 49
//   (2011), 1715–1735)
//
// Directions that ΔF does not tell apart are left out. The map may be only piecewise smooth: the caller sees
// whether the residual went down, and otherwise returns to where it was and forgets.
#pragma once

#include <Eigen/Core>

namespace animado::colisao {

class Anderson {
 public:
  using Vector = Eigen::VectorXd;

  explicit Anderson(int window) : window_(window) {}

  // The next x from the last one and its image; both of one size throughout.
  Vector next(const Vector& x, const Vector& image);
  void forget() { *this = Anderson(window_); }

 private:
  int window_;
  int known_ = 0;  // steps in the columns
  Vector image_, residual_;
  Eigen::MatrixXd image_steps_, residual_steps_;
};

}  // namespace animado::colisao
