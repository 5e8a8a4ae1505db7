// sin, cos and tan of large arguments, by the reduction of [PH83]: x = m 2^e, and of the product of m with
// 2/π only those bits are formed that are neither multiples of 4 (whole turns) nor below what is seen: 53
// bits of m times 256 bits of 2/π.
#include <array>
#include <bit>
#include <cmath>

#include "interexpserv/lane_trig.hpp"

namespace animado::interexpserv {
namespace {

__extension__ using Wide = unsigned __int128;

// 2/π = 0.a2f9836e…, 64 bits a word: 1280 bits are 2^1024 and what lies 200 bits below it.
constexpr std::array<uint64_t, 20> kTwoOverPi = {
    0xa2f9836e4e441529, 0xfc2757d1f534ddc0, 0xdb6295993c439041, 0xfe5163abdebbc561, 0xb7246e3a424dd2e0,
    0x06492eea09d1921c, 0xfe1deb1cb129a73e, 0xe88235f52ebb4484, 0xe99c7026b45f7e41, 0x3991d639835339f4,
    0x9c845f8bbdf9283b, 0x1ff897ffde05980f, 0xef2f118b5a0a6d1f, 0x6d367ecf27cb09b7, 0x4f463f669e5fea2d,
    0x7527bac7ebe5f17b, 0x3d0739f78a5292ea, 0x6bfb5fb11f8d5d08, 0x56033046fc7b6bab, 0xf0cfbc209af4361d};

// 64 bits of 2/π from bit `first` after the point on; before the point there are zeros.
uint64_t bits_from(int first) {
  if (first <= -64) return 0;
  if (first < 0) return kTwoOverPi[0] >> -first;
  const auto word = static_cast<size_t>(first / 64);
  const int shift = first % 64;
  return shift == 0 ? kTwoOverPi[word] : kTwoOverPi[word] << shift | kTwoOverPi[word + 1] >> (64 - shift);
}

// |x| = n π/2 + r for a finite |x| ≥ 2^16.
struct LargeReduced {
  double r, rest;  // the angle is r − rest
  uint64_t quadrant;
};
LargeReduced reduce(double x) {
  const auto bits = std::bit_cast<uint64_t>(x);
  const int exponent = static_cast<int>(bits >> 52 & 0x7ff) - 1075;  // |x| = m 2^exponent
  const uint64_t m = (bits & 0xfffffffffffff) | 0x10000000000000;
  // m · 2^exponent · 2/π modulo 4, from the bits of weight 2 on, as 2 + 62 bits and two words behind them.
  const int first = exponent - 2;
  std::array<uint64_t, 4> w;
  for (int k = 0; k < 4; ++k) w[static_cast<size_t>(k)] = bits_from(first + 64 * k);
  std::array<uint64_t, 4> p;
  Wide carry = 0;
  for (size_t k = 4; k-- > 0;) {
    carry += static_cast<Wide>(w[k]) * m;
    p[k] = static_cast<uint64_t>(carry);
    carry >>= 64;
  }
  const uint64_t quadrant = p[0] >> 62;
  // The fraction as 128 bits, shifted so that it is signed: −½ … ½.
  Wide fraction = (static_cast<Wide>(p[0]) << 66) | (static_cast<Wide>(p[1]) << 2) | p[2] >> 62;
  const bool upper = fraction >> 127 != 0;
  if (upper) fraction = -fraction;
  // Its first 53 bits, and the 53 after them.
  auto top = static_cast<uint64_t>(fraction >> 64), next = static_cast<uint64_t>(fraction);
  int shift = 0;
  while (top >> 63 == 0) {
    top = top << 1 | next >> 63;
    next <<= 1;
    ++shift;
  }
  const double high = std::ldexp(static_cast<double>(top >> 11), -53 - shift);
  const double low = std::ldexp(static_cast<double>((top & 0x7ff) << 42 | next >> 22), -106 - shift);
  constexpr double half_pi = 0x1.921fb54442d18p+0, half_pi_low = 0x1.1a62633145c07p-54;
  const Pair whole = product(Lane{high}, Lane{half_pi});
  const double tail = whole.low[0] + (high * half_pi_low + low * half_pi);
  const double r = whole.high[0] + tail, rest = (r - whole.high[0]) - tail;
  return {upper ? -r : r, upper ? -rest : rest, quadrant + (upper ? 1 : 0)};
}

// f of x as lanes.
template <class F>
double of_large(double x, bool odd, F f) {
  if (!(std::fabs(x) < kInfinity)) return kNaN;
  const LargeReduced large = reduce(x);
  const double value = f(Reduced{Lane{large.r}, Lane{large.rest}, Word{large.quadrant}})[0];
  return odd && x < 0 ? -value : value;
}

}  // namespace

double slow_sine(double x) {
  return of_large(x, true, [](const Reduced& r) { return turned(r, 0); });
}
double slow_cosine(double x) {
  return of_large(x, false, [](const Reduced& r) { return turned(r, 1); });
}
double slow_tangent(double x) {
  return of_large(x, true, [](const Reduced& r) { return quotient(r); });
}

}  // namespace animado::interexpserv
