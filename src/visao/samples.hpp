// Where to sample: a (0,2)-sequence (Sobol 1967; Kollig & Keller, Efficient Multidimensional Sampling, 2002,
// section 3), whose aligned blocks of 2^k points are each spread evenly over the unit square.
//
// Neighbouring pixels take neighbouring blocks, in a pattern of 4 x 4 that repeats (interleaved sampling,
// Keller & Heidrich 2001): the mean over any 4 x 4 pixels is as smooth as sixteen times as many rays, and
// what remains of noise is gone when smooth_light() has taken that mean. No random numbers: a picture is the
// same each time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace animado::visao {

struct SquarePoint {
  float x, y;  // each in [0, 1)
};

constexpr SquarePoint sequence_point(uint32_t index) {
  uint32_t x = 0, y = 0, column = 1u << 31;
  for (uint32_t bits = index, top = 1u << 31; bits != 0; bits >>= 1, top >>= 1, column ^= column >> 1) {
    if ((bits & 1) != 0) {
      x ^= top;
      y ^= column;
    }
  }
  constexpr float kUnit = 0x1p-24f;  // a float's fraction has no more bits
  return {static_cast<float>(x >> 8) * kUnit, static_cast<float>(y >> 8) * kUnit};
}

// As many as sixteen pixels of sixteen rays need.
inline constexpr size_t kPoints = 256;

inline constexpr int kInterleave = 4;  // side of the pattern, pixels

// Which of the sixteen blocks a pixel takes: neighbours far apart, as in ordered dithering (Bayer 1973).
inline uint32_t block_of_pixel(int x, int y) {
  constexpr std::array<uint8_t, 16> kBayer = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
  return kBayer[static_cast<size_t>((y & 3) * kInterleave + (x & 3))];
}

}  // namespace animado::visao
