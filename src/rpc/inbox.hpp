// Notifications that have come and wait to be asked for.
#pragma once

#include <deque>
#include <string>
#include <string_view>

#include "rpc/codec.hpp"

namespace animado::rpc {

class Inbox {
 public:
  void put(std::string_view message);
  void clear();
  bool empty() const { return messages_.empty(); }
  size_t bytes() const { return bytes_; }

  // Takes the oldest one of that kind; false when there is none.
  bool take(const MessageCodec& message, void* request);

 private:
  std::deque<std::string> messages_;  // whole, packed
  size_t bytes_ = 0;
};

}  // namespace animado::rpc
