#include "interexpserv/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "interexpserv/lanes.hpp"

namespace animado::interexpserv {
namespace {

constexpr size_t kMaxPoints = 1'000'000;  // 40 MB of pieces

void check(std::span<const double> x, std::span<const double> y) {
  if (x.size() < 2 || x.size() != y.size()) {
    throw Error(Code::bad_shape, fmt::format("a table of {} points", x.size()), {},
                "a table has two or more");
  }
  for (size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(x[i]) || !std::isfinite(y[i])) {
      throw Error(Code::bad_shape, fmt::format("point {} of the table is not finite", i + 1), {},
                  "take it out");
    }
    if (i > 0 && x[i] <= x[i - 1]) {
      throw Error(Code::bad_shape, fmt::format("x goes from {} to {} in a table", x[i - 1], x[i]), {},
                  "sort the points by x, each x once");
    }
  }
}

// The slope at a point between two pieces of slopes p and q and widths h and k: of the parabola through the
// three points, but no steeper than twice either, and 0 at an extremum.
double limited_slope(double h, double p, double k, double q) {
  if (p * q <= 0) return 0;
  const double parabola = (p * k + q * h) / (h + k);
  return std::copysign(std::min({std::fabs(parabola), 2 * std::fabs(p), 2 * std::fabs(q)}), p);
}

std::vector<double> slopes_at(std::span<const double> x, std::span<const double> secants) {
  const size_t n = x.size();
  std::vector<double> slopes(n);
  slopes[0] = secants[0];
  slopes[n - 1] = secants[n - 2];
  for (size_t i = 1; i + 1 < n; ++i) {
    slopes[i] = limited_slope(x[i] - x[i - 1], secants[i - 1], x[i + 1] - x[i], secants[i]);
  }
  return slopes;
}

bool is_separator(char c) {
  return c == ',' || c == ';' || c == ' ' || c == '\t' || c == '\r';
}

// The numbers that a line begins with, at most two.
size_t read_numbers(const std::string& line, double (&numbers)[2]) {
  const char *at = line.data(), *end = at + line.size();
  size_t count = 0;
  while (count < 2) {
    while (at != end && is_separator(*at)) ++at;
    if (at != end && *at == '+') ++at;
    const auto [next, status] = std::from_chars(at, end, numbers[count]);
    if (status != std::errc{} || (next != end && !is_separator(*next))) break;
    at = next;
    ++count;
  }
  return count;
}

}  // namespace

Table::Table(std::span<const double> x, std::span<const double> y, Interpolation interpolation)
    : x_(x.begin(), x.end()) {
  check(x, y);
  std::vector<double> secants;
  for (size_t i = 0; i + 1 < x.size(); ++i) secants.push_back((y[i + 1] - y[i]) / (x[i + 1] - x[i]));
  const std::vector<double> slopes = slopes_at(x, secants);
  for (size_t i = 0; i + 1 < x.size(); ++i) {
    const double h = x[i + 1] - x[i], b = slopes[i], end = slopes[i + 1], p = secants[i];
    if (interpolation == Interpolation::linear) {
      pieces_.push_back({y[i], p, 0, 0});
    } else {
      pieces_.push_back({y[i], b, (3 * p - 2 * b - end) / h, (b + end - 2 * p) / (h * h)});
    }
  }
  pieces_.push_back({y.back(), 0, 0, 0});
  before_ = y.front();
}

Table::Place Table::find(double x) const {
  if (x < x_.front()) return {{before_, 0, 0, 0}, 0};
  if (std::isnan(x)) return {{x, x, x, x}, 0};
  const auto after = std::upper_bound(x_.begin(), x_.end(), x);
  const auto i = static_cast<size_t>(after - x_.begin()) - 1;
  return {pieces_[i], i + 1 == pieces_.size() ? 0 : x - x_[i]};
}

double Table::operator()(double x) const {
  const auto [piece, s] = find(x);
  return piece.y + s * (piece.b + s * (piece.c + s * piece.d));
}

double Table::slope(double x) const {
  const auto [piece, s] = find(x);
  return piece.b + s * (2 * piece.c + s * (3 * piece.d));
}

Table Table::derivative() const {
  Table slope;
  slope.x_ = x_;
  for (const Piece& piece : pieces_) slope.pieces_.push_back({piece.b, 2 * piece.c, 3 * piece.d, 0});
  return slope;
}

double look_up(const Table* tables, double table, double x) {
  return tables[static_cast<size_t>(table)](x);
}

Table read_table(const std::string& path, Interpolation interpolation) {
  std::ifstream file(path);
  if (!file)
    throw Error(Code::unknown_name, fmt::format("no table `{}` can be read", path), path, "check the path");
  std::vector<double> x, y;
  std::string line;
  bool may_be_heading = true;
  for (size_t number = 1; std::getline(file, line); ++number) {
    const size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || line[first] == '#') continue;
    double numbers[2];
    if (read_numbers(line, numbers) < 2) {
      if (std::exchange(may_be_heading, false)) continue;
      throw Error(Code::syntax, fmt::format("`{}` does not begin with two numbers", line.substr(0, 60)),
                  fmt::format("{}:{}", path, number), "a line of a table is `x, y`");
    }
    may_be_heading = false;
    if (x.size() == kMaxPoints) {
      throw Error(Code::limit, fmt::format("more than {} points", kMaxPoints), path, "use fewer");
    }
    x.push_back(numbers[0]);
    y.push_back(numbers[1]);
  }
  try {
    return {x, y, interpolation};
  } catch (const Error& error) {
    throw Error(error.code(), error.message(), path, error.remedy());
  }
}

}  // namespace animado::interexpserv
