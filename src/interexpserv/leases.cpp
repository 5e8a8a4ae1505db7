#include "interexpserv/leases.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/nearest_name.hpp"

namespace animado::interexpserv {

void Leases::grant(Lease lease) {
  if (lease.name.empty() || lease.socket.empty()) {
    throw Error(Code::bad_params, "a service needs a name and a socket",
                lease.name.empty() ? "name" : "socket", "give both");
  }
  leases_[lease.name] = lease;
}

const Lease& Leases::find(const std::string& name) const {
  const auto found = leases_.find(name);
  if (found != leases_.end()) return found->second;
  std::vector<std::string> known;
  for (const auto& [other, lease] : leases_) known.push_back(other);
  const std::string near = nearest_name(name, known);
  throw Error(Code::unavailable, fmt::format("no service `{}` is registered", name), name,
              near.empty() ? fmt::format("start {}", name.empty() ? "one" : name)
                           : fmt::format("start it; `{}` is there", near));
}

std::vector<Lease> Leases::list() const {
  std::vector<Lease> list;
  for (const auto& [name, lease] : leases_) list.push_back(lease);
  return list;
}

void Leases::end(uint64_t connection) {
  std::erase_if(leases_, [&](const auto& entry) { return entry.second.connection == connection; });
}

}  // namespace animado::interexpserv
