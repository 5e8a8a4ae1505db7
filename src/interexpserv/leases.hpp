// Who offers what, where: the table of services. An entry is a lease held by a connection, and ends with it.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace animado::interexpserv {

struct Lease {
  std::string name, socket, version, since;  // since: UTC, ISO 8601
  int64_t pid = 0;
  uint64_t connection = 0;
};

class Leases {
 public:
  void grant(Lease lease);                           // replaces an older one of that name
  const Lease& find(const std::string& name) const;  // throws unavailable
  std::vector<Lease> list() const;                   // by name
  void end(uint64_t connection);

 private:
  std::map<std::string, Lease> leases_;
};

}  // namespace animado::interexpserv
