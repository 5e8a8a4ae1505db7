// animado log: a module's log, in colours, and what is added to it.
#include <poll.h>
#include <unistd.h>

#include <fstream>

#include "animado/commands.hpp"
#include "animado/log_colours.hpp"
#include "console/terminal.hpp"

namespace animado {

namespace {

constexpr int kLookAgain_ms = 50;  // as often as a module writes its lines out

struct LogOptions {
  std::string file;
  bool follow = false;
};

// A log that is followed may not be there yet. It stays open: its folder is renamed when the run has ended.
std::ifstream opened(const LogOptions& options) {
  std::ifstream file(options.file);
  while (!file && options.follow) {
    poll(nullptr, 0, kLookAgain_ms);
    file.open(options.file);
  }
  if (!file)
    throw Error(Code::unavailable, "there is no log", options.file, "the logs are in runs/<scene>/logs");
  return file;
}

void print_line(const std::string& line, bool colours) {
  fmt::print("{}\n", colours ? coloured_log_line(line) : line);
}

// The next line, once its end is there. False when there is none.
bool next_line(std::ifstream& file, std::string& begun, std::string& line) {
  std::getline(file, line);
  begun += line;
  if (file.eof()) {  // it ends in the middle of a line, which goes on later
    file.clear();
    return false;
  }
  line = std::move(begun);
  begun.clear();
  return true;
}

// A run writes more lines than a terminal shows. Who follows it there wants to see what happens now: what
// nobody could read any more is left out.
void catch_up(std::ifstream& file, std::string& begun) {
  constexpr std::streamoff kFarBehind_bytes = 256 << 10, kShown_bytes = 16 << 10;
  const auto here = file.tellg();
  file.seekg(0, std::ios::end);
  const auto end = file.tellg();
  if (end - here < kFarBehind_bytes) {
    file.seekg(here);
    return;
  }
  file.seekg(end - kShown_bytes);
  std::getline(file, begun);  // from the middle of a line
  begun.clear();
  fmt::print("… {} kB are left out\n", (end - kShown_bytes - here) >> 10);
}

// Some lines. False when it has come to the file's end.
bool print_lines(std::ifstream& file, std::string& begun, bool colours) {
  constexpr int kAtOnce = 1000;
  std::string line;
  for (int lines = 0; lines < kAtOnce; ++lines) {
    if (!next_line(file, begun, line)) return false;
    print_line(line, colours);
  }
  return true;
}

void show(const LogOptions& options) {
  std::ifstream file = opened(options);
  const bool colours = shows_colours(STDOUT_FILENO);
  const bool live = options.follow && is_terminal(STDOUT_FILENO);
  std::string begun;
  for (bool open = true; open;) {
    if (live) catch_up(file, begun);
    const bool more = print_lines(file, begun, colours);
    std::fflush(stdout);
    if (!more && options.follow) poll(nullptr, 0, kLookAgain_ms);
    open = more || options.follow;
  }
  if (!begun.empty()) print_line(begun, colours);
}

}  // namespace

void add_log_command(CommandLine& line) {
  const auto options = std::make_shared<LogOptions>();
  CLI::App& command = add_command(line, "log", "Print a module's log in colours",
                                  "  animado log runs/colisao/logs/egesp.log\n"
                                  "  animado log --follow runs/colisao/logs/fred.log    until Ctrl-C\n\n"
                                  "Into a pipe, or with NO_COLOR set, the lines come as they are.\n");
  command.add_option("file", options->file, "The log")->required()->type_name(kFileType);
  command.add_flag("--follow", options->follow, "Wait for the file, and for what is added to it");
  command.callback([options] { show(*options); });
}

}  // namespace animado
