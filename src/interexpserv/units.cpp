#include "interexpserv/units.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "base/fold.hpp"

namespace animado::interexpserv {
namespace {

constexpr int kWhole = 12;

constexpr Dimension dimension(int m, int kg, int s) {
  return {true, static_cast<int16_t>(m * kWhole), static_cast<int16_t>(kg * kWhole),
          static_cast<int16_t>(s * kWhole)};
}

constexpr double kPi = std::numbers::pi;
constexpr Dimension kLength = dimension(1, 0, 0), kMass = dimension(0, 1, 0), kTime = dimension(0, 0, 1);
constexpr Dimension kRate = dimension(0, 0, -1), kForce = dimension(1, 1, -2), kEnergy = dimension(2, 1, -2);
constexpr Dimension kPower = dimension(2, 1, -3), kPressure = dimension(-1, 1, -2);

constexpr auto kUnits = std::to_array<Unit>({
    {"m", 1, 1, kLength},         {"km", 1e3, 1, kLength},    {"dm", 1, 10, kLength},
    {"cm", 1, 100, kLength},      {"mm", 1, 1e3, kLength},    {"um", 1, 1e6, kLength},
    {"nm", 1, 1e9, kLength},      {"in", 0.0254, 1, kLength}, {"ft", 0.3048, 1, kLength},
    {"kg", 1, 1, kMass},          {"g", 1, 1e3, kMass},       {"mg", 1, 1e6, kMass},
    {"lb", 0.45359237, 1, kMass}, {"s", 1, 1, kTime},         {"ms", 1, 1e3, kTime},
    {"us", 1, 1e6, kTime},        {"ns", 1, 1e9, kTime},      {"min", 60, 1, kTime},
    {"h", 3600, 1, kTime},        {"rad", 1, 1, kOne},        {"deg", kPi / 180, 1, kOne},
    {"turn", 2 * kPi, 1, kOne},   {"Hz", 1, 1, kRate},        {"kHz", 1e3, 1, kRate},
    {"MHz", 1e6, 1, kRate},       {"rpm", kPi, 30, kRate},    {"N", 1, 1, kForce},
    {"mN", 1, 1e3, kForce},       {"kN", 1e3, 1, kForce},     {"MN", 1e6, 1, kForce},
    {"Nm", 1, 1, kEnergy},        {"kNm", 1e3, 1, kEnergy},   {"J", 1, 1, kEnergy},
    {"mJ", 1, 1e3, kEnergy},      {"kJ", 1e3, 1, kEnergy},    {"MJ", 1e6, 1, kEnergy},
    {"W", 1, 1, kPower},          {"mW", 1, 1e3, kPower},     {"kW", 1e3, 1, kPower},
    {"MW", 1e6, 1, kPower},       {"Pa", 1, 1, kPressure},    {"kPa", 1e3, 1, kPressure},
    {"MPa", 1e6, 1, kPressure},   {"GPa", 1e9, 1, kPressure}, {"bar", 1e5, 1, kPressure},
});

struct Named {
  Dimension dimension;
  std::string_view name;
};
constexpr auto kNamed = std::to_array<Named>({{kOne, "a number or an angle"},
                                              {kLength, "a length"},
                                              {kMass, "a mass"},
                                              {kTime, "a time"},
                                              {kRate, "a rate"},
                                              {kForce, "a force"},
                                              {kEnergy, "an energy or a torque"},
                                              {kPower, "a power"},
                                              {kPressure, "a pressure"},
                                              {dimension(2, 0, 0), "an area"},
                                              {dimension(3, 0, 0), "a volume"},
                                              {dimension(1, 0, -1), "a velocity"},
                                              {dimension(1, 0, -2), "an acceleration"},
                                              {dimension(0, 1, -2), "a stiffness"},
                                              {dimension(-3, 1, 0), "a density"}});

void append_power(std::string& text, std::string_view unit, int twelfths) {
  if (twelfths == 0) return;
  if (!text.empty()) text += ' ';
  text += unit;
  if (twelfths != kWhole) text += fmt::format("^{:g}", twelfths / static_cast<double>(kWhole));
}

int16_t exponent_sum(int a, int b) {
  return static_cast<int16_t>(std::min(std::max(a + b, -32000), 32000));
}

}  // namespace

Dimension operator*(const Dimension& a, const Dimension& b) {
  if (!a.known || !b.known) return kPlain;
  return {true, exponent_sum(a.m, b.m), exponent_sum(a.kg, b.kg), exponent_sum(a.s, b.s)};
}

Dimension operator/(const Dimension& a, const Dimension& b) {
  if (!a.known || !b.known) return kPlain;
  return {true, exponent_sum(a.m, -b.m), exponent_sum(a.kg, -b.kg), exponent_sum(a.s, -b.s)};
}

Dimension to_power(const Dimension& a, double exponent) {
  if (!a.known || a.is_one()) return a;
  if (!(std::fabs(exponent) <= 12)) return kPlain;
  const double m = a.m * exponent, kg = a.kg * exponent, s = a.s * exponent;
  if (std::fabs(m) > 32000 || std::fabs(kg) > 32000 || std::fabs(s) > 32000) return kPlain;
  return {true, static_cast<int16_t>(std::lround(m)), static_cast<int16_t>(std::lround(kg)),
          static_cast<int16_t>(std::lround(s))};
}

std::string text_of(const Dimension& d) {
  std::string units;
  append_power(units, "kg", d.kg);
  append_power(units, "m", d.m);
  append_power(units, "s", d.s);
  for (const auto& [dimension, name] : kNamed) {
    if (dimension == d) return units.empty() ? std::string(name) : fmt::format("{} ({})", name, units);
  }
  return units;
}

const Unit* find_unit(std::string_view written) {
  for (const Unit& unit : kUnits) {
    if (unit.name == written) return &unit;
  }
  const std::string folded = fold(written);
  const Unit* found = nullptr;
  for (const Unit& unit : kUnits) {
    if (fold(unit.name) != folded) continue;
    if (found) return nullptr;  // mn: milli or mega?
    found = &unit;
  }
  return found;
}

std::vector<std::string> known_units() {
  std::vector<std::string> names;
  for (const Unit& unit : kUnits) names.emplace_back(unit.name);
  return names;
}

}  // namespace animado::interexpserv
