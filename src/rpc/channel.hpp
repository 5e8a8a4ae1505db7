// Where calls go. A channel carries one module's messages: over a socket, or straight into a service linked
// in this process. Callers see typed calls and cannot tell which it is.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "rpc/codec.hpp"
#include "rpc/message.hpp"
#include "rpc/unique_fd.hpp"

namespace animado::rpc {

class Channel {
 public:
  virtual ~Channel() = default;

  // Sends M's request and waits for its reply. Errors come back as animado::Error with the service's code,
  // message, where and remedy; Code::unavailable when the service cannot be reached within the time limit.
  // Requests are repeatable: a channel that loses its server looks it up again and sends the request once
  // more.
  template <class M>
  typename M::Reply call(const typename M::Request& request) {
    typename M::Reply reply;
    exchange(codec<M>(), &request, &reply);
    return reply;
  }

  // Many requests of one kind, sent one after the other without waiting for each reply: a few times as many
  // in a second. They are served in order; one that gets an error stops none of the others.
  template <class M>
  struct Answer {
    typename M::Reply reply{};
    std::optional<Error> error{};
  };
  template <class M>
  std::vector<Answer<M>> call_all(std::span<const typename M::Request> requests) {
    std::vector<Answer<M>> answers(requests.size());
    std::vector<Exchange> exchanges;
    for (size_t i = 0; i < requests.size(); ++i)
      exchanges.push_back({&requests[i], &answers[i].reply, &answers[i].error});
    exchange_all(codec<M>(), exchanges);
    return answers;
  }

  // The descriptor that came with the last reply (shared arrays), if any.
  virtual UniqueFd take_descriptor() = 0;

  // Waits for a notification of that kind. False when none came in time; Code::unavailable when the
  // connection was lost, and with it what was asked to be watched: ask again.
  template <class M>
  bool wait_notification(typename M::Request& request, double timeout_s) {
    return next_notification(codec<M>(), &request, timeout_s);
  }

 protected:
  virtual void exchange(const MessageCodec& message, const void* request, void* reply) = 0;
  struct Exchange {
    const void* request;
    void* reply;
    std::optional<Error>* error;
  };
  virtual void exchange_all(const MessageCodec& message, std::span<const Exchange> exchanges);
  virtual bool next_notification(const MessageCodec&, void*, double) { return false; }
};

class SharedArrays;

// The other modules, as one of them sees them: sockets found through interexpserv, or services in this
// process.
class Suite {
 public:
  virtual ~Suite() = default;
  virtual Channel& channel(std::string_view service) = 0;  // "egesp", "fred", "colisao", "interexpserv"
  virtual SharedArrays& arrays() = 0;
};

}  // namespace animado::rpc
