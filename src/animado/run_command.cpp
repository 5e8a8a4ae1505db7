// animado run: a scene from its file to its results.
#include <unistd.h>

#include <fstream>
#include <iostream>

#include "animado/commands.hpp"
#include "animado/end_report.hpp"
#include "animado/pictures.hpp"
#include "animado/progress_text.hpp"
#include "animado/replay.hpp"
#include "animado/run_report.hpp"
#include "animado/run_ways.hpp"
#include "animado/scene_check.hpp"
#include "animado/watch_run.hpp"
#include "console/progress_line.hpp"
#include "console/terminal.hpp"
#include "controle/results/results_directory.hpp"

namespace animado {

namespace {

namespace fs = std::filesystem;

constexpr auto kRunExamples =
    "  animado run scenes/colisao.animado                results in runs/colisao/\n"
    "  animado run scenes/colisao.animado --out tonight  results in tonight/\n"
    "  animado run scenes/colisao.animado --in-process   one process instead of five: the same bits\n"
    "  animado run scenes/colisao.animado --mp4          a film too\n"
    "  animado run scenes/colisao.animado --json         the summary as JSON on stdout\n"
    "  animado run scenes/spring.animado --live          a page to watch it, pause it and edit its names\n"
    "  animado run --replay runs/spring                  the same once more, with the edits it took\n\n"
    "Exit codes: 0 done, 1 a replay that is not the same, 2 usage, 3 scene refused, 4 the motion diverged, 5 "
    "a service was lost, 130 interrupted.\n";

struct RunOptions {
  std::string scene, out, name, replay_of;
  bool extensions = false, in_process = false, quiet = false, json = false, keep_services = false;
  bool no_pictures = false, mp4 = false, live = false;
  uint16_t port = 0;
  std::optional<Replay> replay;
};

// A run that ended, even early, leaves whole results; one that was lost leaves what it had, to be read.
// Returns the code to exit with.
ExitCode finish(const RunOptions& options, controle::ResultsDirectory& results, ExitCode code) {
  if (code == kLost || !fs::exists(results.path() / "summary.json")) {
    print_note("no results; the logs are in " + fs::proximate(results.logs()).string());
    return code;
  }
  if (!options.no_pictures) {
    const bool film = options.mp4 && code == kDone;
    make_pictures(results.path(), results.final_path(), {.film = film, .quiet = options.quiet});
    add_report(results.path(), results.final_path());
  }
  ReplayOutcome replayed = {.same = true, .text = {}};
  if (options.replay) replayed = outcome_of(*options.replay, results.path());  // which these may replace
  results.commit();
  if (!options.quiet) print_text(end_report(results.final_path()) + replayed.text);
  if (options.json) std::cout << std::ifstream(results.final_path() / "summary.json").rdbuf() << std::flush;
  return code == kDone && !replayed.same ? kDiffers : code;
}

ExitCode run_into(const RunOptions& options, controle::ResultsDirectory& results) {
  using Clock = std::chrono::steady_clock;
  ProgressLine progress(progress_style(options.quiet), stderr, Clock::now());
  RunRequest request{.scene = options.scene,
                     .directory = results.path(),
                     .name = options.name,
                     .keep_services = options.keep_services,
                     .physics_extensions = options.extensions};
  if (options.replay) request.replay = options.replay->events;
  request.on_progress = [&](const controle::Progress& p) {
    progress.show(part_of(p), Clock::now(), [&](double elapsed_s) { return progress_text(p, elapsed_s); });
  };
  if (options.in_process) {
    const ExitCode code = run_in_process(request);
    progress.clear();
    return finish(options, results, code);
  }
  std::unique_ptr<live::Watch> watch;
  if (options.live) {
    watch = watch_run(request, options.port);
    request.pace_fd = watch->pace_fd();
    request.on_ended = [&] { end_watch(*watch, results.path()); };
  }
  ExitCode finished = kDone;
  const ExitCode code = run_with_services(request, [&](ExitCode ended) {
    progress.clear();
    finished = finish(options, results, ended);
    return fs::exists(results.logs()) ? results.logs() : results.final_path() / "logs";
  });
  return code == kDone ? finished : code;
}

ExitCode run(RunOptions options) {
  try {
    if (!options.replay_of.empty()) {
      options.replay = read_replay(options.replay_of);
      options.scene = options.replay->scene;
      if (options.out.empty())
        options.out = fs::path(options.replay_of).lexically_normal().string() + "-replay";
    }
    check_scene(options.scene);
  } catch (const Error& error) {
    print_error(error);
    return kRefused;
  }
  const std::string stem = fs::path(options.scene).stem().string();
  if (options.out.empty()) options.out = fs::path("runs") / stem;
  if (options.name.empty()) options.name = fmt::format("{}-{}", stem, getpid());

  std::optional<controle::ResultsDirectory> results;
  try {
    results.emplace(options.out);
  } catch (const Error& error) {
    print_error(error);
    return kUsage;
  }
  try {
    return run_into(options, *results);
  } catch (const Error& error) {
    print_error(error);
    finish(options, *results, kLost);
    return kLost;
  }
}

}  // namespace

void add_run_command(CommandLine& line) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App& command = add_command(line, "run", "Simulate a scene", kRunExamples);
  const auto scene = command.add_option("scene", options->scene, "The scene's file")->type_name(kSceneType);
  command.add_option("--out", options->out, "Directory of the results (default: runs/<scene>)")
      ->type_name(kFolderType);
  command.add_option("--run", options->name,
                     "Name of the run, for `animado ps` and its like (default: <scene>-<pid>)");
  const auto in_process =
      command.add_flag("--in-process", options->in_process, "The services as part of this process");
  command
      .add_flag("--keep-services", options->keep_services,
                "Leave the services running at the end, until Ctrl-C")
      ->excludes(in_process);
  command.add_flag("--extensions", options->extensions,
                   "animation.glb holds masses and solids too: drafts of glTF extensions (docs/results.md)");
  const auto live = command
                        .add_flag("--live", options->live,
                                  "Serve a page on 127.0.0.1 that watches the run, which waits for it")
                        ->excludes(in_process);
  command.add_option("--port", options->port, "Port of the page (default: any that is free)")->needs(live);
  command
      .add_option("--replay", options->replay_of,
                  "Instead of a scene: results of a run, which is made again with the edits that it took")
      ->check(CLI::ExistingDirectory)
      ->excludes(scene);
  const auto no_pictures = command.add_flag("--no-pictures", options->no_pictures,
                                            "Numbers only: neither sheet.png nor report.html");
  command.add_flag("--mp4", options->mp4, "A film of the run too, film.mp4; needs ffmpeg")
      ->excludes(no_pictures);
  command.add_flag("--quiet", options->quiet, "No progress and no report; errors are still told");
  command.add_flag("--json", options->json, "The summary on stdout");
  command.callback([&line, options] {
    if (options->scene.empty() && options->replay_of.empty()) throw CLI::RequiredError("scene, or --replay,");
    line.exit_code = run(*options);
  });
}

}  // namespace animado
