// A run with the services in this process.
#include <atomic>
#include <csignal>

#include "animado/in_process.hpp"
#include "animado/run_ways.hpp"
#include "console/terminal.hpp"
#include "controle/results/recorded_run.hpp"
#include "controle/run.hpp"

namespace animado {

namespace {

std::atomic<bool> stop_asked = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set it");

}  // namespace

ExitCode run_in_process(const RunRequest& request) {
  const auto ask_to_stop = [](int) { stop_asked = true; };
  std::signal(SIGINT, ask_to_stop);
  std::signal(SIGTERM, ask_to_stop);
  controle::RunOptions options;
  options.scene = request.scene;
  options.directory = request.directory;
  options.name = request.name;
  options.physics_extensions = request.physics_extensions;
  options.progress = request.on_progress;
  options.stop = [] { return stop_asked.load(); };
  if (!request.replay.empty()) options.edits = controle::edits_of(controle::read_events(request.replay));
  const auto suite = suite_in_process(request.directory / "logs");
  try {
    const controle::Summary summary = controle::run(options, *suite);
    return summary.status == controle::RunStatus::interrupted ? kInterrupted : kDone;
  } catch (const Error& error) {
    print_error(error);
    return exit_code_of_run(error.code());
  }
}

}  // namespace animado
