#include "report/blocks.hpp"

#include <bit>
#include <cmath>

namespace animado::report {
namespace {

static_assert(std::endian::native == std::endian::little, "the page reads little-endian arrays");

constexpr double kUnsignedSteps = 65535, kSignedSteps = 32767;

Vec3 lowest(const std::vector<Vec3>& vectors) {
  Vec3 low = vectors.front();
  for (const Vec3& v : vectors) low = low.cwiseMin(v);
  return low;
}

Vec3 highest(const std::vector<Vec3>& vectors) {
  Vec3 high = vectors.front();
  for (const Vec3& v : vectors) high = high.cwiseMax(v);
  return high;
}

uint16_t quantised(double value, double low, double high) {
  const double extent = high - low;
  return extent > 0 ? static_cast<uint16_t>(std::lround((value - low) / extent * kUnsignedSteps))
                    : uint16_t{0};
}

}  // namespace

template <class Number>
nlohmann::ordered_json& Blocks::put(const std::string& name, const char* type,
                                    const std::vector<Number>& numbers) {
  auto& entry = index_[name] = {{"type", type}, {"offset", bytes_.size()}, {"count", numbers.size()}};
  bytes_.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
  bytes_.resize((bytes_.size() + kAlignment_bytes - 1) / kAlignment_bytes * kAlignment_bytes);
  return entry;
}

void Blocks::add(const std::string& name, std::span<const double> numbers) {
  put(name, "f64", std::vector(numbers.begin(), numbers.end()));
}

void Blocks::add_vectors(const std::string& name, const std::vector<std::vector<Vec3>>& bodies) {
  std::vector<uint16_t> numbers;
  std::vector<double> lows, highs;
  for (const std::vector<Vec3>& frames : bodies) {
    if (frames.empty()) continue;
    const Vec3 low = lowest(frames), high = highest(frames);
    lows.insert(lows.end(), low.begin(), low.end());
    highs.insert(highs.end(), high.begin(), high.end());
    for (const Vec3& v : frames) {
      for (int k = 0; k < 3; ++k) numbers.push_back(quantised(v[k], low[k], high[k]));
    }
  }
  auto& entry = put(name, "u16", numbers);
  entry["low"] = lows;
  entry["high"] = highs;
}

void Blocks::add_rotations(const std::string& name, const std::vector<std::vector<Quat>>& bodies) {
  std::vector<int16_t> numbers;
  for (const std::vector<Quat>& frames : bodies) {
    Quat last = Quat::Identity();
    for (Quat q : frames) {
      q.normalize();
      if (q.dot(last) < 0) q.coeffs() = -q.coeffs();
      for (const double c : {q.w(), q.x(), q.y(), q.z()})
        numbers.push_back(static_cast<int16_t>(std::lround(c * kSignedSteps)));
      last = q;
    }
  }
  put(name, "i16", numbers);
}

}  // namespace animado::report
