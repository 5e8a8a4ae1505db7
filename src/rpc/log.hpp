// A module's log: a line a message, `time level module trace message`. Lines are collected and written out a
// moment later, many at once: to write one costs a copy, and still they can be followed. Where the disk is
// nearly full only warnings are written further: what is left is for the results.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace spdlog {
class logger;
}

namespace animado::rpc {

enum class LogLevel { info, warning, error, off };

class Log {
 public:
  using Time = std::chrono::steady_clock::time_point;

  using DiskSpace = std::function<std::filesystem::space_info()>;

  Log();  // writes nothing
  // Appends to the file; makes its folder. Throws Code::refused when it cannot be written. disk: of another
  // disk than the file's, for tests.
  Log(std::string_view module, const std::filesystem::path& file, LogLevel level = LogLevel::info,
      DiskSpace disk = {});
  ~Log();

  bool enabled(LogLevel level) const;
  // The text begins with the trace, the run's id and the call's number, as "7f3a#12 ping …"; or with -. A
  // warning is in the file when this returns.
  void write(LogLevel level, std::string_view trace_and_text, Time time = Time::clock::now());
  void info(std::string_view text) { write(LogLevel::info, "- " + std::string(text)); }
  void warn(std::string_view text) { write(LogLevel::warning, "- " + std::string(text)); }
  void format();                         // what was collected, into the file's buffer
  void flush();                          // all of it, to the file
  bool dirty() const { return dirty_; }  // there are lines to flush

 private:
  struct Line {
    LogLevel level;
    Time time;
    size_t end;  // in texts_
  };

  void leave_room();

  std::unique_ptr<spdlog::logger> logger_;
  DiskSpace disk_;
  size_t written_ = 0;  // bytes of texts since somebody looked at the disk
  std::vector<Line> lines_;
  std::string texts_;  // of the lines, one after the other
  bool dirty_ = false;
};

// "2026-11-21T23:00:00.123456Z"
std::string utc_now();

}  // namespace animado::rpc
