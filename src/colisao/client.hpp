// COLISÃO as other modules see it: typed calls over a channel. The client remembers its bodies: when the
// server was restarted and does not know them, it prepares them again and repeats the request. Requests need
// no handle: the client fills it in.
#pragma once

#include "colisao/protocol.hpp"
#include "rpc/channel.hpp"
#include "rpc/prepared.hpp"

namespace animado::colisao {

class Client {
 public:
  explicit Client(rpc::Channel& channel) : channel_(channel) {}

  // Makes the bodies known; the other calls are about them.
  void prepare(Prepare::Request bodies) {
    bodies_ = std::move(bodies);
    prepare();
  }

  Contacts::Reply contacts(Contacts::Request request) { return ask<Contacts>(std::move(request)); }
  Sweep::Reply sweep(Sweep::Request request) { return ask<Sweep>(std::move(request)); }
  Respond::Reply respond(Respond::Request request) { return ask<Respond>(std::move(request)); }
  Advance::Reply advance(Advance::Request request) { return ask<Advance>(std::move(request)); }
  Springs::Reply springs(Springs::Request request) { return ask<Springs>(std::move(request)); }

 private:
  template <class M>
  typename M::Reply ask(typename M::Request request) {
    return rpc::ask_prepared([this] { prepare(); },
                             [&] {
                               request.handle = handle_;
                               return channel_.call<M>(request);
                             });
  }
  void prepare() { handle_ = channel_.call<Prepare>(bodies_).handle; }

  rpc::Channel& channel_;
  Prepare::Request bodies_;
  std::string handle_;
};

}  // namespace animado::colisao
