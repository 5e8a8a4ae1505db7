// Typed calls to interexpserv, for the other modules. Over a socket or inside the process, as the channel is.
// Errors come as animado::Error with the codes that protocol.hpp lists.
#pragma once

#include <optional>
#include <utility>

#include "base/error.hpp"
#include "interexpserv/protocol.hpp"
#include "interexpserv/published.hpp"
#include "rpc/channel.hpp"

namespace animado::interexpserv {

class Client {
 public:
  explicit Client(rpc::Channel& channel) : channel_(channel) {}
  explicit Client(rpc::Suite& suite) : channel_(suite.channel("interexpserv")) {}

  // The version of the registry after the change. expected: as Define says; Code::conflict otherwise. A
  // request that was repeated because interexpserv died may meet its own change as a conflict: history tells
  // who made it.
  int64_t define(std::vector<Define::Definition> definitions, std::vector<Expected> expected = {}) {
    return channel_.call<Define>({std::move(definitions), std::move(expected)}).version;
  }
  int64_t set(std::string name, std::string text, std::optional<int64_t> expected = {}) {
    return channel_.call<Set>({std::move(name), std::move(text), expected}).version;
  }
  int64_t remove(std::vector<std::string> names, std::vector<Expected> expected = {}) {
    return channel_.call<Remove>({std::move(names), std::move(expected)}).version;
  }
  int64_t bind(std::vector<Bind::Bound> names) { return channel_.call<Bind>({std::move(names)}).version; }

  NameState get(std::string name) {
    Get::Reply reply = channel_.call<Get>({{std::move(name)}, {}});
    if (reply.names.size() != 1)
      throw Error(Code::protocol, "get of one name answered with another count", "get");
    return std::move(reply.names.front());
  }
  std::vector<NameState> get_within(std::string prefix) {
    return channel_.call<Get>({{}, std::move(prefix)}).names;
  }
  Evaluate::Reply evaluate(std::string text, std::string home = {}) {
    return channel_.call<Evaluate>({std::move(text), std::move(home)});
  }
  Changes::Reply changes(int64_t since) { return channel_.call<Changes>({since}); }

  std::vector<History::Revision> history(std::string name) {
    return channel_.call<History>({std::move(name)}).revisions;
  }
  Snapshot::Reply snapshot(std::string prefix = {}) { return channel_.call<Snapshot>({std::move(prefix)}); }
  Restore::Reply restore(Snapshot::Reply snapshot, std::string prefix = {}) {
    return channel_.call<Restore>({std::move(snapshot.names), std::move(snapshot.texts), std::move(prefix)});
  }

  Watch::Reply watch(std::string prefix) { return channel_.call<Watch>({std::move(prefix)}); }
  void unwatch(std::string prefix) { channel_.call<Unwatch>({std::move(prefix)}); }
  // False when nothing changed in time.
  bool wait_change(NameChanged::Request& change, double timeout_s) {
    return channel_.wait_notification<NameChanged>(change, timeout_s);
  }
  // Whether changes were lost because they were not waited for in time.
  bool fell_behind(FellBehind::Request& lost, double timeout_s = 0) {
    return channel_.wait_notification<FellBehind>(lost, timeout_s);
  }

  // A server of that name: each in turn.
  rpc::Lookup::Reply lookup(std::string service) { return channel_.call<rpc::Lookup>({std::move(service)}); }
  std::vector<List::Service> services() { return channel_.call<List>({}).services; }
  std::vector<ArrayList::Entry> arrays() { return channel_.call<ArrayList>({}).arrays; }
  void release_array(std::string name) { channel_.call<ArrayRelease>({std::move(name)}); }

 private:
  rpc::Channel& channel_;
};

}  // namespace animado::interexpserv
