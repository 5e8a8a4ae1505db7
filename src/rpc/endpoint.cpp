#include "rpc/endpoint.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "base/error.hpp"

namespace animado::rpc {
namespace {

namespace fs = std::filesystem;

// As many as may wait to be accepted while a long request is served.
constexpr int kBacklog = 64;

sockaddr_un address_of(const fs::path& socket) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string& path = socket.native();
  if (path.size() >= sizeof address.sun_path) {
    throw Error(Code::refused,
                fmt::format("a socket's path has less than {} characters", sizeof address.sun_path), path,
                "set ANIMADO_SOCKET_DIR to a shorter folder");
  }
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  return address;
}

UniqueFd unix_socket() {
  UniqueFd fd(::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (!fd)
    throw Error(Code::limit, fmt::format("no socket: {}", std::strerror(errno)), {},
                "close files, or raise ulimit -n");
  return fd;
}

int try_connect(int fd, const fs::path& socket) {
  const sockaddr_un address = address_of(socket);
  return ::connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address);
}

// A full queue means that somebody listens, and is busy.
bool somebody_listens(const fs::path& socket) {
  const UniqueFd fd = unix_socket();
  return try_connect(fd.get(), socket) == 0 || errno == EAGAIN;
}

// Sockets of a folder are set up and cleared away by one process at a time: one that is bound and does not
// listen yet looks like what a dead process left. A file of its own, since `animado run` locks the folder for
// as long as the run lasts. The kernel lets the lock of a dead process go.
class SocketsLock {
 public:
  explicit SocketsLock(const fs::path& directory)
      : file_(::open((directory / "sockets.lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {
    while (!file_ || flock(file_.get(), LOCK_EX) != 0) {
      if (file_ && errno == EINTR) continue;
      throw Error(Code::refused, fmt::format("cannot lock the sockets' folder: {}", std::strerror(errno)),
                  directory.string(), "set ANIMADO_SOCKET_DIR to a folder of yours");
    }
  }

 private:
  UniqueFd file_;
};

}  // namespace

fs::path socket_directory(std::string_view run) {
  if (const char* given = std::getenv("ANIMADO_SOCKET_DIR"); given && *given) return given;
  if (const char* runtime = std::getenv("XDG_RUNTIME_DIR"); runtime && *runtime)
    return fs::path(runtime) / "animado" / run;
  return fs::temp_directory_path() / fmt::format("animado-{}", getuid()) / run;
}

void prepare_directory(const fs::path& directory) {
  const fs::path parent = directory.parent_path();
  // The folder above ours is made with the same care: it may lie in a temporary folder where everybody can
  // write.
  for (const fs::path& made : {parent, directory}) {
    if (!made.empty() && mkdir(made.c_str(), 0700) != 0 && errno == ENOENT && made == parent)
      fs::create_directories(parent);
  }
  struct stat status {};
  if (lstat(directory.c_str(), &status) != 0 || !S_ISDIR(status.st_mode)) {
    throw Error(Code::refused, "the folder for the sockets cannot be made", directory.string(),
                "set ANIMADO_SOCKET_DIR to a folder of yours");
  }
  if (status.st_uid != getuid() || (status.st_mode & 077) != 0) {
    throw Error(Code::refused, "others can reach the folder for the sockets", directory.string(),
                fmt::format("chmod 700 {} if it is yours, or set ANIMADO_SOCKET_DIR", directory.string()));
  }
}

fs::path socket_path(const fs::path& directory, std::string_view service, pid_t pid) {
  if (service == kWellKnown) return directory / fmt::format("{}.sock", service);
  return directory / fmt::format("{}.{}.sock", service, pid);
}

UniqueFd listen_at(const fs::path& socket) {
  const SocketsLock lock(socket.parent_path());
  if (somebody_listens(socket)) {
    throw Error(Code::conflict, "a process listens there already", socket.string(),
                "stop it first, or set ANIMADO_SOCKET_DIR to another folder");
  }
  const fs::path unready = socket.native() + fmt::format("-{}", getpid());
  const sockaddr_un address = address_of(unready);
  ::unlink(unready.c_str());
  UniqueFd fd = unix_socket();
  if (::bind(fd.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
      ::listen(fd.get(), kBacklog) != 0 || ::rename(unready.c_str(), socket.c_str()) != 0) {
    throw Error(Code::refused, fmt::format("cannot listen: {}", std::strerror(errno)), socket.string(),
                "set ANIMADO_SOCKET_DIR to a folder of yours");
  }
  return fd;
}

void remove_stale(const fs::path& directory, std::string_view service) {
  const SocketsLock lock(directory);
  const std::string prefix = fmt::format("{}.", service);
  std::error_code gone;
  for (const auto& file : fs::directory_iterator(directory, gone)) {
    const bool ours = file.path().filename().string().starts_with(prefix) && file.is_socket(gone);
    if (ours && !somebody_listens(file.path())) fs::remove(file.path(), gone);
  }
}

UniqueFd connect_to(const fs::path& socket) {
  UniqueFd fd = unix_socket();
  if (try_connect(fd.get(), socket) != 0) return {};
  if (!peer_is_ours(fd.get())) {
    throw Error(Code::refused, "the process that listens there is another user's", socket.string(),
                "set ANIMADO_SOCKET_DIR to a folder of yours");
  }
  return fd;
}

bool peer_is_ours(int fd) {
  ucred peer{};
  socklen_t size = sizeof peer;
  return getsockopt(fd, SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 && peer.uid == getuid();
}

}  // namespace animado::rpc
