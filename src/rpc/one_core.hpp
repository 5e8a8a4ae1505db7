// Keeps this process, and those that it starts from then on, on one core.
//
// The five programs of a run answer each other in turn, never two at once. On one core the numbers that one
// wrote are in the cache when the next reads them, and to answer is a switch of context; across cores the
// same step waits for 20 MB of cache lines at 10,000 bodies, and for a sleeping core to wake at each message.
#pragma once

#include <sched.h>

#include "rpc/unique_fd.hpp"

namespace animado::rpc {

class OneCore {
 public:
  // Takes a core that no other run on this machine holds. When all are held, or only one is allowed anyway
  // (taskset), nothing changes: the kernel knows best how to share.
  OneCore();
  ~OneCore();  // this process may use again the cores that it had
  OneCore(const OneCore&) = delete;
  OneCore& operator=(const OneCore&) = delete;

 private:
  cpu_set_t before_;
  UniqueFd claim_;
};

}  // namespace animado::rpc
