#include "report/page.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "controle/results/output_file.hpp"
#include "report/base64.hpp"
#include "report/gzip.hpp"
#include "report/payload.hpp"
#include "report/template.hpp"

namespace animado::report {
namespace {

// A run is read whole. One that does not fit into memory must not take its results with it.
constexpr uintmax_t kMostStates_bytes = uintmax_t{1} << 30;

void refuse_huge(const std::filesystem::path& states) {
  std::error_code missing;  // said by who reads it
  const uintmax_t bytes = std::filesystem::file_size(states, missing);
  if (missing || bytes <= kMostStates_bytes) return;
  throw Error(Code::limit, fmt::format("{} MiB of states are too many for one page", bytes >> 20),
              states.string(), "give the scene's `time` a longer `step`: fewer frames, the same motion");
}

std::string page_around(std::string_view run) {
  constexpr std::string_view kPlace = "<!--ANIMADO-RUN-->";
  const std::string_view page = page_template();
  const size_t place = page.find(kPlace);
  if (place == std::string_view::npos) {
    throw Error(Code::internal, "the page has no place for a run", "web/page.html",
                "keep its comment ANIMADO-RUN");
  }
  std::string text(page.substr(0, place));
  text += run;
  return text += page.substr(place + kPlace.size());
}

}  // namespace

std::string page_with(const controle::RecordedRun& run, const std::optional<Traffic>& traffic) {
  return page_around(base64(gzip(payload(run, traffic))));
}

std::string live_page() {
  constexpr std::string_view kRoot = "<html ";
  std::string page = page_around("");
  return page.insert(page.find(kRoot) + kRoot.size(), "data-live ");
}

void write_report(const std::filesystem::path& directory) {
  page_template();  // a program without it says so before it reads for seconds
  refuse_huge(directory / "states.csv");
  const controle::RecordedRun run = controle::read_run(directory);
  const auto traffic = read_traffic(directory / "logs", run.events);
  controle::write_whole(directory / "report.html", page_with(run, traffic));
}

}  // namespace animado::report
