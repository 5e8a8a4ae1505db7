#include "rpc/server.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <sys/timerfd.h>

#include "rpc/endpoint.hpp"

namespace animado::rpc {
namespace {

// While one peer keeps us busy the others, and those who want to connect, are looked at this often.
constexpr std::chrono::milliseconds kFullLook{1};
constexpr std::chrono::milliseconds kLogDelay{50};  // who follows a log does not notice
constexpr int kLooksAtLast = 8;       // at who spoke last, for one at everybody: some ten microseconds
constexpr size_t kMaxClient = 40;     // characters of a client's name
constexpr size_t kMaxPeers = 256;     // a run has 10; below the usual limit of 1024 open files
constexpr size_t kMaxMailboxes = 64;  // three more open files each
constexpr size_t kMaxUnsent = size_t{1}
                              << 20;  // bytes that a peer may leave unread before it is not served further
// Peers that get their notifications between two looks for requests: a hundred watchers hold up nobody for
// longer than some ten microseconds.
constexpr size_t kNotifiedAtOnce = 4;

}  // namespace

Server::Server(Dispatcher& dispatcher, std::filesystem::path socket)
    : dispatcher_(dispatcher),
      socket_(std::move(socket)),
      listener_(listen_at(socket_)),
      wake_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)),
      log_timer_(timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC)) {
  for (UniqueFd* fd : {&listener_, &wake_, &log_timer_}) epoll_.watch(fd->get(), EPOLLIN, fd);
  dispatcher_.service().post = [this](ConnectionId id, std::string_view message) {
    return post(id, message);
  };
  dispatcher_.load = [this] { return load(); };
  dispatcher_.service().is_connected = [this](ConnectionId id) { return is_connected(id); };
  dispatcher_.service().open_mailbox = [this](ConnectionId id) { return open_mailbox(id); };
}

Server::~Server() {
  std::error_code gone;
  std::filesystem::remove(socket_, gone);
  for (Peer& peer : peers_) peer.ending = true;
  drop_ended();
}

void Server::stop() noexcept {
  stopping_ = true;
  const uint64_t one = 1;
  [[maybe_unused]] const auto written =
      ::write(wake_.get(), &one, sizeof one);  // full only when it is awake already
}

void Server::keep(Companion& companion) {
  companion_ = &companion;
  companion_fd_ = companion.fd();
  epoll_.watch(companion_fd_, EPOLLIN, companion_);
}

void Server::run() {
  while (!stopping_) {
    if (!patience_.poll([this] { return look() || stopping_; })) wait(true);
  }
  dispatcher_.log().flush();
}

bool Server::look() {
  const bool notified = send_notifications();
  if (!notified && !patience_.pays()) return false;
  const bool everybody = last_ == nullptr || ++looks_ % kLooksAtLast == 0;
  if (everybody) return wait(false) || notified;
  last_->connection.spin_for_letter();
  if (!serve(*last_)) return notified;
  if (last_->ending || last_done_ - last_full_look_ > kFullLook) wait(false);
  return true;
}

bool Server::wait(bool sleep) {
  start_log_timer();
  const bool asleep = sleep && fall_asleep();
  const auto next = companion_ ? companion_->next_time() : Clock::time_point::max();
  int timeout_ms = asleep ? -1 : 0;
  if (asleep && next != Clock::time_point::max()) {
    const auto left = std::max(next - Clock::now(), Clock::duration::zero());
    timeout_ms = static_cast<int>(std::chrono::ceil<std::chrono::milliseconds>(left).count());
  }
  const auto ready = epoll_.wait(timeout_ms);
  if (sleep) {
    stay_awake();
    patience_.waited();
  }
  last_full_look_ = Clock::now();
  bool for_companion = last_full_look_ >= next, connecting = false;
  for (const epoll_event& event : ready) {
    if (event.data.ptr == companion_) {
      for_companion = true;
    } else if (event.data.ptr == &listener_) {
      connecting = true;
    } else if (event.data.ptr == &log_timer_) {
      write_log();
    } else if (event.data.ptr != &wake_) {
      serve(*static_cast<Peer*>(event.data.ptr));
    }
  }
  const bool had_letters = serve_letters();
  if (for_companion) step_companion();
  if (connecting) accept_all();
  drop_ended();
  return had_letters || !ready.empty();
}

// On the only core we sleep whenever others work: there every letter is rung for.
bool Server::fall_asleep() {
  bool nothing_came = true;
  if (patience_.pays())
    for (Peer& peer : peers_) nothing_came &= peer.connection.fall_asleep() || is_behind(peer);
  return nothing_came;
}

void Server::stay_awake() {
  if (patience_.pays())
    for (Peer& peer : peers_) peer.connection.stay_awake();
}

bool Server::serve_letters() {
  bool some = false;
  if (patience_.pays())
    for (Peer& peer : peers_) some |= peer.connection.has_letter() && serve(peer);
  return some;
}

// Its descriptor may be another one afterwards.
void Server::step_companion() {
  companion_->step();
  epoll_.forget(companion_fd_);
  companion_fd_ = companion_->fd();
  epoll_.watch(companion_fd_, EPOLLIN, companion_);
}

void Server::start_log_timer() {
  if (log_timer_runs_ || !dispatcher_.log().dirty()) return;
  const itimerspec once{{0, 0}, {0, std::chrono::nanoseconds(kLogDelay).count()}};
  timerfd_settime(log_timer_.get(), 0, &once, nullptr);
  log_timer_runs_ = true;
}

void Server::write_log() {
  uint64_t times;
  [[maybe_unused]] const auto read = ::read(log_timer_.get(), &times, sizeof times);  // it is ready no more
  log_timer_runs_ = false;
  dispatcher_.log().flush();
}

void Server::accept_all() {
  for (;;) {
    UniqueFd fd(::accept4(listener_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (!fd) return;
    if (!peer_is_ours(fd.get())) {
      dispatcher_.log().warn("a process of another user was turned away");
    } else if (peers_.size() == kMaxPeers) {
      dispatcher_.log().warn(fmt::format("a client was turned away: {} are connected", kMaxPeers));
    } else {
      const bool adopts = dispatcher_.service().find(ArrayAdopt::name) != nullptr;
      Peer& peer =
          peers_.emplace_back(std::move(fd), adopts ? Descriptors::taken : Descriptors::discarded, next_id_);
      by_id_[next_id_++] = &peer;
      epoll_.watch(peer.connection.fd(), EPOLLIN, &peer);
    }
  }
}

// A few peers, in turn: the list is rotated behind those that were served.
bool Server::send_notifications() {
  if (notified_ == 0) return false;
  size_t sent = 0;
  auto peer = peers_.begin();
  for (; peer != peers_.end() && sent < kNotifiedAtOnce; ++peer) {
    if (!peer->notified) continue;
    flush(*peer);
    ++sent;
  }
  peers_.splice(peers_.end(), peers_, peers_.begin(), peer);
  return true;
}

// Sends what the peer takes, and tells when it has taken all that it left.
void Server::flush(Peer& peer) {
  peer.ending |= !peer.connection.flush();
  if (peer.blocked != (peer.connection.unsent() > 0)) {
    peer.blocked = !peer.blocked;
    epoll_.change(peer.connection.fd(), peer.blocked ? EPOLLOUT : EPOLLIN, &peer);
  }
  notified_ -= std::exchange(peer.notified, false);
  if (!peer.full || peer.ending || peer.connection.unsent() > 0) return;
  peer.full = false;
  if (dispatcher_.service().on_drained) dispatcher_.service().on_drained(peer.id);
}

bool Server::serve(Peer& peer) {
  if (peer.connection.unsent() > 0) flush(peer);
  if (peer.ending || is_behind(peer)) return peer.ending;
  const bool received = receive(peer);
  if (!peer.ending)
    serve_messages(peer);  // when nothing came there may be what was left while the peer did not read
  if (!received) return false;
  // Where the peer has a core of its own, it does not wait for this.
  if (patience_.pays()) dispatcher_.log().format();
  last_ = &peer;
  last_done_ = Clock::now();
  dispatcher_.was_busy(last_done_ - last_arrival_);
  return true;
}

bool Server::is_behind(const Peer& peer) {
  return peer.connection.unsent() > kMaxUnsent || peer.connection.has_attached();
}

bool Server::receive(Peer& peer) {
  const auto received = peer.connection.receive();
  peer.ending |= received == Connection::Received::closed;
  if (received == Connection::Received::nothing) return false;
  begin_ = last_arrival_ = Clock::now();
  return true;
}

// What was held back because the peer did not read is served as soon as it does: nothing new may come to wake
// us.
void Server::serve_messages(Peer& peer) {
  bool held_back = true;
  while (held_back && !peer.ending && !is_behind(peer)) {
    answer_all(peer);
    held_back = is_behind(peer);
    if (peer.connection.unsent() > 0) flush(peer);
  }
}

void Server::answer_all(Peer& peer) {
  Envelope envelope;
  try {
    std::string_view message;
    while (!peer.ending && !is_behind(peer) && peer.connection.next_message(message)) {
      envelope = {};
      read_envelope(message, envelope);
      answer(peer, envelope);
    }
  } catch (const Error& error) {
    // Not MessagePack-RPC, or too much of it: where the next message begins is unknown, so the connection
    // ends.
    if (envelope.id == 0) envelope.id = id_in(peer.connection.unread());
    dispatcher_.refuse(envelope.method, {peer.trace, envelope.id}, error);
    send_error(peer, envelope, error);
    peer.ending = true;
  }
}

void Server::answer(Peer& peer, const Envelope& envelope) {
  if (envelope.kind == Envelope::Kind::reply) {
    throw Error(Code::protocol, "a reply to a question that was not asked", {},
                "send requests: [0, id, method, [params]]");
  }
  Decoder in(envelope.body, Numbers::finite);
  in.marks = {peer.trace, envelope.id};
  try {
    const Service::Entry& entry = entry_for(peer, envelope.method);
    const Value request = entry.codec->request.make();
    unpack(entry.codec->request, in, request.get(), entry.codec->name);
    call(peer, envelope, entry, request.get(), in.marks);
  } catch (const Error& error) {
    dispatcher_.refuse(envelope.method, in.marks, error);
    send_error(peer, envelope, error);
  }
}

const Service::Entry& Server::entry_for(const Peer& peer, std::string_view method) const {
  const Service::Entry& entry = dispatcher_.entry(method);
  if (peer.greeted || method == Hello::name) return entry;
  throw Error(Code::protocol, fmt::format("'{}' came before hello", method), dispatcher_.service().name(),
              fmt::format("open the connection with hello {{protocol: '{}', version: {}}}", kProtocolName,
                          kProtocolVersion));
}

void Server::call(Peer& peer, const Envelope& envelope, const Service::Entry& entry, const void* request,
                  const Marks& marks) {
  const Value reply = entry.codec->reply.make();
  ServedCall call(peer.id, dispatcher_.suite(), peer.client);
  if (peer.connection.has_descriptors()) call.set_incoming(peer.connection.take_descriptors());
  const Dispatcher::Outcome outcome = dispatcher_.run(entry, request, reply.get(), call, begin_);
  begin_ = outcome.end;
  if (outcome.error) {
    send_error(peer, envelope, *outcome.error);
  } else {
    if (!peer.greeted) greet(peer, *static_cast<const Hello::Request*>(request));
    if (!call.outgoing().empty() && envelope.kind == Envelope::Kind::request)
      peer.connection.attach(call.outgoing());
    send_result(peer, envelope, entry.codec->reply, reply.get());
  }
  // Replies to requests that came together leave together; to count and log waits until they are on their
  // way.
  if (peer.connection.unread().empty() || !call.outgoing().empty()) flush(peer);
  dispatcher_.record(*entry.codec, request, marks, outcome, last_arrival_);
}

void Server::greet(Peer& peer, const Hello::Request& hello) {
  peer.greeted = true;
  peer.client = hello.client.substr(0, kMaxClient);
  peer.trace = hello.trace;
}

void Server::send_result(Peer& peer, const Envelope& envelope, const Type& type, const void* reply) {
  if (envelope.kind == Envelope::Kind::notification) return;
  std::string& bytes = peer.connection.out();
  const size_t before = bytes.size();
  Encoder out(bytes);
  begin_result(envelope.id, out);
  pack(type, reply, out);
  if (bytes.size() - before > kMaxMessageBytes) {
    bytes.resize(before);
    return send_error(
        peer, envelope,
        {Code::limit, fmt::format("the reply would hold more than {} bytes", kMaxMessageBytes),
         std::string(envelope.method), "name a shared array in the field out, or ask for less"});
  }
}

void Server::send_error(Peer& peer, const Envelope& envelope, const Error& error) {
  if (envelope.kind == Envelope::Kind::notification) return;
  Encoder out(peer.connection.out());
  write_error(envelope.id, error, out);
}

void Server::drop_ended() {
  for (auto peer = peers_.begin(); peer != peers_.end();) {
    if (!peer->ending) {
      ++peer;
      continue;
    }
    if (last_ == &*peer) last_ = nullptr;
    notified_ -= peer->notified;
    if (const auto& mailbox = peer->connection.mailbox()) {
      epoll_.forget(mailbox->bell());  // open at the client's side it would ring on
      --mailboxes_;
    }
    by_id_.erase(peer->id);
    const ConnectionId id = peer->id;
    peer = peers_.erase(peer);
    if (dispatcher_.service().on_disconnect) dispatcher_.service().on_disconnect(id);
  }
}

Service::Delivery Server::post(ConnectionId id, std::string_view message) {
  const auto found = by_id_.find(id);
  if (found == by_id_.end() || found->second->ending) return Service::Delivery::gone;
  Peer& peer = *found->second;
  if (!peer.full && peer.connection.unsent() > kMaxUnread) flush(peer);
  peer.full |= peer.connection.unsent() > kMaxUnread;
  if (peer.full) return Service::Delivery::full;
  peer.connection.out() += message;
  notified_ += !std::exchange(peer.notified, true);
  return Service::Delivery::sent;
}

Dispatcher::Load Server::load() const {
  Dispatcher::Load load{.connections = static_cast<int64_t>(peers_.size())};
  for (const Peer& peer : peers_) {
    pollfd entry{peer.connection.fd(), POLLIN, 0};
    load.waiting +=
        !peer.connection.unread().empty() || peer.connection.has_letter() || ::poll(&entry, 1, 0) > 0;
    load.unsent_bytes += static_cast<int64_t>(peer.connection.unsent());
  }
  return load;
}

std::array<int, 3> Server::open_mailbox(ConnectionId id) {
  Peer& peer = *by_id_.at(id);
  if (!peer.connection.mailbox()) {
    if (mailboxes_ == kMaxMailboxes)
      throw Error(Code::limit, fmt::format("{} connections have a mailbox", mailboxes_),
                  dispatcher_.service().name(), "go on over the socket");
    peer.connection.use(Mailbox::make(), Connection::Waits::elsewhere);
    if (patience_.pays()) peer.connection.stay_awake();
    epoll_.watch(peer.connection.mailbox()->bell(), EPOLLIN | EPOLLET, &peer);
    ++mailboxes_;
  }
  return peer.connection.mailbox()->descriptors();
}

bool Server::is_connected(ConnectionId id) {
  const auto found = by_id_.find(id);
  if (found == by_id_.end() || found->second->ending) return false;
  Peer& peer = *found->second;
  flush(peer);
  pollfd state = {peer.connection.fd(), POLLRDHUP, 0};
  return !peer.ending && ::poll(&state, 1, 0) == 0;
}

}  // namespace animado::rpc
