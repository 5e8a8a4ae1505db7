#include "rpc/socket_suite.hpp"

#include "rpc/common.hpp"

namespace animado::rpc {

SocketChannel& SocketSuite::channel(std::string_view service) {
  const auto found = channels_.find(service);
  if (found != channels_.end()) return found->second;
  return channels_.try_emplace(std::string(service), *this, std::string(service)).first->second;
}

SocketChannel& SocketSuite::server(const std::string& service, const std::filesystem::path& socket) {
  return servers_.try_emplace(socket, *this, service, socket).first->second;
}

SharedArrays& SocketSuite::arrays() {
  if (!arrays_) arrays_ = std::make_unique<SharedArrays>(channel(kWellKnown));
  return *arrays_;
}

bool SocketSuite::arrays_came_back() {
  SocketChannel& interexpserv = channel(kWellKnown);
  const int64_t before = interexpserv.connections();
  interexpserv.call<Ping>({});
  return interexpserv.connections() != before;
}

}  // namespace animado::rpc
