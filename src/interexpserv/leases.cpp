#include "interexpserv/leases.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/nearest_name.hpp"

namespace animado::interexpserv {
namespace {

constexpr size_t kMaxNames = 256;  // of services; a suite has four

}  // namespace

void Leases::grant(Lease lease) {
  if (lease.name.empty() || lease.socket.empty()) {
    throw Error(Code::bad_params, "a service needs a name and a socket",
                lease.name.empty() ? "name" : "socket", "give both");
  }
  if (names_.size() == kMaxNames)
    std::erase_if(names_, [](const auto& entry) { return entry.second.leases.empty(); });
  if (names_.size() == kMaxNames && !names_.contains(lease.name)) {
    throw Error(Code::limit, fmt::format("there are {} names of services already", kMaxNames), lease.name,
                "offer it under a name that is known");
  }
  Name& name = names_[lease.name];
  const auto same = std::ranges::find(name.leases, lease.socket, &Lease::socket);
  if (same != name.leases.end()) {
    *same = std::move(lease);
    return;
  }
  if (name.ended > 0) {
    --name.ended;
    ++name.restarts;
  }
  name.leases.push_back(std::move(lease));
}

const Lease& Leases::take_turn(const std::string& wanted) {
  const auto found = names_.find(wanted);
  if (found == names_.end() || found->second.leases.empty()) refuse_unknown(wanted);
  Name& name = found->second;
  return name.leases[name.next++ % name.leases.size()];
}

void Leases::refuse_unknown(const std::string& name) const {
  std::vector<std::string> known;
  for (const auto& [other, entry] : names_) {
    if (!entry.leases.empty()) known.push_back(other);
  }
  const std::string near = nearest_name(name, known);
  throw Error(Code::unavailable, fmt::format("no service `{}` is registered", name), name,
              near.empty() ? fmt::format("start {}", name.empty() ? "one" : name)
                           : fmt::format("start it; `{}` is there", near));
}

std::vector<Lease> Leases::list() const {
  std::vector<Lease> list;
  for (const auto& [name, entry] : names_) {
    for (Lease lease : entry.leases) {
      lease.restarts = entry.restarts;
      list.push_back(std::move(lease));
    }
  }
  return list;
}

void Leases::end(uint64_t connection) {
  for (auto& [name, entry] : names_) {
    entry.ended += static_cast<int64_t>(
        std::erase_if(entry.leases, [&](const Lease& lease) { return lease.connection == connection; }));
  }
}

}  // namespace animado::interexpserv
