#include "animado/child.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <cstring>

#include "base/error.hpp"

namespace animado {

namespace {

// Between fork and exec only calls that are safe there: no allocation, no exceptions.
[[noreturn]] void become(char* const* arguments, pid_t parent, int output, std::span<const int> kept_fds,
                         int failure) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);  // it died before the line above
  setpgid(0, 0);                        // out of reach of the terminal's Ctrl-C
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  dup2(nothing, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  for (const int kept : kept_fds) fcntl(kept, F_SETFD, 0);
  execv(arguments[0], arguments);
  const int error = errno;
  [[maybe_unused]] const auto written = write(failure, &error, sizeof error);
  _exit(127);
}

}  // namespace

Child::Child(const std::vector<std::string>& arguments, const std::filesystem::path& output,
             std::span<const int> kept_fds) {
  assert(!arguments.empty());
  std::vector<char*> raw;
  for (const std::string& argument : arguments) raw.push_back(const_cast<char*>(argument.c_str()));
  raw.push_back(nullptr);
  const rpc::UniqueFd log(open(output.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600));
  if (!log) throw Error(Code::unavailable, "cannot write " + output.string() + ": " + std::strerror(errno));

  // The child reports an exec that failed through a pipe that a successful exec closes.
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    throw Error(Code::unavailable, std::string("no pipe: ") + std::strerror(errno));
  const rpc::UniqueFd report(ends[0]);
  rpc::UniqueFd failure(ends[1]);
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ < 0) throw Error(Code::unavailable, std::string("no new process: ") + std::strerror(errno));
  if (pid_ == 0) become(raw.data(), parent, log.get(), kept_fds, failure.get());
  pidfd_.reset(static_cast<int>(syscall(SYS_pidfd_open, pid_, 0)));
  failure.reset();

  int error = 0;
  if (read(report.get(), &error, sizeof error) == sizeof error) {
    reap();
    throw Error(Code::unavailable, "cannot start " + arguments[0] + ": " + std::strerror(error), arguments[0],
                "the five programs are looked for beside `animado`: build all of them (scripts/build release "
                "programs)");
  }
}

Child& Child::operator=(Child&& other) noexcept {
  std::swap(pid_, other.pid_);
  std::swap(pidfd_, other.pidfd_);
  return *this;
}

Child::~Child() {
  if (!running()) return;
  signal(SIGKILL);
  reap();
}

void Child::signal(int number) const {
  if (running()) syscall(SYS_pidfd_send_signal, pidfd_.get(), number, nullptr, 0);
}

bool Child::wait(int timeout_ms) const {
  if (!running()) return true;
  pollfd ended{pidfd_.get(), POLLIN, 0};
  return poll(&ended, 1, timeout_ms) == 1;
}

int Child::reap() {
  assert(running());
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pidfd_.reset();
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace animado
