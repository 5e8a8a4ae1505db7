// What this server keeps between two requests: prepared systems of every kind, each under a number that the
// connection owns which asked for it. The number ends with its release, with the connection, or with this
// process; it is never used twice.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string_view>

#include "base/error.hpp"

namespace animado::egesp {

inline constexpr size_t kLargestPrepared = size_t{1} << 30;  // bytes that one connection may keep here

// A prepared system of any kind.
class Kept {
 public:
  virtual ~Kept() = default;
  virtual size_t bytes() const = 0;
};

class Handles {
 public:
  // Throws limit when the owner keeps too much already.
  int64_t keep(uint64_t owner, std::unique_ptr<Kept> system);

  // The owner's prepared system of that kind, named in the error. Throws unknown_handle.
  template <class Kind>
  Kind& find(uint64_t owner, int64_t handle, std::string_view kind) {
    auto* found = dynamic_cast<Kind*>(find_any(owner, handle));
    if (found == nullptr) refuse(handle, kind);
    return *found;
  }

  bool release(uint64_t owner, int64_t handle);  // false when there is none: a repeated request
  void end(uint64_t owner);                      // its connection is gone

 private:
  using Owned = std::map<int64_t, std::unique_ptr<Kept>>;

  // Numbers go on from the time at the start: a client of several handles that comes back to a restarted
  // server must not meet one of them under the number of another.
  static int64_t microseconds_now() {
    return std::chrono::duration_cast<std::chrono::microseconds>(
               std::chrono::system_clock::now().time_since_epoch())
        .count();
  }

  Kept* find_any(uint64_t owner, int64_t handle) const;
  [[noreturn]] static void refuse(int64_t handle, std::string_view kind);
  static size_t bytes(const Owned& owned);

  std::map<uint64_t, Owned> owners_;
  int64_t last_ = microseconds_now();
};

}  // namespace animado::egesp
