// animado report: the page of a run again, from its results.
#include "animado/commands.hpp"
#include "console/terminal.hpp"
#include "report/page.hpp"

namespace animado {

namespace {

namespace fs = std::filesystem;

constexpr auto kReportExamples =
    "  animado report runs/colisao                makes runs/colisao/report.html again\n"
    "  xdg-open runs/colisao/report.html          opens it: no network, no server\n\n"
    "A run makes it by itself, unless it was told --no-pictures.\n"
    "Exit codes: 0 done, 2 there are no results, or they cannot be read.\n";

}  // namespace

void add_report_command(CommandLine& line) {
  const auto directory = std::make_shared<fs::path>();
  CLI::App& command = add_command(line, "report", "Make the page of a run: report.html", kReportExamples);
  command.add_option("results", *directory, "The folder of a run")->required()->type_name(kFolderType);
  command.callback([&line, directory] {
    try {
      report::write_report(*directory);
      print_note("report in " + (*directory / "report.html").string());
    } catch (const Error& error) {
      print_error(error);
      line.exit_code = kUsage;
    }
  });
}

}  // namespace animado
