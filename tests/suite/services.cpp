#include "services.hpp"

#include "rpc/common.hpp"

namespace animado::suite {

namespace fs = std::filesystem;

Services::Services() {
  suite_ = std::make_unique<rpc::SocketSuite>(
      rpc::SocketSuite::Options{.directory = directory(), .client = "test", .trace = "test"});
  for (const char* service : {"interexpserv", "egesp", "fred", "colisao"}) {
    start(service);
    suite_->channel(service).call<rpc::Ping>({});  // waits until it is registered
  }
}

Services::~Services() {
  suite_.reset();
  processes_.clear();
}

void Services::start(const std::string& service) {
  const std::string program = std::string(ANIMADO_BIN_DIR) + "/" + service;
  processes_.emplace(service,
                     Child({program, "--socket-dir", directory(), "--log", directory_ / (service + ".log")},
                           directory_ / (service + ".output")));
}

void Services::restart(const std::string& service, int signal) {
  Child& process = processes_.at(service);
  process.signal(signal);
  process.wait(-1);
  process.reap();
  processes_.erase(service);
  start(service);
  suite_->channel(service).call<rpc::Ping>({});
}

fs::path Services::socket(const std::string& service) {
  if (service == "interexpserv") return directory_ / "interexpserv.sock";
  rpc::Lookup::Request request;
  request.name = service;
  return suite_->channel("interexpserv").call<rpc::Lookup>(request).socket;
}

}  // namespace animado::suite
