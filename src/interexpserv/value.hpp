// What an expression yields: a boolean (0 or 1), a number, or three of them.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace animado::interexpserv {

enum class Type { boolean, scalar, vector };

constexpr std::string_view name_of(Type type) {
  constexpr std::array<std::string_view, 3> kNames = {"boolean", "scalar", "vector"};
  return kNames[static_cast<size_t>(type)];
}

constexpr size_t width_of(Type type) {
  return type == Type::vector ? 3 : 1;
}

struct Value {
  Type type = Type::scalar;
  std::array<double, 3> v{};  // width_of(type) of them count

  static Value boolean(bool b) { return {Type::boolean, {b ? 1.0 : 0.0, 0, 0}}; }
  static Value scalar(double x) { return {Type::scalar, {x, 0, 0}}; }
  static Value vector(double x, double y, double z) { return {Type::vector, {x, y, z}}; }
  bool operator==(const Value&) const = default;
};

}  // namespace animado::interexpserv
