// A system of ordinary differential equations written as expressions, x' = v, compiled once.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "interexpserv/program.hpp"

namespace animado::fred {

using NamedValues = std::vector<std::pair<std::string, double>>;

class Equations {
 public:
  // Each text is "unknown' = expression" of t, the unknowns and the constants; case and accents do not
  // matter. Throws syntax, type, unknown_name and, for a name that is given twice, conflict; where names the
  // equation.
  Equations(std::span<const std::string> texts, const NamedValues& constants);

  size_t size() const { return unknowns_.size(); }
  const std::vector<std::string>& unknowns() const {
    return unknowns_;
  }  // as written, in the order of the equations

  // The values of the unknowns in that order. Throws bad_params when one is missing, unknown_name when there
  // is one too many, conflict when one is given twice.
  std::vector<double> arranged(const NamedValues& from) const;

  // rate[i] = the right-hand side of equation i at (t, y).
  void evaluate(double t, std::span<const double> y, std::span<double> rate) const;

 private:
  struct RightSide {
    interexpserv::Program program;
    std::vector<size_t> sources;  // of its inputs: 0 is t, 1 + i the unknown i
  };
  size_t source_of(const std::string& input) const;

  std::vector<std::string> unknowns_, folded_;
  std::vector<RightSide> right_sides_;
  mutable std::vector<double> arguments_, inputs_;  // scratch
};

}  // namespace animado::fred
