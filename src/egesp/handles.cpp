#include "egesp/handles.hpp"

#include <fmt/format.h>

namespace animado::egesp {

int64_t Handles::keep(uint64_t owner, std::unique_ptr<Kept> system) {
  Owned& owned = owners_[owner];
  if (bytes(owned) + system->bytes() > kLargestPrepared) {
    throw Error(Code::limit,
                fmt::format("{} prepared systems and this one hold more than {} bytes", owned.size(),
                            kLargestPrepared),
                {}, "release what is not needed any more");
  }
  owned.emplace(++last_, std::move(system));
  return last_;
}

bool Handles::release(uint64_t owner, int64_t handle) {
  const auto owned = owners_.find(owner);
  return owned != owners_.end() && owned->second.erase(handle) == 1;
}

void Handles::end(uint64_t owner) {
  owners_.erase(owner);
}

Kept* Handles::find_any(uint64_t owner, int64_t handle) const {
  const auto owned = owners_.find(owner);
  if (owned == owners_.end()) return nullptr;
  const auto entry = owned->second.find(handle);
  return entry == owned->second.end() ? nullptr : entry->second.get();
}

void Handles::refuse(int64_t handle, std::string_view kind) {
  throw Error(Code::unknown_handle, fmt::format("this connection holds no {} {}", kind, handle), "handle",
              "prepare it again: a handle ends with its connection, its release, or a restart of egesp");
}

size_t Handles::bytes(const Owned& owned) {
  size_t sum = 0;
  for (const auto& [handle, system] : owned) sum += system->bytes();
  return sum;
}

}  // namespace animado::egesp
