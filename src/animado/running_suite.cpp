#include "animado/running_suite.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "base/error.hpp"
#include "rpc/endpoint.hpp"

namespace animado {

namespace {

namespace fs = std::filesystem;

constexpr size_t kLongestRunName = 40;  // a socket's path has at most 107 bytes, whatever the scene is called
constexpr double kComeback_s = 2;  // a service that was killed is back sooner; a suite that ended never is

bool is_alive(const fs::path& directory) {
  return static_cast<bool>(rpc::connect_to(rpc::socket_path(directory, rpc::kWellKnown, 0)));
}

std::string fitting(const std::string& run) {
  std::string name = run.size() <= kLongestRunName ? run : run.substr(run.size() - kLongestRunName);
  std::ranges::replace(name, '/', '-');
  return name;
}

bool is_given() {
  return std::getenv("ANIMADO_SOCKET_DIR") != nullptr;
}

// The directory of the run that started last among those that are alive; empty when there is none.
fs::path latest_run() {
  if (is_given()) return rpc::socket_directory();
  fs::path latest;
  fs::file_time_type latest_time = fs::file_time_type::min();
  std::error_code nothing_there;
  for (const auto& entry : fs::directory_iterator(rpc::socket_directory().parent_path(), nothing_there)) {
    const fs::path socket = rpc::socket_path(entry.path(), rpc::kWellKnown, 0);
    std::error_code gone;
    const auto time = fs::last_write_time(socket, gone);
    if (gone || time <= latest_time || !is_alive(entry.path())) continue;
    latest = entry.path();
    latest_time = time;
  }
  return latest;
}

fs::path chosen_directory(const SuiteChoice& choice) {
  if (!choice.socket_dir.empty()) return choice.socket_dir;
  if (!choice.run.empty()) return rpc::socket_directory(fitting(choice.run));
  return latest_run();
}

// In the folder of a run that `animado` started, which holds it locked as long as it lives.
constexpr std::string_view kLock = "animado.lock";

rpc::UniqueFd open_lock(const fs::path& file, int how = 0) {
  return rpc::UniqueFd(open(file.c_str(), O_RDWR | O_CLOEXEC | how, 0600));
}

// Otherwise it is now, until it is closed.
bool is_locked(const rpc::UniqueFd& file) {
  return flock(file.get(), LOCK_EX | LOCK_NB) != 0;
}

bool is_starting(const fs::path& directory) {
  const rpc::UniqueFd file = open_lock(directory / kLock);
  return file && is_locked(file);
}

// Appears under its name only when it is locked already, so that nobody takes its run for one that is over.
rpc::UniqueFd make_lock(const fs::path& directory) {
  const fs::path unready = directory / fmt::format("{}-{}", kLock, getpid());
  rpc::UniqueFd file = open_lock(unready, O_CREAT);
  if (!file || is_locked(file) || ::rename(unready.c_str(), (directory / kLock).c_str()) != 0) {
    throw Error(Code::refused, fmt::format("the run's folder cannot be locked: {}", std::strerror(errno)),
                directory.string(), "set ANIMADO_SOCKET_DIR to a folder of yours");
  }
  return file;
}

// What runs left that were killed: their folders hold a lock that nobody holds. Folders without one, of
// services that somebody started by hand, are not ours to remove.
void remove_abandoned(const fs::path& parent) {
  std::error_code gone;
  for (const auto& entry : fs::directory_iterator(parent, gone)) {
    const rpc::UniqueFd file = open_lock(entry.path() / kLock);
    if (file && !is_locked(file)) fs::remove_all(entry.path(), gone);
  }
}

}  // namespace

SocketDirectory::SocketDirectory(const std::string& run) : path_(rpc::socket_directory(fitting(run))) {
  if (is_alive(path_) || is_starting(path_)) {
    throw Error(Code::conflict, "a suite is running there already", path_.string(),
                "give the run another name with --run");
  }
  if (!is_given()) remove_abandoned(path_.parent_path());
  made_here_ = !fs::exists(path_);
  rpc::prepare_directory(path_);
  lock_ = make_lock(path_);
}

SocketDirectory::~SocketDirectory() {
  std::error_code ignored;  // what is left is cleared away by the next run
  made_here_ ? fs::remove_all(path_, ignored) : fs::remove(path_ / kLock, ignored);
}

std::unique_ptr<rpc::SocketSuite> find_suite(const SuiteChoice& choice) {
  const fs::path directory = chosen_directory(choice);
  if (directory.empty() || !is_alive(directory)) return nullptr;
  return std::make_unique<rpc::SocketSuite>(rpc::SocketSuite::Options{
      .directory = directory, .client = "animado", .trace = {}, .reconnect_s = kComeback_s});
}

std::unique_ptr<rpc::SocketSuite> connect_to_suite(const SuiteChoice& choice) {
  if (auto suite = find_suite(choice)) return suite;
  const std::string what = choice.run.empty() && choice.socket_dir.empty()
                               ? "no suite is running"
                               : fmt::format("no suite is running in {}", chosen_directory(choice).string());
  throw Error(
      Code::unavailable, what, {},
      "start one with `animado run SCENE`, or with --keep-services to have it stay after the scene's end");
}

}  // namespace animado
