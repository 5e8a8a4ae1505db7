// What serving a request is, whatever brought it: find the row, call the handler, count, log, and turn what
// goes wrong into an error that a caller can read. Server brings requests from sockets, LocalSuite from this
// process.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "rpc/common.hpp"
#include "rpc/decoder.hpp"
#include "rpc/histogram.hpp"
#include "rpc/log.hpp"
#include "rpc/service.hpp"
#include "rpc/shared_array.hpp"
#include "rpc/waiting.hpp"

namespace animado::rpc {

// The call that a handler sees.
class ServedCall final : public Call {
 public:
  ServedCall(ConnectionId connection, Suite& suite, std::string_view client = {})
      : connection_(connection), suite_(suite), client_(client) {}

  ConnectionId connection() const override { return connection_; }
  std::string_view client() const override { return client_; }
  std::span<const double> read(const Array& array) override;
  std::span<double> write(const Array& array) override;
  void send_descriptor(int fd) override { outgoing_.push_back(fd); }
  UniqueFd take_descriptor() override { return first_of(incoming_); }

  void set_incoming(std::vector<UniqueFd> descriptors) { incoming_ = std::move(descriptors); }
  std::span<const int> outgoing() const { return outgoing_; }

 private:
  std::span<double> pages(const Array& array);

  ConnectionId connection_;
  Suite& suite_;
  std::string_view client_;
  std::vector<UniqueFd> incoming_;
  std::vector<int> outgoing_;
};

class Dispatcher {
 public:
  // Adds the messages that every service answers (common.hpp) to the table.
  Dispatcher(Service& service, Suite& suite, Log& log);

  Service& service() { return service_; }
  Log& log() { return log_; }
  Suite& suite() { return suite_; }

  // The row of a message. Throws unknown_method with the nearest name.
  const Service::Entry& entry(std::string_view method) const;

  // How a request ended.
  struct Outcome {
    std::optional<Error> error;
    Clock::time_point begin{}, end{};
  };

  // Calls the handler; whatever it throws becomes an Error. begin: since when the request has been served.
  // Counting and logging are a step of their own, so that they happen while the reply is on its way.
  Outcome run(const Service::Entry& entry, const void* request, void* reply, Call& call,
              Clock::time_point begin);
  // arrival: of the request; its answer is on its way now.
  void record(const MessageCodec& codec, const void* request, const Marks& marks, const Outcome& outcome,
              Clock::time_point arrival);

  // For a request that never reached a handler: counts and logs it.
  void refuse(std::string_view method, const Marks& marks, const Error& error);

  void was_busy(Clock::duration time) { busy_ += time; }
  // What there is to do now; set by whoever has connections.
  struct Load {
    int64_t connections = 0, waiting = 0, unsent_bytes = 0;
  };
  std::function<Load()> load;

 private:
  struct Count {
    int64_t requests = 0, errors = 0;
    Clock::duration time{};
  };

  void add_common();
  Statistics::Reply statistics() const;
  void count(std::string_view message, bool failed, Clock::duration time = {});
  void write_line(const MessageCodec& codec, const void* request, const Marks& marks, const Outcome& outcome);

  Service& service_;
  Suite& suite_;
  Log& log_;
  Count total_;
  std::map<std::string_view, Count> counts_;
  Histogram latency_;
  Clock::duration busy_{};
  const std::string up_since_ = utc_now();
  const Clock::time_point start_ = Clock::now();
  std::string line_;  // kept for its memory
};

}  // namespace animado::rpc
