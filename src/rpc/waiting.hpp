// How to wait for a peer that answers soon.
#pragma once

#include <poll.h>
#include <sched.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace animado::rpc {

using Clock = std::chrono::steady_clock;

// Waking a sleeping process costs about 60 µs across virtual cores, asking a socket 0.3 µs. To ask for about
// as long as waking would take never costs more than twice the best choice. sched_yield hands the core to the
// peer where both share one: without it, spinning there would hold up the very answer that it waits for.
inline constexpr std::chrono::microseconds kPollFor{50};

// On the only core that a process may use, the peer cannot answer before the process sleeps.
inline bool several_cores() {
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  return sched_getaffinity(0, sizeof allowed, &allowed) != 0 || CPU_COUNT(&allowed) > 1;
}

// Looks into memory for one to three microseconds, by the processor's pauses: what a peer with a core of its
// own is about to write there is seen sooner than a system call would take.
template <class Look>
bool spin(Look&& look) {
  constexpr int kLooks = 64;
  for (int i = 0; i < kLooks; ++i) {
    if (look()) return true;
    __builtin_ia32_pause();
  }
  return false;
}

// Where others want the core, to yield it is to lose it for milliseconds, and a sleeper is woken sooner: who
// looked and waited that long sleeps at once for a while, and longer each time that it happens again before
// as many waits were short.
class Rests {
 public:
  // Whether this wait is one to sleep at once.
  bool take() {
    if (left_ == 0) return false;
    --left_;
    return true;
  }
  // One that was not took so long.
  void waited(Clock::duration time) {
    if (time > kSoon) {
      left_ = next_;
      next_ = std::min(2 * next_, kLong);
      short_waits_ = 0;
    } else if (++short_waits_ >= next_) {
      next_ = kShort;
      short_waits_ = 0;
    }
  }

 private:
  static constexpr std::chrono::microseconds kSoon{1000};
  // Waits: a look that was in vain is then a small part of them.
  static constexpr int kShort = 64, kLong = 1024;

  int left_ = 0, next_ = kShort, short_waits_ = 0;
};

// Looks before it sleeps, where that may find anything and does not cost others much.
class Patience {
 public:
  // Whether to look before one sleeps may find anything.
  bool pays() const { return several_cores_; }

  // Tries until it succeeds or polling does not pay any more; false then: sleep, and say so.
  template <class Attempt>
  bool poll(Attempt&& attempt) {
    looked_ = false;
    if (attempt()) return true;
    if (!several_cores_ || rests()) return false;
    for (auto now = begin_; now - begin_ < kPollFor;) {
      sched_yield();
      now = Clock::now();
      if (attempt()) {
        rests_.waited(now - begin_);
        return true;
      }
    }
    return false;
  }

  // On the only core: hands it to a peer that works for us, and has it again once the peer sleeps. Nobody
  // needs to be woken then, which is a fifth of a short call. False when it is kept for now.
  bool hand_over() {
    if (rests()) return false;
    sched_yield();
    return true;
  }

  // The wait is over, if there was one: where an answer is there already nobody has begun to wait.
  void waited() {
    if (std::exchange(looked_, false)) rests_.waited(Clock::now() - begin_);
  }

 private:
  // Whether this wait is one to sleep at once.
  bool rests() {
    looked_ = !rests_.take();
    if (looked_) begin_ = Clock::now();
    return !looked_;
  }

  const bool several_cores_ = several_cores();
  Rests rests_;
  bool looked_ = false;  // in this wait
  Clock::time_point begin_;
};

// Rounded up; not positive when the time is over.
inline int milliseconds_until(Clock::time_point deadline) {
  return static_cast<int>(std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count());
}

// Sleeps until the descriptor is ready or the time is over; false then.
inline bool wait_until(int fd, short events, Clock::time_point deadline) {
  const int left_ms = milliseconds_until(deadline);
  pollfd entry{fd, events, 0};
  return left_ms > 0 && ::poll(&entry, 1, left_ms) != 0;
}

inline Clock::duration seconds(double s) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(s));
}

}  // namespace animado::rpc
