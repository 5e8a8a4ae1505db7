// controle: steps a scene's time with the other modules, which it finds through interexpserv. `animado run`
// starts it.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>

#include "base/error.hpp"
#include "console/output.hpp"
#include "console/program_manual.hpp"
#include "console/terminal.hpp"
#include "console/usage_error.hpp"
#include "controle/pace.hpp"
#include "controle/results/recorded_run.hpp"
#include "controle/run.hpp"
#include "rpc/socket_suite.hpp"

namespace {

using namespace animado;

volatile std::sig_atomic_t stop_asked = 0;

int exit_code(Code code) {
  if (code == Code::diverged) return 4;
  const bool lost = code == Code::unavailable || code == Code::protocol || code == Code::internal;
  return lost ? 5 : 3;
}

int run(int argc, char** argv) {
  CLI::App app(
      "Reads a scene, steps its time with egesp, fred and colisao, writes the results. `animado run` starts "
      "the five together.",
      "controle");
  add_manual(app, "controle",
             "  controle --scene scenes/colisao.animado --out tonight\n"
             "  controle --scene a.animado --out a --socket-dir $XDG_RUNTIME_DIR/animado/colisao\n");
  controle::RunOptions options;
  rpc::SocketSuite::Options suite_options;
  int progress_fd = -1, pace_fd = -1;
  std::filesystem::path replay;
  app.set_version_flag("--version", ANIMADO_VERSION);
  app.add_option("--scene", options.scene, "the scene's file")->required();
  app.add_option("--out", options.directory, "directory for the results; it must be there")
      ->required()
      ->check(CLI::ExistingDirectory);
  app.add_option("--socket-dir", suite_options.directory, "directory of the run's sockets");
  app.add_flag("--extensions", options.physics_extensions,
               "animation.glb holds masses and solids too: drafts of glTF extensions");
  app.add_option("--progress-fd", progress_fd,
                 "descriptor for lines of progress: at each frame, and within one that takes long");
  app.add_option("--pace-fd", pace_fd, "descriptor of commands: pause, resume, step, speed S; a line each");
  app.add_option("--replay", replay, "events.jsonl of an earlier run whose edits are made again")
      ->check(CLI::ExistingFile);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return exit_of_parse(app, error);
  }

  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { stop_asked = 1; });
  std::signal(SIGPIPE, SIG_IGN);  // who stops reading the progress does not stop the run
  options.stop = [] { return stop_asked != 0; };
  options.name = "run/" + std::to_string(getpid());
  options.progress = [&](const controle::Progress& progress) {
    const std::string line = progress_line(progress);
    if (progress_fd >= 0 && write(progress_fd, line.data(), line.size()) < 0) progress_fd = -1;
  };
  std::optional<controle::Pace> pace;
  if (pace_fd >= 0) {
    pace.emplace(pace_fd, options.stop);
    options.pace = [&](double time_s) { pace->wait(time_s); };
  }
  suite_options.client = "controle";
  suite_options.trace = std::to_string(getpid());
  try {
    if (!replay.empty()) options.edits = controle::edits_of(controle::read_events(replay));
    rpc::SocketSuite suite(suite_options);
    return controle::run(options, suite).status == controle::RunStatus::interrupted ? 130 : 0;
  } catch (const Error& error) {
    print_error(error);
    return exit_code(error.code());
  }
}

}  // namespace

int main(int argc, char** argv) {
  return with_output([&] { return run(argc, argv); });
}
