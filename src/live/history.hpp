// What pages that come later are told of what was: the newest messages, as many as fit.
#pragma once

#include <deque>
#include <string>
#include <utility>

namespace animado::live {

class History {
 public:
  explicit History(size_t most_bytes) : most_bytes_(most_bytes) {}

  void add(std::string message) {
    bytes_ += message.size();
    messages_.push_back(std::move(message));
    for (; bytes_ > most_bytes_; messages_.pop_front()) bytes_ -= messages_.front().size();
  }

  const std::deque<std::string>& messages() const { return messages_; }  // the oldest first

 private:
  size_t most_bytes_, bytes_ = 0;
  std::deque<std::string> messages_;
};

}  // namespace animado::live
