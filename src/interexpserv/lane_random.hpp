// Random numbers that are a function of where they are asked for: Philox4x32-10 ([SAL11]) with the seed for
// key and the place for counter. No state, so that any order, process or restart gives the same.
#pragma once

#include "interexpserv/lane.hpp"

namespace animado::interexpserv {
namespace {

// A 64-bit lane holds a 32-bit word.
struct Counter {
  Word word[4];
};

ANIMADO_INLINE Counter philox(Counter c, Word key0, Word key1) {
  constexpr unsigned long long low = 0xffffffff;
  for (int round = 0; round < 10; ++round) {
    const Word p0 = c.word[0] * 0xD2511F53ull, p1 = c.word[2] * 0xCD9E8D57ull;
    c = {{(p1 >> 32) ^ c.word[1] ^ key0, p1 & low, (p0 >> 32) ^ c.word[3] ^ key1, p0 & low}};
    key0 = (key0 + 0x9E3779B9ull) & low;
    key1 = (key1 + 0xBB67AE85ull) & low;
  }
  return c;
}

// Even on 0 ≤ u < 1, a multiple of 2^−52. 0 and −0 are one seed and one place; NaN where an argument is.
ANIMADO_INLINE Lane random_number(Lane seed, Lane place, Lane stream) {
  constexpr unsigned long long low = 0xffffffff;
  const Word key = (Word)(seed + 0.0), at = (Word)(place + 0.0), which = (Word)(stream + kInteger);
  const Counter c = philox({{at & low, at >> 32, which & low, Word{}}}, key & low, key >> 32);
  const Word bits = (c.word[0] << 20) ^ (c.word[1] & 0xfffff);  // 52 of them
  const Lane number = (Lane)(bits | 0x3ff0000000000000ull) - 1.0;
  return select(is_nan(seed) | is_nan(place), seed + place, number);
}

}  // namespace
}  // namespace animado::interexpserv
