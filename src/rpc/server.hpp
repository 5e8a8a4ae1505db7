// Serves a table on a socket: one thread, one request at a time, in the order in which they come.
#pragma once

#include <poll.h>

#include <atomic>
#include <filesystem>
#include <list>
#include <unordered_map>
#include <vector>

#include "rpc/connection.hpp"
#include "rpc/dispatcher.hpp"
#include "rpc/epoll.hpp"
#include "rpc/unique_fd.hpp"
#include "rpc/waiting.hpp"
#include "rpc/wire.hpp"

namespace animado::rpc {

// Something else that the loop keeps going: the registration with interexpserv.
class Companion {
 public:
  virtual ~Companion() = default;
  virtual int fd() const = 0;                       // wakes the loop when readable; -1: none
  virtual Clock::time_point next_time() const = 0;  // wakes the loop at the latest
  virtual void step() = 0;                          // must not block
};

class Server {
 public:
  // Listens when constructed; stops listening, and removes the socket, when destroyed. Throws what listen_at
  // throws.
  Server(Dispatcher& dispatcher, std::filesystem::path socket);
  ~Server();

  void keep(Companion& companion);
  void run();            // until stop()
  void stop() noexcept;  // from any thread, or a signal handler
  const std::filesystem::path& socket() const { return socket_; }

 private:
  struct Peer {
    Peer(UniqueFd fd, Descriptors descriptors, ConnectionId number)
        : connection(std::move(fd), descriptors), id(number) {}
    Connection connection;
    ConnectionId id;
    bool greeted = false, ending = false;
    bool notified = false;  // and not sent yet
    bool full = false;      // of notifications that it does not read
    bool blocked = false;   // does not take what was sent: waited for until it does
    std::string client, trace;
  };
  using Peers = std::list<Peer>;

  bool look();  // serves who spoke last, and now and then everybody; true when there was something to do
  bool send_notifications();  // to a few; true when there were some
  bool wait(bool sleep);      // for anything, and serves it; false when nothing came
  bool fall_asleep();         // false when there are letters that nobody rang for
  void stay_awake();
  bool serve_letters();  // that nobody rang for; true when there were some
  void step_companion();
  void start_log_timer();  // the log is written out when it is over, not at every line
  void write_log();
  void accept_all();
  bool serve(Peer& peer);  // true when something came
  bool receive(Peer& peer);
  static bool is_behind(const Peer& peer);  // in reading, so that it is not served further
  void serve_messages(Peer& peer);
  void answer_all(Peer& peer);
  void answer(Peer& peer, const Envelope& envelope);
  const Service::Entry& entry_for(const Peer& peer, std::string_view method) const;
  void call(Peer& peer, const Envelope& envelope, const Service::Entry& entry, const void* request,
            const Marks& marks);
  void greet(Peer& peer, const Hello::Request& hello);
  void send_result(Peer& peer, const Envelope& envelope, const Type& type, const void* reply);
  void send_error(Peer& peer, const Envelope& envelope, const Error& error);
  void drop_ended();
  Service::Delivery post(ConnectionId id, std::string_view message);
  void flush(Peer& peer);
  Dispatcher::Load load() const;
  bool is_connected(ConnectionId id);
  std::array<int, 3> open_mailbox(ConnectionId id);

  Dispatcher& dispatcher_;
  std::filesystem::path socket_;
  UniqueFd listener_, wake_, log_timer_;
  Epoll epoll_;
  Companion* companion_ = nullptr;
  int companion_fd_ = -1;
  std::atomic<bool> stopping_{false};
  Peers peers_;
  std::unordered_map<ConnectionId, Peer*> by_id_;
  Peer* last_ = nullptr;  // who spoke last: most likely to speak next
  ConnectionId next_id_ = 1;
  int looks_ = 0;
  size_t notified_ = 0, mailboxes_ = 0;  // peers
  Clock::time_point last_full_look_, last_arrival_, last_done_;
  Clock::time_point begin_;  // of the request that is served: it came, or the one before it was answered
  bool log_timer_runs_ = false;
  Patience patience_;
};

}  // namespace animado::rpc
