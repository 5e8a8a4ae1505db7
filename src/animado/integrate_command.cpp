// animado integrate: differential equations from the command line, by fred of the suite that runs, or in this
// process.
#include <unistd.h>

#include <algorithm>

#include "animado/braille_plot.hpp"
#include "animado/commands.hpp"
#include "animado/suite_or_own.hpp"
#include "base/error.hpp"
#include "console/terminal.hpp"
#include "controle/results/output_file.hpp"
#include "fred/client.hpp"
#include "interexpserv/program.hpp"

namespace animado {

namespace {

constexpr auto kIntegrateExamples =
    "  animado integrate \"x' = v; v' = -x\" --from \"x=1, v=0\" --until 10 --plot\n"
    "  animado integrate \"x' = v; v' = -k*x\" --from \"x=1, v=0\" --with \"k=4*pi^2\" --until 1 --samples "
    "4\n"
    "  animado integrate \"y' = v; v' = -9.81\" --from \"y=10, v=0\" --until 9 --stop \"y = 0\"\n"
    "  animado integrate \"y' = -1000*(y - cos(t))\" --from y=0 --until 10 --method radau5 --csv out.csv\n";

constexpr double kDefaultTolerance = 1e-9;
constexpr int64_t kTableRows = 20, kPlotSamples = 400;

struct IntegrateOptions {
  SuiteChoice suite;
  std::string equations, from, with, method, csv;
  std::vector<std::string> events, stops;
  double since = 0, until = 0, tolerance = 0, step = 0, max_time_s = 60;
  int64_t samples = 0;
  bool plot = false;
};

// The parts between separators that stand outside parentheses.
std::vector<std::string> parts(const std::string& text, char separator) {
  std::vector<std::string> found(1);
  int depth = 0;
  for (const char c : text) {
    depth += (c == '(') - (c == ')');
    if (c == separator && depth == 0) {
      found.emplace_back();
    } else {
      found.back() += c;
    }
  }
  std::erase_if(found, [](const std::string& part) { return part.find_first_not_of(" \t\n") == part.npos; });
  return found;
}

std::string trimmed(const std::string& text) {
  const size_t begin = text.find_first_not_of(" \t\n");
  return begin == text.npos ? "" : text.substr(begin, text.find_last_not_of(" \t\n") + 1 - begin);
}

// "x=1, v=2*pi"
std::vector<fred::Integrate::Value> values(const std::string& text, const char* option) {
  std::vector<fred::Integrate::Value> found;
  for (const std::string& part : parts(text, ',')) {
    const size_t equals = part.find('=');
    if (equals == part.npos)
      throw Error(Code::syntax, fmt::format("'{}' is not a value", trimmed(part)), option, "write it as x=1");
    const auto program = interexpserv::compile(part.substr(equals + 1), interexpserv::MapScope(), option,
                                               interexpserv::Type::scalar);
    found.push_back({trimmed(part.substr(0, equals)), program.constant().v[0]});
  }
  return found;
}

bool is_adaptive(fred::Client& fred, const std::string& name) {
  if (name.empty()) return true;  // fred's own choice for a tolerance
  for (const auto& method : fred.methods().methods) {
    if (method.name == name)
      return method.kind == fred::MethodKind::explicit_adaptive || method.kind == fred::MethodKind::implicit;
  }
  return false;  // fred will say that there is none
}

fred::Integrate::Request request_of(const IntegrateOptions& options, fred::Client& fred) {
  fred::Integrate::Request request;
  request.equations = parts(options.equations, ';');
  request.from = values(options.from, "--from");
  request.constants = values(options.with, "--with");
  request.t0 = options.since;
  request.t1 = options.until;
  request.method = options.method;
  request.step = options.step;
  request.tolerance = options.tolerance;
  if (options.tolerance == 0 && options.step == 0 && is_adaptive(fred, options.method)) {
    request.tolerance = kDefaultTolerance;
  }
  request.samples = options.samples > 0 ? options.samples : options.plot ? kPlotSamples : kTableRows;
  for (const std::string& text : options.events) request.events.push_back({text, fred::Crossing::any, false});
  for (const std::string& text : options.stops) request.events.push_back({text, fred::Crossing::any, true});
  request.max_time_s = options.max_time_s;
  return request;
}

// A row a sample; what the reply holds, as text.
std::vector<std::vector<std::string>> table(const fred::Integrate::Reply& reply, const char* format) {
  std::vector<std::vector<std::string>> rows(1);
  rows[0].push_back("t");
  rows[0].insert(rows[0].end(), reply.names.begin(), reply.names.end());
  const size_t columns = rows[0].size();
  for (size_t i = 0; i < reply.samples.values.size(); ++i) {
    if (i % columns == 0) rows.emplace_back();
    rows.back().push_back(fmt::format(fmt::runtime(format), reply.samples.values[i]));
  }
  return rows;
}

void print_table(const fred::Integrate::Reply& reply) {
  const auto rows = table(reply, "{:.9g}");
  std::vector<size_t> widths(rows[0].size());
  for (const auto& row : rows) {
    for (size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  }
  for (const auto& row : rows) {
    std::string line;
    for (size_t c = 0; c < row.size(); ++c)
      line += fmt::format("{}{:>{}}", c == 0 ? "" : "  ", row[c], widths[c]);
    fmt::print("{}\n", line);
  }
}

void write_csv(const fred::Integrate::Reply& reply, const std::string& file) {
  std::string text;
  for (const auto& row : table(reply, "{:.17g}"))
    fmt::format_to(std::back_inserter(text), "{}\n", fmt::join(row, ","));
  controle::write_whole(file, text);
}

void print_plot(const fred::Integrate::Reply& reply) {
  const size_t columns = 1 + reply.names.size(), rows = reply.samples.values.size() / columns;
  std::vector<double> t(rows);
  std::vector<Curve> curves;
  for (const std::string& name : reply.names) curves.push_back({name, std::vector<double>(rows)});
  for (size_t row = 0; row < rows; ++row) {
    t[row] = reply.samples.values[row * columns];
    for (size_t c = 0; c < curves.size(); ++c) curves[c].y[row] = reply.samples.values[row * columns + 1 + c];
  }
  fmt::print("{}", braille_plot(t, curves, plot_size(STDOUT_FILENO), shows_colours(STDOUT_FILENO)));
}

void print_events(const IntegrateOptions& options, const fred::Integrate::Reply& reply) {
  for (const auto& event : reply.events) {
    const auto number = static_cast<size_t>(event.event);
    const std::string& text = number < options.events.size() ? options.events[number]
                                                             : options.stops[number - options.events.size()];
    std::string line = fmt::format("{} at t = {:.12g}:", text, event.t);
    for (size_t i = 0; i < reply.names.size(); ++i)
      line += fmt::format(" {} = {:.9g}", reply.names[i], event.state[i]);
    fmt::print("{}\n", line);
  }
}

ExitCode tell_end(const fred::Integrate::Reply& reply) {
  using fred::Stop;
  const auto failed = [&](std::string message, std::string remedy) {
    print_error(
        Error(Code::diverged, fmt::format("{} at t = {:.9g}", message, reply.t), {}, std::move(remedy)));
    return kDiverged;
  };
  switch (reply.stop) {
    case Stop::step_too_small:
      return failed("steps would be too small to go on: the equations are stiff or singular",
                    "look for a pole there; for a stiff system use --method radau5");
    case Stop::not_finite:
      return failed("the solution is not finite",
                    "look for a division by zero or a root of a negative number");
    case Stop::step_limit:
      return failed("so many steps were taken that it stopped",
                    "give a larger --tolerance; for a stiff system use --method radau5");
    case Stop::time_limit:
      return failed("it took so long that it stopped",
                    "give a larger --tolerance, or --time-limit; for a stiff system use --method radau5");
    default:
      return kDone;
  }
}

ExitCode integrate(const IntegrateOptions& options) {
  const auto suite = suite_or_own(options.suite);
  fred::Client fred(suite->channel("fred"));
  const auto reply = fred.integrate(request_of(options, fred));
  if (!options.csv.empty()) write_csv(reply, options.csv);
  if (options.plot) print_plot(reply);
  if (options.csv.empty() && !options.plot) print_table(reply);
  print_events(options, reply);
  return tell_end(reply);
}

}  // namespace

void add_integrate_command(CommandLine& line) {
  const auto options = std::make_shared<IntegrateOptions>();
  CLI::App& command = add_command(line, "integrate", "Integrate differential equations", kIntegrateExamples);
  command.add_option("equations", options->equations, "One an unknown, as \"x' = v; v' = -x\"")->required();
  command.add_option("--from", options->from, "The unknowns at the start, as \"x=1, v=0\"")->required();
  command.add_option("--until", options->until, "The end")->required();
  command.add_option("--since", options->since, "The start (default: 0)");
  command.add_option("--with", options->with, "Constants, as \"k=4, m=2\"");
  command.add_option("--method", options->method,
                     "A method of fred (docs/fred.md); default: dopri5, rk4 with --step");
  command.add_option("--tolerance", options->tolerance, "Of the error of a step (default: 1e-9)")
      ->check(CLI::PositiveNumber);
  command.add_option("--step", options->step, "Steps of one length; with --tolerance the largest")
      ->check(CLI::PositiveNumber);
  command.add_option("--samples", options->samples, "Rows beside the start (default: 20)")
      ->check(CLI::PositiveNumber);
  command.add_option("--event", options->events, "Tell when this happens, as \"x = 0\"");
  command.add_option("--stop", options->stops, "End when this happens");
  command.add_option("--time-limit", options->max_time_s, "Seconds that it may take (default: 60)")
      ->check(CLI::PositiveNumber);
  command.add_flag("--plot", options->plot, "Draw the curves");
  command.add_option("--csv", options->csv, "Write the table to this file")->type_name(kFileType);
  add_suite_choice(command, options->suite);
  command.callback([options, &line] { line.exit_code = integrate(*options); });
}

}  // namespace animado
