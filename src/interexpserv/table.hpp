// A function known at points, from a file of two columns. Between the points it is a polynomial of each
// piece:
//
//   y(x) = y_i + s (b + s (c + s d)),  s = x − x_i
//
//   linear   the straight line between the points
//   cubic    Hermite's, with the slopes of [STE90]: no higher or lower anywhere than the points on both
//   sides,
//            once continuously differentiable
//
// Before the first point and after the last it stays at their values.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace animado::interexpserv {

enum class Interpolation { linear, cubic };

class Table {
 public:
  // Both ascending in x, at least two. Throws Error bad_shape.
  Table(std::span<const double> x, std::span<const double> y, Interpolation interpolation);

  double operator()(double x) const;  // NaN of NaN
  double slope(double x) const;       // 0 outside
  Table derivative() const;           // the slope as a table

 private:
  struct Piece {
    double y, b, c, d;
  };
  // The piece that x lies in, and how far in it.
  struct Place {
    Piece piece;
    double s;
  };
  Place find(double x) const;
  Table() = default;

  std::vector<double> x_;
  std::vector<Piece> pieces_;  // from each point on; the last is constant
  double before_ = 0;
};

// Reads a file of lines `x, y`: numbers between commas, semicolons or blanks, further columns left aside; a
// first line of words and lines that begin with # are skipped. Throws Error: unknown_name when there is no
// such file, syntax with file:line, bad_shape, limit.
Table read_table(const std::string& path, Interpolation interpolation);

}  // namespace animado::interexpserv
