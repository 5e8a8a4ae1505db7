// The last steps of a larger block with one right-hand side, done as those of a small one: half of a step in
// loops is waiting for its pivot, while there is little left to eliminate.
#pragma once

#include "egesp/lanes.fetch.hpp"
#include "egesp/lanes.unrolled.hpp"

namespace animado::egesp {
namespace {

// A function of its own: in the midst of another the compiler does not unroll it.
template <int N>
[[gnu::noinline]] void take_last_steps(Block<0, 0>& whole, Fetch& fetch) {
  Block<N, 1> last(N, 1);
  const int begin = whole.n() - N;
  const auto copy = [&](const Lane* from, Lane* to) { each<N>(0, N, [&](int i) { to[i] = from[i]; }); };
  const auto in_whole = [&](int j) { return whole.column(begin + j) + begin; };
  sweep_partial(last, [&](int j) {
    copy(in_whole(j), last.column(j));
    fetch.lines<Fetch::kLoading>();
  });
  each<N>(0, last.columns(), [&](int j) {
    copy(last.column(j), in_whole(j));
    fetch.lines<Fetch::kStoring>();
  });
  each<N>(0, N, [&](int k) { whole.inverse[begin + k] = last.inverse[k]; });
  whole.weakest = smaller(last.weakest, whole.weakest);
}

}  // namespace
}  // namespace animado::egesp
