// The arrays of a payload: where each lies, how it is coded, and all their bytes. Numbers that a picture
// shows need sixteen bits between their lowest and their highest.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "base/spatial.hpp"

namespace animado::report {

// A browser refuses an array of doubles that lies elsewhere.
inline constexpr size_t kAlignment_bytes = 8;

class Blocks {
 public:
  void add(const std::string& name, std::span<const double> numbers);  // as they are

  // A vector a frame, for each body: x, y and z each between that body's lowest and highest.
  void add_vectors(const std::string& name, const std::vector<std::vector<Vec3>>& bodies);

  // A unit quaternion a frame, for each body: w, x, y, z in 1/32767, each on its predecessor's side, so that
  // halfway between two of them is no detour.
  void add_rotations(const std::string& name, const std::vector<std::vector<Quat>>& bodies);

  const nlohmann::ordered_json& index() const { return index_; }  // name → type, offset, count, low, high
  const std::string& bytes() const { return bytes_; }

 private:
  template <class Number>
  nlohmann::ordered_json& put(const std::string& name, const char* type, const std::vector<Number>& numbers);

  nlohmann::ordered_json index_ = nlohmann::ordered_json::object();
  std::string bytes_;
};

}  // namespace animado::report
