// A letter each way between a client and a server, in memory that both see, and a bell each way: a call that
// comes and is answered so takes the kernel half as long as over a socket (docs/performance.md). It is for
// short messages, one at a time. The socket that it was asked for over stays: it takes all else, and tells
// when the peer is gone.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "rpc/shared_array.hpp"
#include "rpc/unique_fd.hpp"

namespace animado::rpc {

// One side of a mailbox. What the other side writes is not trusted: a letter is copied before it is read.
class Mailbox {
 public:
  static constexpr size_t kRoom = 4096 - 3 * sizeof(uint32_t);  // bytes of a letter

  // The server's side of a new one. Throws Code::limit when there is no memory or no descriptor left.
  static Mailbox make();
  // The client's side, of the descriptors that came from the server. Throws bad_shape when they are none of a
  // mailbox.
  static Mailbox open(std::vector<UniqueFd> descriptors);

  std::array<int, 3> descriptors() const;  // of a server's side: the memory, its bell, the client's

  // Leaves a letter, and rings the other side's bell unless that side is awake. False when it is too long.
  // The one before must have been taken: who waits for an answer to each knows that.
  bool put(std::string_view letter);
  bool has_letter() const { return in_->number.load(std::memory_order_acquire) != taken_; }
  // Copies the letter into at least kRoom bytes and returns its size; none when it claims more than fits.
  std::optional<size_t> take(char* into);

  int bell() const { return own_bell_.get(); }  // rings: an edge (EPOLLET), as nobody reads it
  // Whether this side looks for letters by itself, so that none is rung for. At first it does not.
  void stay_awake() { in_->awake.store(1, std::memory_order_relaxed); }
  // False when a letter has come that may not have been rung for.
  bool fall_asleep() {
    in_->awake.store(0);
    return in_->number.load() == taken_;
  }

 private:
  struct Slot {
    std::atomic<uint32_t> number, size;  // of letters so far; of this one, bytes
    std::atomic<uint32_t> awake;         // not 0: who takes them looks for the next by itself
    char bytes[kRoom];
  };
  static_assert(sizeof(Slot) == 4096 && std::atomic<uint32_t>::is_always_lock_free);

  enum class Side { server, client };
  Mailbox(Side side, UniqueFd memory, UniqueFd own_bell, UniqueFd other_bell);

  SharedArray memory_;  // the slot of requests, then that of answers
  UniqueFd own_bell_, other_bell_;
  Slot *in_, *out_;
  uint32_t taken_, put_;
};

}  // namespace animado::rpc
