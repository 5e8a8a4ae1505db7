#include "rpc/one_core.hpp"

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <cstddef>

namespace animado::rpc {
namespace {

// A socket's name in the abstract namespace is held by one process at a time, whoever runs it, and is free
// again when that process ends, however it ends. The file descriptor is empty when somebody holds the core.
UniqueFd claim(int core) {
  UniqueFd held(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_un address{AF_UNIX, {}};
  const auto end = fmt::format_to(address.sun_path + 1, "animado/core/{}", core);
  const auto size = static_cast<socklen_t>(end - reinterpret_cast<char*>(&address));
  if (!held || bind(held.get(), reinterpret_cast<const sockaddr*>(&address), size) != 0) held.reset();
  return held;
}

}  // namespace

OneCore::OneCore() {
  CPU_ZERO(&before_);
  if (sched_getaffinity(0, sizeof before_, &before_) != 0 || CPU_COUNT(&before_) < 2) return;
  const int here = std::max(sched_getcpu(), 0);
  for (int k = 0; k < CPU_SETSIZE && !claim_; ++k) {
    const int core = (here + k) % CPU_SETSIZE;
    if (!CPU_ISSET(static_cast<size_t>(core), &before_)) continue;
    claim_ = claim(core);
    if (!claim_) continue;
    cpu_set_t only;
    CPU_ZERO(&only);
    CPU_SET(static_cast<size_t>(core), &only);
    sched_setaffinity(0, sizeof only, &only);
  }
}

OneCore::~OneCore() {
  if (claim_) sched_setaffinity(0, sizeof before_, &before_);
}

}  // namespace animado::rpc
