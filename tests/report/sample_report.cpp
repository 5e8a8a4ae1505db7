// sample_report FILE BODIES FRAMES: the page of a run that nobody simulated, for tests/web.
#include "base/error.hpp"
#include "controle/results/output_file.hpp"
#include "report/page.hpp"
#include "tests/report/sample_run.hpp"

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  try {
    const auto run = animado::report::sample_run(std::stoul(argv[2]), std::stoul(argv[3]));
    animado::controle::write_whole(argv[1], animado::report::page_with(run, {}));
  } catch (const std::exception& error) {
    fmt::print(stderr, "sample_report: {}\n", error.what());
    return 1;
  }
}
