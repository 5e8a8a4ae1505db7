#include "fred/stage.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

namespace animado::fred {
namespace {

constexpr size_t kTile =
    512;  // numbers: the sums of a tile stay in the L1 cache, so that memory is passed over once

struct Term {
  double coefficient;
  const double* derivative;
};

// sum += Σ a_j k_j for up to four terms; with kFirst the sum starts here.
template <size_t kTerms, bool kFirst>
void accumulate(const Term* terms, size_t begin, size_t count, double* __restrict sum) {
  std::array<Term, kTerms> term;
  for (size_t j = 0; j < kTerms; ++j) term[j] = {terms[j].coefficient, terms[j].derivative + begin};
  for (size_t e = 0; e < count; ++e) {
    double s = kFirst ? term[0].coefficient * term[0].derivative[e] : sum[e];
    for (size_t j = kFirst; j < kTerms; ++j) s += term[j].coefficient * term[j].derivative[e];
    sum[e] = s;
  }
}

template <bool kFirst>
void accumulate(std::span<const Term> terms, size_t begin, size_t count, double* sum) {
  switch (terms.size()) {
    case 1:
      return accumulate<1, kFirst>(terms.data(), begin, count, sum);
    case 2:
      return accumulate<2, kFirst>(terms.data(), begin, count, sum);
    case 3:
      return accumulate<3, kFirst>(terms.data(), begin, count, sum);
    default:
      return accumulate<4, kFirst>(terms.data(), begin, count, sum);
  }
}

}  // namespace

void combine(std::span<const double> state, std::span<const double> derivatives,
             std::span<const double> coefficients, double step, std::span<double> out) {
  assert(out.size() == state.size() && derivatives.size() >= coefficients.size() * state.size());
  std::vector<Term> terms;
  for (size_t j = 0; j < coefficients.size(); ++j) {
    if (coefficients[j] != 0) terms.push_back({coefficients[j], derivatives.data() + j * state.size()});
  }
  std::array<double, kTile> sum{};
  for (size_t begin = 0; begin < state.size(); begin += kTile) {
    const size_t count = std::min(kTile, state.size() - begin);
    for (size_t j = 0; j < terms.size(); j += 4) {
      const auto four = std::span<const Term>(terms).subspan(j, std::min<size_t>(4, terms.size() - j));
      j == 0 ? accumulate<true>(four, begin, count, sum.data())
             : accumulate<false>(four, begin, count, sum.data());
    }
    const double* __restrict y = state.data() + begin;
    double* __restrict end = out.data() + begin;
    for (size_t e = 0; e < count; ++e) end[e] = y[e] + step * sum[e];
  }
}

}  // namespace animado::fred
