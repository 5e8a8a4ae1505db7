// Numbers that one process writes and others read while they change, without a lock (a sequence lock).
// Element 0 counts: odd while the writer is at work, even when the rest is one consistent picture. A reader
// that saw the count move reads again.
//
// A counter kept as a double is exact up to 2^53: 285 years at a million pictures a second.
#pragma once

#include <atomic>
#include <cmath>
#include <cstddef>
#include <span>

namespace animado::interexpserv {

inline double load_shared(const double& number, std::memory_order order) {
  return std::atomic_ref<double>(const_cast<double&>(number)).load(order);
}

inline void store_shared(double& number, double value, std::memory_order order) {
  std::atomic_ref<double>(number).store(value, order);
}

// The writer's side; one writer an array. picture[i] goes to array[1 + i].
inline void publish(std::span<double> array, std::span<const double> picture) {
  double before = load_shared(array[0], std::memory_order_relaxed);
  if (std::fmod(before, 2) != 0) before += 1;  // a writer that died at work
  store_shared(array[0], before + 1, std::memory_order_relaxed);
  // Who reads one of these sees the odd count too.
  for (size_t i = 0; i < picture.size(); ++i) {
    store_shared(array[1 + i], picture[i], std::memory_order_release);
  }
  store_shared(array[0], before + 2, std::memory_order_release);
}

// One try of the reader's side: copies the whole array. False when the writer was at work: try again.
inline bool read_published(std::span<const double> array, std::span<double> copy) {
  copy[0] = load_shared(array[0], std::memory_order_acquire);
  if (std::fmod(copy[0], 2) != 0) return false;
  for (size_t i = 1; i < array.size(); ++i) copy[i] = load_shared(array[i], std::memory_order_acquire);
  return load_shared(array[0], std::memory_order_relaxed) == copy[0];
}

}  // namespace animado::interexpserv
