#include "animado/running_suite.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

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
  const char* const given = std::getenv("ANIMADO_SOCKET_DIR");
  return given && *given;
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

// In the folder of a run that `animado` started. Folders without it, of services that somebody started by
// hand, are not ours to remove.
constexpr std::string_view kMark = "animado.run";

// The folder, locked until this is closed; empty when somebody else holds it. The kernel lets go of what a
// killed process held.
rpc::UniqueFd lock(const fs::path& directory) {
  rpc::UniqueFd held(open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (held && flock(held.get(), LOCK_EX | LOCK_NB) != 0) held.reset();
  return held;
}

// What runs left that were killed. Looks for the mark also before it locks: a run that has just made its
// folder is about to.
void remove_abandoned(const fs::path& parent) {
  std::error_code gone;
  for (const auto& entry : fs::directory_iterator(parent, gone)) {
    const fs::path mark = entry.path() / kMark;
    if (!fs::exists(mark, gone)) continue;
    const rpc::UniqueFd held = lock(entry.path());
    if (held && fs::exists(mark, gone)) fs::remove_all(entry.path(), gone);
  }
}

}  // namespace

SocketDirectory::SocketDirectory(const std::string& run) : path_(rpc::socket_directory(fitting(run))) {
  if (!is_given()) remove_abandoned(path_.parent_path());
  made_here_ = !fs::exists(path_);
  rpc::prepare_directory(path_);
  lock_ = lock(path_);
  if (!lock_ || is_alive(path_)) {
    throw Error(Code::conflict, "a suite is running there already", path_.string(),
                "give the run another name with --run");
  }
  const std::ofstream mark(path_ / kMark);
}

SocketDirectory::~SocketDirectory() {
  std::error_code ignored;  // what is left is cleared away by the next run
  made_here_ ? fs::remove_all(path_, ignored) : fs::remove(path_ / kMark, ignored);
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
