#include "rpc/log.hpp"

#include <fmt/format.h>
#include <spdlog/formatter.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <ctime>

#include "base/error.hpp"

namespace animado::rpc {
namespace {

constexpr size_t kMaxCollected = 16 << 10;   // bytes: they stay in the nearest caches
constexpr size_t kBetweenLooks = 256 << 10;  // bytes, from one look at the disk to the next
constexpr uintmax_t kMostLeft = 1 << 30;     // bytes that are left to others, or a part of a small disk:
constexpr uintmax_t kSmallPart = 20;

std::string date_text(std::time_t second) {
  std::tm parts{};
  gmtime_r(&second, &parts);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}", parts.tm_year + 1900, parts.tm_mon + 1,
                     parts.tm_mday, parts.tm_hour, parts.tm_min, parts.tm_sec);
}

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

// `time level module text`. The date is written once a second and kept: with spdlog's own pattern a line
// takes several times as long.
class LineFormatter final : public spdlog::formatter {
 public:
  void format(const spdlog::details::log_msg& line, spdlog::memory_buf_t& out) override {
    const auto since_epoch = line.time.time_since_epoch();
    set_time(std::chrono::duration_cast<std::chrono::microseconds>(since_epoch).count());
    const auto level = spdlog::level::to_string_view(line.level);
    append(out, std::string_view(time_), text_of(level), text_of(line.logger_name), text_of(line.payload));
  }
  std::unique_ptr<formatter> clone() const override { return std::make_unique<LineFormatter>(); }

 private:
  static std::string_view text_of(spdlog::string_view_t text) { return {text.data(), text.size()}; }

  void set_time(int64_t micros) {
    if (micros / 1000000 != second_) {
      second_ = micros / 1000000;
      time_ = date_text(second_) + ".000000Z";
    }
    int64_t digits = micros % 1000000;
    for (size_t at = time_.size() - 2; time_[at] != '.'; --at, digits /= 10)
      time_[at] = static_cast<char>('0' + digits % 10);
  }

  // The parts with blanks between them, and the end of the line.
  template <class... Parts>
  static void append(spdlog::memory_buf_t& out, const Parts&... parts) {
    const size_t begin = out.size();
    out.resize(begin + (parts.size() + ...) + sizeof...(parts));
    char* at = out.data() + begin;
    ((at = std::copy(parts.begin(), parts.end(), at), *at++ = ' '), ...);
    at[-1] = '\n';
  }

  int64_t second_ = -1;
  std::string time_;
};

}  // namespace

Log::Log() = default;
Log::~Log() {
  flush();
}

Log::Log(std::string_view module, const std::filesystem::path& file, LogLevel level, DiskSpace disk)
    : disk_(std::move(disk)) {
  if (!disk_) {
    disk_ = [file] {
      std::error_code unknown;  // then all is −1: more than enough
      return std::filesystem::space(file, unknown);
    };
  }
  try {
    auto sink = std::make_shared<spdlog::sinks::basic_file_sink_st>(file.string());
    logger_ = std::make_unique<spdlog::logger>(std::string(module), std::move(sink));
  } catch (const spdlog::spdlog_ex& error) {
    throw Error(Code::refused, fmt::format("the log cannot be written: {}", error.what()), file.string(),
                "give another file with --log");
  }
  logger_->set_formatter(std::make_unique<LineFormatter>());
  logger_->set_level(level_of(level));
}

bool Log::enabled(LogLevel level) const {
  return logger_ && logger_->should_log(level_of(level));
}

void Log::write(LogLevel level, std::string_view trace_and_text, Time time) {
  if (!enabled(level)) return;
  texts_ += trace_and_text;
  lines_.push_back({level, time, texts_.size()});
  dirty_ = true;
  if (level != LogLevel::info) return flush();
  if (texts_.size() > kMaxCollected) format();
}

void Log::format() {
  if (lines_.empty()) return;
  const auto date = std::chrono::system_clock::now();
  const auto now = Time::clock::now();
  const char* text = texts_.data();
  for (const Line& line : lines_) {
    const char* end = texts_.data() + line.end;
    const spdlog::string_view_t shown(text, static_cast<size_t>(end - text));
    logger_->log(date - (now - line.time), {}, level_of(line.level), shown);
    text = end;
  }
  written_ += texts_.size();
  lines_.clear();
  texts_.clear();
  leave_room();
}

void Log::leave_room() {
  if (written_ < kBetweenLooks) return;
  written_ = 0;
  const auto disk = disk_();
  if (disk.available >= std::min(kMostLeft, disk.capacity / kSmallPart) || !enabled(LogLevel::info)) return;
  logger_->set_level(spdlog::level::warn);
  warn(fmt::format("only {} MiB are left on this disk: messages are not logged from here on",
                   disk.available >> 20));
}

void Log::flush() {
  if (!dirty_) return;
  format();
  logger_->flush();
  dirty_ = false;
}

std::string utc_now() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const auto micros = std::chrono::duration_cast<std::chrono::microseconds>(now).count();
  return fmt::format("{}.{:06}Z", date_text(micros / 1000000), micros % 1000000);
}

}  // namespace animado::rpc
