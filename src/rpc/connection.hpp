// One end of a connection: bytes in, whole messages out, and back. Whoever owns it decides how to wait.
//
// Plain recv and send rather than Asio: a reactor's trip through epoll would double the time of a round trip
// that polling brings to 5 µs, and descriptors travel with the bytes (SCM_RIGHTS), which Asio leaves to
// recvmsg anyway.
#pragma once

#include <sys/socket.h>

#include <string>
#include <string_view>
#include <vector>

#include "rpc/msgpack_head.hpp"
#include "rpc/unique_fd.hpp"
#include "rpc/waiting.hpp"

namespace animado::rpc {

// Whether descriptors may come with the bytes. Where none is expected the kernel closes them, and receiving
// costs a tenth less.
enum class Descriptors { discarded, taken };

class Connection {
 public:
  explicit Connection(UniqueFd fd, Descriptors descriptors = Descriptors::discarded)
      : fd_(std::move(fd)), descriptors_(descriptors) {}

  int fd() const { return fd_.get(); }

  enum class Received { bytes, nothing, closed };
  Received receive();  // what is there now
  // Sleeps until something is there or the time is over.
  Received receive_by(Clock::time_point deadline);

  // Takes the next whole message, if it is there; it stays valid until the next receive(). Throws what
  // Scanner::scan throws.
  bool next_message(std::string_view& message);
  std::string_view unread() const { return {in_.data() + begin_, end_ - begin_}; }

  std::string& out() { return out_; }  // messages to send are appended here
  // Sends what the peer takes. False when the peer is gone.
  bool flush();
  size_t unsent() const { return out_.size() - sent_; }

  void attach(int fd);  // a copy goes with the next bytes
  UniqueFd take_descriptor() { return std::move(received_); }

 private:
  void make_room();
  ssize_t receive_with_descriptor();

  UniqueFd fd_;
  Descriptors descriptors_;
  UniqueFd attached_, received_;
  std::vector<char> in_;
  size_t begin_ = 0, end_ = 0;  // received and not yet taken
  Scanner scanner_;
  std::string out_;
  size_t sent_ = 0;
};

}  // namespace animado::rpc
