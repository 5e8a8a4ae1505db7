// FRED as other modules see it: typed calls over a channel.
#pragma once

#include "fred/protocol.hpp"
#include "rpc/channel.hpp"

namespace animado::fred {

class Client {
 public:
  explicit Client(rpc::Channel& channel) : channel_(channel) {}

  Methods::Reply methods() { return channel_.call<Methods>({}); }
  Stage::Reply stage(const Stage::Request& request) { return channel_.call<Stage>(request); }
  Estimate::Reply estimate(const Estimate::Request& request) { return channel_.call<Estimate>(request); }
  Dense::Reply dense(const Dense::Request& request) { return channel_.call<Dense>(request); }
  Integrate::Reply integrate(const Integrate::Request& request) { return channel_.call<Integrate>(request); }

 private:
  rpc::Channel& channel_;
};

}  // namespace animado::fred
