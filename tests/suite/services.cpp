#include "services.hpp"

#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>

#include "rpc/common.hpp"

namespace animado::suite {

namespace fs = std::filesystem;

Services::Services() {
  std::string name = (fs::temp_directory_path() / "animado-services-XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error("no temporary directory");
  directory_ = name;
  suite_ = std::make_unique<rpc::SocketSuite>(rpc::SocketSuite::Options{.directory = directory_, .client = "test", .trace = "test"});
  for (const char* service : {"interexpserv", "egesp", "fred", "colisao"}) {
    start(service);
    suite_->channel(service).call<rpc::Ping>({});  // waits until it is registered
  }
}

Services::~Services() {
  for (const auto& [service, pid] : processes_) kill(pid, SIGTERM);
  for (const auto& [service, pid] : processes_) waitpid(pid, nullptr, 0);
  fs::remove_all(directory_);
}

void Services::start(const std::string& service) {
  const std::string program = std::string(ANIMADO_BIN_DIR) + "/" + service, directory = directory_.string(),
                    log = (directory_ / (service + ".log")).string();
  const char* arguments[] = {program.c_str(), "--socket-dir", directory.c_str(), "--log", log.c_str(), nullptr};
  pid_t pid = 0;
  if (posix_spawn(&pid, program.c_str(), nullptr, nullptr, const_cast<char**>(arguments), environ) != 0) {
    throw std::runtime_error("cannot start " + program);
  }
  processes_[service] = pid;
}

fs::path Services::socket(const std::string& service) {
  if (service == "interexpserv") return directory_ / "interexpserv.sock";
  rpc::Lookup::Request request;
  request.name = service;
  return suite_->channel("interexpserv").call<rpc::Lookup>(request).socket;
}

bool Services::is_running(const std::string& service) const { return waitpid(pid(service), nullptr, WNOHANG) == 0; }

}  // namespace animado::suite
