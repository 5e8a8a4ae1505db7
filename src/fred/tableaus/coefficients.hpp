// A method's numbers as constants: its steps are compiled from them (lanes.cpp), and its Tableau, whose
// notation this is, is made of them. Rows end where only zeros would follow. Plain types only, as in
// lanes.hpp.
#pragma once

namespace animado::fred {

template <int kStageCount, int kEstimateCount = 0, int kExtraCount = 0, int kDenseCount = 0>
struct Coefficients {
  static constexpr int kStages = kStageCount, kEstimates = kEstimateCount, kExtra = kExtraCount,
                       kDense = kDenseCount, kDerivatives = kStages + 1 + kExtra;
  // An array has at least one element.
  static constexpr int some(int count) { return count > 0 ? count : 1; }

  const char *name, *reference;
  int order;                        // of convergence
  double nodes[kStages];            // c
  double weights[kStages];          // b
  double matrix[kStages][kStages];  // a

  int error_order = 0;                                // of the estimate
  double errors[some(kEstimates)][kStages + 1] = {};  // e

  int dense_order = 3;
  double extra_nodes[some(kExtra)] = {};                 // c of k_{s+1}, …
  double extra_matrix[some(kExtra)][kDerivatives] = {};  // a of them
  double dense[some(kDense)][kDerivatives] = {};         // d
};

}  // namespace animado::fred
