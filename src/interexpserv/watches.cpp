#include "interexpserv/watches.hpp"

#include <algorithm>
#include <utility>

#include "interexpserv/names.hpp"

namespace animado::interexpserv {

void Watches::remove(uint64_t connection, const std::string& prefix) {
  const auto watcher = watchers_.find(connection);
  if (watcher != watchers_.end()) watcher->second.prefixes.erase(prefix);
}

void Watches::tell(const std::string& name, int64_t version,
                   const std::function<bool(uint64_t connection)>& send) {
  ++sequence_;
  const auto covers = [&](const std::string& prefix) { return is_within(name, prefix); };
  for (auto& [connection, watcher] : watchers_) {
    if (watcher.gap || std::ranges::none_of(watcher.prefixes, covers)) continue;
    if (!send(connection)) watcher.gap = Gap{sequence_, version - 1};
  }
}

std::optional<Watches::Gap> Watches::caught_up(uint64_t connection) {
  const auto watcher = watchers_.find(connection);
  return watcher == watchers_.end() ? std::nullopt : std::exchange(watcher->second.gap, std::nullopt);
}

}  // namespace animado::interexpserv
