#include "rpc/directory_watch.hpp"

#include <sys/inotify.h>

#include <array>

#include "base/error.hpp"

namespace animado::rpc {

DirectoryWatch::DirectoryWatch(const std::filesystem::path& directory)
    : fd_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
  // Sockets are renamed to their names when they listen (endpoint.cpp).
  if (!fd_ || inotify_add_watch(fd_.get(), directory.c_str(), IN_MOVED_TO) < 0) {
    throw Error(Code::unavailable, "the folder of the services' sockets is not there, or cannot be watched",
                directory.string(),
                "animado run starts the services; fs.inotify.max_user_instances limits the watches");
  }
}

void DirectoryWatch::clear() {
  std::array<char, 4096> events;
  while (::read(fd_.get(), events.data(), events.size()) > 0) {
  }
}

}  // namespace animado::rpc
