#include "rpc/connection.hpp"

#include <fcntl.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace animado::rpc {
namespace {

constexpr size_t kFirstRoom = 16 << 10;  // bytes; most messages have less than 1 KiB
constexpr size_t kKeptRoom =
    1 << 20;  // bytes; a buffer that grew beyond this for one large message is given back

union DescriptorSpace {
  char bytes[CMSG_SPACE(sizeof(int))];  // for one: the kernel closes what is sent beyond it
  cmsghdr alignment;
};

UniqueFd descriptor_in(msghdr& header) {
  for (cmsghdr* part = CMSG_FIRSTHDR(&header); part != nullptr; part = CMSG_NXTHDR(&header, part)) {
    if (part->cmsg_level != SOL_SOCKET || part->cmsg_type != SCM_RIGHTS) continue;
    int fd;
    std::memcpy(&fd, CMSG_DATA(part), sizeof fd);
    return UniqueFd(fd);
  }
  return {};
}

ssize_t send_with(int socket, std::string_view bytes, int descriptor) {
  DescriptorSpace space{};
  iovec part{const_cast<char*>(bytes.data()), bytes.size()};
  msghdr header{};
  header.msg_iov = &part;
  header.msg_iovlen = 1;
  header.msg_control = space.bytes;
  header.msg_controllen = sizeof space.bytes;
  cmsghdr* control = CMSG_FIRSTHDR(&header);
  control->cmsg_level = SOL_SOCKET;
  control->cmsg_type = SCM_RIGHTS;
  control->cmsg_len = CMSG_LEN(sizeof descriptor);
  std::memcpy(CMSG_DATA(control), &descriptor, sizeof descriptor);
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
  return wait_until(fd_.get(), POLLIN, deadline) ? receive() : Received::nothing;
}

Connection::Received Connection::receive() {
  make_room();
  const ssize_t count = descriptors_ == Descriptors::taken
                            ? receive_with_descriptor()
                            : ::recv(fd_.get(), in_.data() + end_, in_.size() - end_, MSG_DONTWAIT);
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return Received::nothing;
  if (count <= 0) return Received::closed;
  end_ += static_cast<size_t>(count);
  return Received::bytes;
}

ssize_t Connection::receive_with_descriptor() {
  DescriptorSpace space;
  iovec part{in_.data() + end_, in_.size() - end_};
  msghdr header{};
  header.msg_iov = &part;
  header.msg_iovlen = 1;
  header.msg_control = space.bytes;
  header.msg_controllen = sizeof space.bytes;
  const ssize_t count = ::recvmsg(fd_.get(), &header, MSG_DONTWAIT | MSG_CMSG_CLOEXEC);
  if (count > 0 && header.msg_controllen > 0) received_ = descriptor_in(header);
  return count;
}

bool Connection::next_message(std::string_view& message) {
  if (begin_ == end_ || !scanner_.scan(in_.data() + begin_, in_.data() + end_)) return false;
  message = {in_.data() + begin_, scanner_.size()};
  begin_ += scanner_.size();
  scanner_.reset();
  return true;
}

void Connection::attach(int fd) {
  attached_.reset(fcntl(fd, F_DUPFD_CLOEXEC, 0));
}

bool Connection::flush() {
  while (sent_ < out_.size()) {
    const std::string_view rest = std::string_view(out_).substr(sent_);
    const ssize_t count = attached_
                              ? send_with(fd_.get(), rest, attached_.get())
                              : ::send(fd_.get(), rest.data(), rest.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno == EAGAIN;
    attached_.reset();
    sent_ += static_cast<size_t>(count);
  }
  out_.clear();
  sent_ = 0;
  if (out_.capacity() > kKeptRoom) out_ = {};
  return true;
}

}  // namespace animado::rpc
