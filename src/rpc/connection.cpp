#include "rpc/connection.hpp"

#include <fcntl.h>
#include <sys/socket.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <span>

namespace animado::rpc {
namespace {

constexpr size_t kFirstRoom = 16 << 10;  // bytes; most messages have less than 1 KiB
constexpr size_t kKeptRoom =
    1 << 20;  // bytes; a buffer that grew beyond this for one large message is given back

union DescriptorSpace {
  char bytes[CMSG_SPACE(Connection::kMaxDescriptors * sizeof(int))];  // the kernel closes what is sent beyond
  cmsghdr alignment;
};

std::vector<UniqueFd> descriptors_in(msghdr& header) {
  std::vector<UniqueFd> found;
  for (cmsghdr* part = CMSG_FIRSTHDR(&header); part != nullptr; part = CMSG_NXTHDR(&header, part)) {
    if (part->cmsg_level != SOL_SOCKET || part->cmsg_type != SCM_RIGHTS) continue;
    for (size_t i = 0; CMSG_LEN((i + 1) * sizeof(int)) <= part->cmsg_len; ++i) {
      int fd;
      std::memcpy(&fd, CMSG_DATA(part) + i * sizeof fd, sizeof fd);
      found.emplace_back(fd);
    }
  }
  return found;
}

ssize_t send_with(int socket, std::string_view bytes, std::span<const UniqueFd> descriptors) {
  DescriptorSpace space{};
  iovec part{const_cast<char*>(bytes.data()), bytes.size()};
  msghdr header{};
  header.msg_iov = &part;
  header.msg_iovlen = 1;
  header.msg_control = space.bytes;
  header.msg_controllen = CMSG_SPACE(descriptors.size() * sizeof(int));
  cmsghdr* control = CMSG_FIRSTHDR(&header);
  control->cmsg_level = SOL_SOCKET;
  control->cmsg_type = SCM_RIGHTS;
  control->cmsg_len = CMSG_LEN(descriptors.size() * sizeof(int));
  for (size_t i = 0; i < descriptors.size(); ++i) {
    const int fd = descriptors[i].get();
    std::memcpy(CMSG_DATA(control) + i * sizeof fd, &fd, sizeof fd);
  }
  return ::sendmsg(socket, &header, MSG_DONTWAIT | MSG_NOSIGNAL);
}

}  // namespace

void Connection::make_room() {
  if (begin_ == end_) {
    begin_ = end_ = 0;
    if (in_.size() > kKeptRoom) in_ = {};
  } else if (end_ == in_.size() && begin_ > 0) {
    std::memmove(in_.data(), in_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
  }
  // Grows with what has come, never with what a length claims.
  if (end_ == in_.size()) in_.resize(std::max(kFirstRoom, 2 * in_.size()));
}

// Not asleep in recv, though that were one call less: the kernel wakes who sleeps there also when the peer
// has read what was sent to it, and on one core the sleeper takes the core from the peer, in vain, at each
// message. A poll wakes for what it waits for.
Connection::Received Connection::receive_by(Clock::time_point deadline) {
  if (has_letter()) return receive();
  const bool ready = either_ ? wait_for_either(deadline) : wait_until(fd_.get(), POLLIN, deadline);
  return ready ? receive() : Received::nothing;
}

bool Connection::wait_for_either(Clock::time_point deadline) {
  for (;;) {
    const int left_ms = milliseconds_until(deadline);
    const auto ready = either_->wait(fall_asleep() ? std::max(left_ms, 0) : 0);
    stay_awake();
    const bool socket =
        std::ranges::any_of(ready, [](const epoll_event& e) { return e.data.ptr != nullptr; });
    if (socket || has_letter()) return true;
    if (left_ms <= 0) return false;  // otherwise the bell was heard for a letter that has been taken already
  }
}

Connection::Received Connection::receive() {
  if (has_letter()) return receive_letter();
  make_room();
  const ssize_t count = descriptors_ == Descriptors::taken
                            ? receive_with_descriptors()
                            : ::recv(fd_.get(), in_.data() + end_, in_.size() - end_, MSG_DONTWAIT);
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return Received::nothing;
  if (count <= 0) return Received::closed;
  end_ += static_cast<size_t>(count);
  return Received::bytes;
}

Connection::Received Connection::receive_letter() {
  make_room();
  static_assert(kFirstRoom >= Mailbox::kRoom);
  const auto size = mailbox_->take(in_.data());
  if (!size) return Received::closed;  // a peer that says what cannot be is no peer
  end_ = *size;
  by_letter_ = !either_;  // a server answers the same way; what a client sends next may be more than one call
  return Received::bytes;
}

ssize_t Connection::receive_with_descriptors() {
  DescriptorSpace space;
  iovec part{in_.data() + end_, in_.size() - end_};
  msghdr header{};
  header.msg_iov = &part;
  header.msg_iovlen = 1;
  header.msg_control = space.bytes;
  header.msg_controllen = sizeof space.bytes;
  const ssize_t count = ::recvmsg(fd_.get(), &header, MSG_DONTWAIT | MSG_CMSG_CLOEXEC);
  if (count > 0 && header.msg_controllen > 0) received_ = descriptors_in(header);
  return count;
}

bool Connection::next_message(std::string_view& message) {
  if (begin_ == end_ || !scanner_.scan(in_.data() + begin_, in_.data() + end_)) return false;
  message = {in_.data() + begin_, scanner_.size()};
  begin_ += scanner_.size();
  scanner_.reset();
  return true;
}

void Connection::attach(std::span<const int> descriptors) {
  assert(attached_.empty() && descriptors.size() <= kMaxDescriptors);
  for (int fd : descriptors) {
    if (UniqueFd copy(fcntl(fd, F_DUPFD_CLOEXEC, 0)); copy) attached_.push_back(std::move(copy));
  }
  attached_at_ = out_.size();
}

void Connection::use(Mailbox mailbox, Waits waits) {
  mailbox_.emplace(std::move(mailbox));
  if (waits == Waits::elsewhere) return;
  mailbox_->stay_awake();
  either_.emplace();
  either_->watch(fd_.get(), EPOLLIN, this);
  either_->watch(mailbox_->bell(), EPOLLIN | EPOLLET, nullptr);
}

bool Connection::flush() {
  if (unsent() == 0) return true;
  const bool sent = (std::exchange(by_letter_, false) && flush_as_letter()) || flush_to_socket();
  if (sent && unsent() == 0 && out_.capacity() > kKeptRoom) out_ = {};
  return sent;
}

// What has begun to go over the socket ends there.
bool Connection::flush_as_letter() {
  if (!mailbox_ || sent_ > 0 || !attached_.empty() || !mailbox_->put(out_)) return false;
  out_.clear();
  return true;
}

bool Connection::flush_to_socket() {
  while (sent_ < out_.size()) {
    const bool with = has_attached() && sent_ == attached_at_;
    const size_t end = has_attached() && !with ? attached_at_ : out_.size();
    const std::string_view rest = std::string_view(out_).substr(sent_, end - sent_);
    const ssize_t count = with ? send_with(fd_.get(), rest, attached_)
                               : ::send(fd_.get(), rest.data(), rest.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno == EAGAIN;
    if (with) attached_.clear();
    sent_ += static_cast<size_t>(count);
  }
  out_.clear();
  sent_ = 0;
  return true;
}

}  // namespace animado::rpc
