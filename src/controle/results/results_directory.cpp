#include "controle/results/results_directory.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <stdio.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <string>
#include <system_error>

#include "base/error.hpp"

namespace animado::controle {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMark = "summary.json";  // every directory of results holds it

[[noreturn]] void fail(const fs::path& path, std::string_view what, const std::string& cause) {
  throw Error(Code::unavailable, fmt::format("{}: {}", what, cause), path.string(),
              "give a directory that can be written with --out");
}

// Absolute, links followed, without a slash at the end.
fs::path resolved(const fs::path& path) {
  fs::path whole = fs::weakly_canonical(fs::absolute(path)).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

void refuse_unless_replaceable(const fs::path& path) {
  if (!fs::exists(path)) return;
  if (fs::is_directory(path) && (fs::is_empty(path) || fs::exists(path / kMark))) return;
  throw Error(Code::refused, "it is there already and does not hold results, which alone are replaced",
              path.string(), "give another directory with --out, or move this one away");
}

std::string partial_prefix(const fs::path& final_path) {
  return fmt::format(".{}.partial-", final_path.filename().string());
}

bool is_alive(pid_t pid) {
  return ::kill(pid, 0) == 0 || errno == EPERM;
}

void remove_abandoned(const fs::path& final_path) {
  const std::string prefix = partial_prefix(final_path);
  for (const fs::directory_entry& entry : fs::directory_iterator(final_path.parent_path())) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(prefix)) continue;
    pid_t pid = 0;
    const char* end = name.data() + name.size();
    const auto [stop, status] = std::from_chars(name.data() + prefix.size(), end, pid);
    if (status != std::errc() || stop != end) continue;
    if (!is_alive(pid) || pid == ::getpid()) fs::remove_all(entry.path());
  }
}

void sync_directory(const fs::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  // EINVAL: a file system that has nothing to sync.
  const bool synced = descriptor >= 0 && (::fsync(descriptor) == 0 || errno == EINVAL);
  const std::string cause = std::strerror(errno);
  if (descriptor >= 0) ::close(descriptor);
  if (!synced) fail(path, "cannot be brought to the disk", cause);
}

}  // namespace

ResultsDirectory::ResultsDirectory(const fs::path& final_path) try : final_(resolved(final_path)) {
  refuse_unless_replaceable(final_);
  fs::create_directories(final_.parent_path());
  remove_abandoned(final_);
  partial_ = final_.parent_path() / fmt::format("{}{}", partial_prefix(final_), ::getpid());
  fs::create_directories(partial_ / "logs");
} catch (const fs::filesystem_error& error) {
  fail(final_path, "results cannot be written there", error.code().message());
}

void ResultsDirectory::commit() try {
  sync_directory(partial_);
  refuse_unless_replaceable(final_);
  if (!fs::exists(final_)) {
    fs::rename(partial_, final_);
  } else if (::renameat2(AT_FDCWD, partial_.c_str(), AT_FDCWD, final_.c_str(), RENAME_EXCHANGE) == 0) {
    fs::remove_all(partial_);
  } else {  // a file system that cannot exchange: for a moment neither is there
    const fs::path old = fmt::format("{}-old", partial_.string());
    fs::rename(final_, old);
    fs::rename(partial_, final_);
    fs::remove_all(old);
  }
  sync_directory(final_.parent_path());
} catch (const fs::filesystem_error& error) {
  fail(final_, "results cannot be put there", error.code().message());
}

}  // namespace animado::controle
