#include "rpc/log.hpp"

#include <fmt/format.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <ctime>

#include "base/error.hpp"

namespace animado::rpc {
namespace {

spdlog::level::level_enum level_of(LogLevel level) {
  switch (level) {
    case LogLevel::info:
      return spdlog::level::info;
    case LogLevel::warning:
      return spdlog::level::warn;
    case LogLevel::error:
      return spdlog::level::err;
    case LogLevel::off:
      return spdlog::level::off;
  }
  return spdlog::level::off;
}

}  // namespace

Log::Log() = default;
Log::~Log() = default;

Log::Log(std::string_view module, const std::filesystem::path& file, LogLevel level) {
  try {
    auto sink = std::make_shared<spdlog::sinks::basic_file_sink_st>(file.string());
    logger_ = std::make_unique<spdlog::logger>(std::string(module), std::move(sink));
  } catch (const spdlog::spdlog_ex& error) {
    throw Error(Code::refused, fmt::format("the log cannot be written: {}", error.what()), file.string(),
                "give another file with --log");
  }
  logger_->set_formatter(std::make_unique<spdlog::pattern_formatter>("%Y-%m-%dT%H:%M:%S.%fZ %l %n %v",
                                                                     spdlog::pattern_time_type::utc));
  logger_->set_level(level_of(level));
}

bool Log::enabled(LogLevel level) const {
  return logger_ && logger_->should_log(level_of(level));
}

void Log::write(LogLevel level, std::string_view trace, std::string_view text) {
  if (!enabled(level)) return;
  logger_->log(level_of(level), "{} {}", trace, text);
  dirty_ = true;
}

void Log::flush() {
  if (!dirty_) return;
  logger_->flush();
  dirty_ = false;
}

std::string utc_now() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const auto micros = std::chrono::duration_cast<std::chrono::microseconds>(now).count();
  const std::time_t seconds = micros / 1000000;
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:06}Z", parts.tm_year + 1900, parts.tm_mon + 1,
                     parts.tm_mday, parts.tm_hour, parts.tm_min, parts.tm_sec, micros % 1000000);
}

}  // namespace animado::rpc
