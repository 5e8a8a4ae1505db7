#include "animado/supervisor.hpp"

#include <poll.h>
#include <signal.h>
#include <sys/signalfd.h>

#include <ranges>

#include "animado/log_tail.hpp"
#include "base/error.hpp"

namespace animado {

namespace {

constexpr int kPatience_ms = 2000;  // for a service to end by itself
constexpr size_t kLastLines = 10;

}  // namespace

Supervisor::Supervisor(std::filesystem::path logs) : logs_(std::move(logs)) {
  sigset_t taken;
  sigemptyset(&taken);
  sigaddset(&taken, SIGINT);
  sigaddset(&taken, SIGTERM);
  sigprocmask(SIG_BLOCK, &taken, nullptr);
  signals_.reset(signalfd(-1, &taken, SFD_CLOEXEC | SFD_NONBLOCK));
}

Supervisor::~Supervisor() {
  stop();
}

void Supervisor::start(const std::string& name, std::vector<std::string> arguments) {
  Service service{name, std::move(arguments), {}, {}, {}};
  service.process = Child(service.arguments, logs_ / (name + ".log"));
  services_.push_back(std::move(service));
}

void Supervisor::wait(std::span<const int> descriptors, int timeout_ms) {
  std::vector<pollfd> awaited{{signals_.get(), POLLIN, 0}};
  for (const Service& service : services_) awaited.push_back({service.process.pidfd(), POLLIN, 0});
  for (int descriptor : descriptors) awaited.push_back({descriptor, POLLIN, 0});
  if (poll(awaited.data(), awaited.size(), time_to_next_restart_ms(timeout_ms)) < 0)
    return;  // EINTR: look again

  if (awaited[0].revents != 0) take_signals();
  for (size_t i = 0; i < services_.size(); ++i) {
    if (awaited[i + 1].revents != 0) take_death(services_[i]);
  }
  restart_what_is_due();
}

void Supervisor::take_signals() {
  signalfd_siginfo info;
  while (read(signals_.get(), &info, sizeof info) == sizeof info) ++interruptions_;
}

void Supervisor::take_death(Service& service) {
  const Death death{service.name, service.process.pid(), service.process.reap()};
  const auto now = std::chrono::steady_clock::now();
  if (on_death) on_death(death);
  if (const auto pause = service.policy.died(now)) {
    service.restart_at = now + *pause;
    return;
  }
  const auto log = logs_ / (service.name + ".log");
  throw Error(Code::unavailable,
              fmt::format("{} died {} times in {} s; its last lines:\n{}", service.name, kMostDeaths,
                          kDeathWindow.count(), last_lines(log, kLastLines)),
              log.string(), "read its log; a service that dies at its start lacks something of this machine");
}

void Supervisor::restart_what_is_due() {
  const auto now = std::chrono::steady_clock::now();
  for (Service& service : services_) {
    if (!service.restart_at || *service.restart_at > now) continue;
    service.restart_at.reset();
    service.process = Child(service.arguments, logs_ / (service.name + ".log"));
  }
}

int Supervisor::time_to_next_restart_ms(int timeout_ms) const {
  const auto now = std::chrono::steady_clock::now();
  for (const Service& service : services_) {
    if (!service.restart_at) continue;
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(*service.restart_at - now).count();
    const int left_ms = static_cast<int>(std::max<int64_t>(left, 0));
    timeout_ms = timeout_ms < 0 ? left_ms : std::min(timeout_ms, left_ms);
  }
  return timeout_ms;
}

void Supervisor::move_logs(const std::filesystem::path& logs) {
  for (Service& service : services_) {
    std::ranges::replace(service.arguments, (logs_ / (service.name + ".log")).string(),
                         (logs / (service.name + ".log")).string());
  }
  logs_ = logs;
}

void Supervisor::stop() {
  for (Service& service : std::views::reverse(services_)) {
    if (!service.process.running()) continue;
    service.process.signal(SIGTERM);
    if (!service.process.wait(kPatience_ms)) service.process.signal(SIGKILL);
    service.process.reap();
  }
  services_.clear();
}

}  // namespace animado
