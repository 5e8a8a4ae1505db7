// From the options to the file.
#include <atomic>
#include <charconv>
#include <csignal>
#include <iostream>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "console/progress_line.hpp"
#include "visao/film.hpp"
#include "visao/moments.hpp"
#include "visao/options.hpp"
#include "visao/sheet.hpp"

namespace animado::visao {

namespace {

namespace fs = std::filesystem;
using controle::RecordedRun;

constexpr int kDone = 0, kInterrupted = 130;
constexpr size_t kFramesOnASheet = 12;
// In all its frames: what a run leaves by itself costs a second or two.
constexpr size_t kBodiesOnASheet = 8000;
constexpr int kSmallest_px = 64, kLargest_px = 16384;

std::atomic<bool> stop_asked = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set it");

struct AskedSize {
  std::optional<int> width_px, height_px;
};

AskedSize size_of(const std::string& text) {
  if (text.empty()) return {};
  const auto refuse = [&] {
    throw Error(Code::bad_params, fmt::format("`{}` is not a size", text), "--size",
                fmt::format("write 1280x720, or 1280 alone; from {} to {} px", kSmallest_px, kLargest_px));
  };
  const auto number = [&](std::string_view word) {
    int value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) refuse();
    if (value < kSmallest_px || value > kLargest_px) refuse();
    return value;
  };
  const std::string_view words = text;
  const size_t times = words.find('x');
  if (times == std::string_view::npos) return {number(words), {}};
  return {number(words.substr(0, times)), number(words.substr(times + 1))};
}

View view_of(const Options& options) {
  View view;
  set_camera(view, options.camera);
  if (!options.look_at.empty()) view.look_at_m = point_of(options.look_at, "--look-at");
  return view;
}

// The scene's name, without its folder and ending; a summary without one has no title.
std::string title_of(const RecordedRun& run) {
  const auto summary = nlohmann::json::parse(run.summary_json, nullptr, false);
  return summary.is_object() ? fs::path(summary.value("scene", "")).stem().string() : "";
}

// The frames that were asked for; without a word, so many from the first to the last.
std::vector<size_t> frames_of(const Options& options, const RecordedRun& run, size_t otherwise) {
  if (run.frames() == 0) {
    throw Error(Code::refused, "the run has no frames", options.directory.string(),
                "there is nothing to see of a scene that was refused or stopped at once; run it again");
  }
  return options.frames.empty() ? even_frames(run.frames(), otherwise)
                                : named_frames(options.frames, run.frames());
}

size_t frames_on_a_sheet(const RecordedRun& run) {
  const size_t affordable = kBodiesOnASheet / std::max<size_t>(run.bodies.size(), 1);
  return std::clamp<size_t>(affordable, 1, kFramesOnASheet);
}

int make_sheet(const Options& options, const RecordedRun& run, const fs::path& file) {
  const AskedSize asked = size_of(options.size);
  SheetRequest request{frames_of(options, run, frames_on_a_sheet(run)), view_of(options)};
  request.width_px = asked.width_px.value_or(request.width_px);
  request.height_px = asked.height_px;
  request.title = title_of(run);
  write_png(file, sheet(run, request));
  return kDone;
}

int make_film(const Options& options, const RecordedRun& run, const fs::path& file) {
  const std::vector<size_t> frames = frames_of(options, run, 2);  // the first and the last
  FilmRequest request{file, run.times_s[frames.front()], run.times_s[frames.back()], view_of(options)};
  const AskedSize asked = size_of(options.size);
  const int width_px = asked.width_px.value_or(request.size.width_px);
  request.size = {width_px, asked.height_px.value_or(width_px * 9 / 16)};
  // The codec keeps colour for 2 x 2 pixels.
  request.size.width_px -= request.size.width_px % 2;
  request.size.height_px -= request.size.height_px % 2;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, [](int) { stop_asked = true; });
  std::signal(SIGPIPE, SIG_IGN);  // an encoder that ended is found by the write that fails
  request.stop = [] { return stop_asked.load(); };
  using Clock = std::chrono::steady_clock;
  ProgressLine progress(progress_style(options.quiet), stderr, Clock::now());
  request.on_picture = [&](int64_t done, int64_t all) {
    const double part = static_cast<double>(done) / static_cast<double>(all);
    progress.show(part, Clock::now(), [&](double elapsed_s) {
      return fmt::format("{} picture {} of {}{}", progress_bar(part), done, all, time_left(part, elapsed_s));
    });
  };
  return film(run, request) ? kDone : kInterrupted;
}

}  // namespace

int render(const Options& options) {
  const RecordedRun run = controle::read_run(options.directory);
  const fs::path file =
      !options.output.empty() ? options.output : options.directory / (options.mp4 ? "film.mp4" : "sheet.png");
  const int code = options.mp4 ? make_film(options, run, file) : make_sheet(options, run, file);
  if (code == kDone && !options.quiet) std::cout << file.string() << "\n";
  return code;
}

}  // namespace animado::visao
