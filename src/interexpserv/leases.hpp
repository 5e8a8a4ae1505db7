// Who offers what, where: the table of services. An entry is a lease held by a connection, and ends with it.
// Several servers may offer one name; they are found in turn.
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
  int64_t restarts = 0;  // of the name: leases that took the place of one that had ended
};

class Leases {
 public:
  void grant(Lease lease);  // replaces an older one of that name and socket: the same server again
  const Lease& take_turn(const std::string& name);  // each of that name after the other; throws unavailable
  std::vector<Lease> list() const;                  // by name, then in the order in which they came
  void end(uint64_t connection);

 private:
  struct Name {
    std::vector<Lease> leases;
    size_t next = 0;
    int64_t ended = 0;  // without a successor yet
    int64_t restarts = 0;
  };
  [[noreturn]] void refuse_unknown(const std::string& name) const;

  std::map<std::string, Name> names_;  // kept when the last lease has ended, to count restarts
};

}  // namespace animado::interexpserv
