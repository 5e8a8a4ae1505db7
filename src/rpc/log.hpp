// A module's log: a line a message, `time level module trace message`. Lines are buffered, so that one costs
// less than a microsecond, and written out a moment later, so that they can be followed.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace spdlog {
class logger;
}

namespace animado::rpc {

enum class LogLevel { info, warning, error, off };

class Log {
 public:
  Log();  // writes nothing
  // Appends to the file; makes its folder. Throws Code::refused when it cannot be written.
  Log(std::string_view module, const std::filesystem::path& file, LogLevel level = LogLevel::info);
  ~Log();

  bool enabled(LogLevel level) const;
  // The text begins with the trace, the run's id and the call's number, as "7f3a#12 ping …"; or with -.
  void write(LogLevel level, std::string_view trace_and_text);
  void info(std::string_view text) { write(LogLevel::info, "- " + std::string(text)); }
  void warn(std::string_view text) { write(LogLevel::warning, "- " + std::string(text)); }
  bool dirty() const { return dirty_; }  // there are lines to flush
  void flush();

 private:
  std::unique_ptr<spdlog::logger> logger_;
  bool dirty_ = false;
};

// "2026-11-21T23:00:00.123456Z"
std::string utc_now();

}  // namespace animado::rpc
