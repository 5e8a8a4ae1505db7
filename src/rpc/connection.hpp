// One end of a connection: bytes in, whole messages out, and back. Whoever owns it decides how to wait.
//
// Plain recv and send rather than Asio: a reactor's trip through epoll would double the time of a round trip
// that polling brings to 5 µs, and descriptors travel with the bytes (SCM_RIGHTS), which Asio leaves to
// recvmsg anyway. Short calls and their answers may go through a mailbox beside the socket.
#pragma once

#include <sys/socket.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rpc/epoll.hpp"
#include "rpc/mailbox.hpp"
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

  static constexpr size_t kMaxDescriptors = 3;  // that go with bytes, or come
  // Copies go with the first of the bytes that are appended next. One message's at a time, until they are
  // sent.
  void attach(std::span<const int> descriptors);
  bool has_attached() const { return !attached_.empty(); }
  bool has_descriptors() const { return !received_.empty(); }
  std::vector<UniqueFd> take_descriptors() { return std::exchange(received_, {}); }

  // Who waits for a letter: a server does among all its connections, receive_by() does here.
  enum class Waits { elsewhere, here };
  void use(Mailbox mailbox, Waits waits);
  const std::optional<Mailbox>& mailbox() const { return mailbox_; }
  // One that may be taken: never in the middle of a message that comes over the socket.
  bool has_letter() const { return mailbox_ && begin_ == end_ && mailbox_->has_letter(); }
  // Looks for one a moment longer, where there is a mailbox.
  void spin_for_letter() const {
    if (mailbox_) spin([this] { return mailbox_->has_letter(); });
  }
  // Whether letters are looked for without their bell. False from fall_asleep() when one is there already.
  void stay_awake() {
    if (mailbox_) mailbox_->stay_awake();
  }
  bool fall_asleep() { return !mailbox_ || mailbox_->fall_asleep() || !has_letter(); }
  // What is flushed next is one short call, while nothing else is under way: it may go as a letter. Its
  // answer does, where it is short too.
  void call_by_letter() { by_letter_ = true; }

 private:
  void make_room();
  Received receive_letter();
  ssize_t receive_with_descriptors();
  bool wait_for_either(Clock::time_point deadline);
  bool flush_as_letter();
  bool flush_to_socket();

  UniqueFd fd_;
  Descriptors descriptors_;
  std::vector<UniqueFd> attached_, received_;
  size_t attached_at_ = 0;  // of out_
  std::optional<Mailbox> mailbox_;
  std::optional<Epoll> either_;  // the socket and the bell of the mailbox, of who waits here for both
  bool by_letter_ = false;
  std::vector<char> in_;
  size_t begin_ = 0, end_ = 0;  // received and not yet taken
  Scanner scanner_;
  std::string out_;
  size_t sent_ = 0;
};

}  // namespace animado::rpc
