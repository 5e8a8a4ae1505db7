// What a plot shows of a run, by name: curves over time, those of one unit in one panel.
#pragma once

#include <string>
#include <vector>

#include "animado/braille_plot.hpp"
#include "controle/results/recorded_run.hpp"

namespace animado {

struct Panel {
  std::string quantity, unit;  // "energy", "J"; the unit of a count is empty
  std::vector<Curve> curves;
};

struct RunCurves {
  std::vector<double> times_s;
  std::vector<Panel> panels;
};

// names: energy, residual, momentum, contacts, step, or BODY.x and its like. Throws Error(unknown_name) that
// says what there is.
RunCurves curves_of(const controle::RecordedRun& run, const std::vector<std::string>& names);

// "energy (J)"
std::string label_of(const Panel& panel);

// A header and a row a frame: time_s, and a column a curve.
std::string csv_of(const RunCurves& curves);

}  // namespace animado
