// A vector in the JSON files of a run.
#pragma once

#include <nlohmann/json.hpp>

#include "base/spatial.hpp"

namespace animado::controle {

inline nlohmann::ordered_json json_vector(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

}  // namespace animado::controle
