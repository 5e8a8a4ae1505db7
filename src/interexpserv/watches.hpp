// Who is told of which changes. A watcher that does not take what it is sent loses what comes next, and
// learns of it as soon as it reads again; so it costs nobody else time or memory.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>

namespace animado::interexpserv {

class Watches {
 public:
  // What was not sent to a watcher.
  struct Gap {
    int64_t first_lost = 0;  // sequence
    int64_t since = 0;       // version up to which it was told everything
  };

  void add(uint64_t connection, std::string prefix) {
    watchers_[connection].prefixes.insert(std::move(prefix));
  }
  void remove(uint64_t connection, const std::string& prefix);
  void end(uint64_t connection) { watchers_.erase(connection); }

  // Numbers a change and offers it to all whom it concerns. `send` returns false when the watcher has too
  // much unread.
  void tell(const std::string& name, int64_t version, const std::function<bool(uint64_t connection)>& send);
  int64_t sequence() const { return sequence_; }  // of the last change

  // The watcher has read everything: what it lost meanwhile, if anything.
  std::optional<Gap> caught_up(uint64_t connection);

 private:
  struct Watcher {
    std::set<std::string> prefixes;
    std::optional<Gap> gap;
  };
  std::map<uint64_t, Watcher> watchers_;
  int64_t sequence_ = 0;
};

}  // namespace animado::interexpserv
