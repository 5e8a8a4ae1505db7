// animado plot: curves of a run, in the terminal, as a picture or as a table.
#include <unistd.h>

#include "animado/braille_plot.hpp"
#include "animado/commands.hpp"
#include "animado/plot_picture.hpp"
#include "animado/run_curves.hpp"
#include "console/terminal.hpp"
#include "controle/results/output_file.hpp"

namespace animado {

namespace {

constexpr auto kPlotExamples =
    "  animado plot runs/colisao                                      energy over time, in the terminal\n"
    "  animado plot runs/colisao cubo.y esfera.y esfera.speed         a panel a unit\n"
    "  animado plot runs/colisao energy residual --output plot.svg    a picture; also .png\n"
    "  animado plot runs/colisao momentum --csv momentum.csv          a table\n\n"
    "Of a run: energy, residual, momentum, contacts, step. Of a body: x, y, z, vx, vy, vz, speed,\n"
    "wx, wy, wz, spin, ex, ey, ez (Euler angles).\n";

struct PlotOptions {
  std::string directory, output, csv;
  std::vector<std::string> what;
};

void print(const RunCurves& curves) {
  const PlotSize size = plot_size(STDOUT_FILENO);
  for (const Panel& panel : curves.panels) {
    fmt::print("{}\n{}", label_of(panel),
               braille_plot(curves.times_s, panel.curves, size, shows_colours(STDOUT_FILENO)));
  }
}

void plot(const PlotOptions& options) {
  const auto run = controle::read_run(options.directory);
  if (run.frames() == 0)
    throw Error(Code::unavailable, "this run has no frames", options.directory, "simulate the scene again");
  const RunCurves curves =
      curves_of(run, options.what.empty() ? std::vector<std::string>{"energy"} : options.what);
  if (!options.output.empty()) write_picture(curves, options.output);
  if (!options.csv.empty()) controle::write_whole(options.csv, csv_of(curves));
  if (options.output.empty() && options.csv.empty()) print(curves);
}

}  // namespace

void add_plot_command(CommandLine& line) {
  const auto options = std::make_shared<PlotOptions>();
  CLI::App& command = add_command(line, "plot", "Plot what a run did, over time", kPlotExamples);
  command.add_option("directory", options->directory, "The folder of a run's results")
      ->required()
      ->type_name(kFolderType);
  command.add_option("what", options->what, "Curves (default: energy)")
      ->type_name("{energy,residual,momentum,contacts,step}");
  command.add_option("-o,--output", options->output, "Draw a picture into this file: .svg or .png")
      ->type_name(kFileType);
  command.add_option("--csv", options->csv, "Write the table to this file")->type_name(kFileType);
  command.callback([options] { plot(*options); });
}

}  // namespace animado
