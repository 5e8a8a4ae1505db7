// Units of measurement and what they measure. A number with a unit knows its dimension; one without is plain,
// and fits everything.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace animado::interexpserv {

// Exponents of metre, kilogram and second in twelfths (a cube root of a square root still has one). Angles
// are numbers of dimension 1.
struct Dimension {
  bool known = false;
  int16_t m = 0, kg = 0, s = 0;
  bool operator==(const Dimension&) const = default;

  bool is_one() const { return m == 0 && kg == 0 && s == 0; }
};

constexpr Dimension kPlain = {};
constexpr Dimension kOne = {true, 0, 0, 0};

// Plain when one of them is.
Dimension operator*(const Dimension& a, const Dimension& b);
Dimension operator/(const Dimension& a, const Dimension& b);
// Plain when a is, or when the result has no such exponents.
Dimension to_power(const Dimension& a, double exponent);
// "m", "kg m/s^2", "1"; and in words, "a length (m)", where it has a name
std::string text_of(const Dimension& dimension);

// x written with the unit is x · factor / divisor in SI: both exact, so that 7 cm is 0.07 to the last bit.
struct Unit {
  std::string_view name;
  double factor, divisor;
  Dimension dimension;
};

// `written` as it stands in the text. Case counts only where it must (mN, MN). Null when it is none.
const Unit* find_unit(std::string_view written);
// For suggestions.
std::vector<std::string> known_units();

}  // namespace animado::interexpserv
