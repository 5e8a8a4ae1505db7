// A system of ordinary differential equations written as expressions, x' = v, compiled once.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "interexpserv/program.hpp"

namespace animado::fred {

using NamedValues = std::vector<std::pair<std::string, double>>;

// The value of a name (folded) that neither the equations nor the constants know; nothing when there is none.
using Lookup = std::function<std::optional<interexpserv::Value>(std::string_view name)>;

class Equations {
 public:
  // Each text is "unknown' = expression" of t, the unknowns, the constants and what is looked up, or a
  // definition that the others may use, "name = expression" or "function(parameters) = expression"; case and
  // accents do not matter. Throws syntax, type, unknown_name and, for a name that is given twice, conflict;
  // where names the text.
  Equations(std::span<const std::string> texts, const NamedValues& constants, Lookup lookup = {});
  ~Equations();

  size_t size() const { return unknowns_.size(); }
  // As written, in the order of the equations.
  const std::vector<std::string>& unknowns() const { return unknowns_; }
  // Which of the texts gives unknown i, for messages: "equations[2]".
  const std::string& place(size_t i) const { return places_[i]; }

  // The values of the unknowns in that order. Throws bad_params when one is missing, unknown_name when there
  // is one too many, conflict when one is given twice.
  std::vector<double> arranged(const NamedValues& from) const;

  // rate[i] = the right-hand side of equation i at (t, y).
  void evaluate(double t, std::span<const double> y, std::span<double> rate) const;

  // jacobian[i n + j] = ∂ rate_i / ∂ y_j, exact to rounding.
  void differentiate(double t, std::span<const double> y, std::span<double> jacobian) const;

  // The unknowns that equation i reads.
  std::vector<size_t> read_by(size_t i) const;

  // Another expression of the same names; "a = b" means a - b. The equations must outlive what is returned.
  std::function<double(double t, std::span<const double> y)> expression(std::string_view text,
                                                                        const std::string& where) const;

 private:
  class Names;
  struct Expression {
    interexpserv::Program program;
    std::vector<size_t> sources;  // of its inputs: 0 is t, 1 + i the unknown i
  };
  Expression compiled(std::string_view text, const std::string& where, const char* remedy) const;
  void load(const Expression& expression, double t, std::span<const double> y) const;

  std::vector<std::string> unknowns_, folded_, places_;
  std::unique_ptr<Names> names_;
  std::vector<Expression> right_sides_;
  mutable std::vector<double> inputs_, rates_;  // scratch
};

}  // namespace animado::fred
