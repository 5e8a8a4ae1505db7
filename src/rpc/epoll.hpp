// Which of many descriptors are ready. Unlike poll() it is not told all of them before each wait, so that a
// wait costs the same whatever their number.
#pragma once

#include <sys/epoll.h>

#include <array>
#include <span>

#include "rpc/unique_fd.hpp"

namespace animado::rpc {

class Epoll {
 public:
  Epoll() : epoll_(epoll_create1(EPOLL_CLOEXEC)) {}

  // events: EPOLLIN and its like, as long as they hold. whose: comes back with the event. A descriptor that
  // is closed is forgotten by itself.
  void watch(int fd, uint32_t events, void* whose) { control(EPOLL_CTL_ADD, fd, events, whose); }
  void change(int fd, uint32_t events, void* whose) { control(EPOLL_CTL_MOD, fd, events, whose); }
  void forget(int fd) { control(EPOLL_CTL_DEL, fd, 0, nullptr); }

  // Valid until the next wait. timeout_ms: −1 for ever. Empty when a signal came.
  std::span<const epoll_event> wait(int timeout_ms) {
    const int ready = epoll_wait(epoll_.get(), ready_.data(), static_cast<int>(ready_.size()), timeout_ms);
    return {ready_.data(), static_cast<size_t>(std::max(ready, 0))};
  }

 private:
  void control(int operation, int fd, uint32_t events, void* whose) {
    epoll_event event{};
    event.events = events;
    event.data.ptr = whose;
    epoll_ctl(epoll_.get(), operation, fd, &event);
  }

  UniqueFd epoll_;
  std::array<epoll_event, 64> ready_;
};

}  // namespace animado::rpc
