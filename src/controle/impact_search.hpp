// When two bodies first meet within a step. colisao sweeps the cubic between two states. Where the method has
// a dense output of higher order, the step is cut into as many parts as keep that cubic within the tolerance
// of the dense output at their ends, and the time is then set right on the dense output itself.
#pragma once

#include "colisao/client.hpp"
#include "controle/free_motion.hpp"

namespace animado::controle {

class ImpactSearch {
 public:
  // tolerance: of the dense output, relative to 1 + |y|.
  ImpactSearch(FreeMotion& motion, colisao::Client& colisao, Meter& meter, size_t bodies, double tolerance);

  // The first meeting between two states, step_s apart.
  colisao::Sweep::Reply on_cubic(const Lanes& from, const Lanes& to, double step_s);
  // The same in the motion's last step, which has_dense_output().
  colisao::Sweep::Reply on_dense(const Lanes& from, const Lanes& to, double step_s);

  // From a time near a meeting to that at which its gap is closed, by the gap's own speed. place: puts
  // everything where it is at a time within the step, and returns the state; it was last called for the time
  // that is returned.
  template <class Place>
  double close_gap(const colisao::Sweep::Reply& meeting, double step_s, Place place) {
    double at_s = meeting.time_s;
    for (int refinement = 0;; ++refinement) {
      const Lanes& state = place(at_s);
      if (refinement == kMostRefinements) return at_s;
      const double corrected_s = at_s + correction_s(state, meeting.a, meeting.b);
      if (corrected_s <= 0 || corrected_s > step_s || corrected_s == at_s) return at_s;
      at_s = corrected_s;
    }
  }

 private:
  static constexpr int kMostRefinements = 3;

  double correction_s(const Lanes& state, int64_t a, int64_t b);
  int parts(const Lanes& from, const Lanes& to, double step_s);

  FreeMotion& motion_;
  colisao::Client& colisao_;
  Meter& meter_;
  size_t bodies_;
  double tolerance_;
  Lanes inside_[2];  // states inside a step, by its dense output; in turn
};

}  // namespace animado::controle
