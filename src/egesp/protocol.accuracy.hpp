// What a reply says about its solutions when it was asked to.
#pragma once

#include "rpc/message.hpp"

namespace animado::egesp {

struct Accuracy {
  std::vector<double> backward_errors, reciprocal_conditions;
  std::string warning;
  template <class Self, class F>
  static void fields(Self& s, F&& field) {
    field("backward_errors", s.backward_errors,
          "of each system (residual, refine), the largest of its right-hand sides: the relative change of A "
          "and b that would "
          "make x exact, ‖b − A x‖ / (‖A‖ ‖x‖ + ‖b‖) in the maximum norm");
    field("reciprocal_conditions", s.reciprocal_conditions,
          "of each system (condition): an estimate of 1 / (‖A‖₁ ‖A⁻¹‖₁); 1e-10 says that about 10 digits of "
          "x are lost");
    field("warning", s.warning, "names the worst system when it is ill-conditioned; else empty");
  }
};

}  // namespace animado::egesp
