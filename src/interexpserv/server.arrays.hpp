// The shared arrays of INTEREXPSERV, and pictures of them. Beside server.cpp, since descriptors travel with
// messages.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "interexpserv/protocol.hpp"
#include "rpc/service.hpp"
#include "rpc/shared_array.hpp"

namespace animado::interexpserv {

using rpc::ConnectionId;
using rpc::SharedArray;

// The shared arrays, each held for the connection that made it or handed it back last.
class ArrayTable {
 public:
  const SharedArray& create(const std::string& name, const std::vector<int64_t>& shape, ConnectionId owner);
  void adopt(const std::string& name, const std::vector<int64_t>& shape, rpc::UniqueFd fd,
             ConnectionId owner);
  const SharedArray& find(const std::string& name) const;  // throws unknown_array
  void release(const std::string& name) { arrays_.erase(name); }
  void end(ConnectionId owner);
  ArrayList::Reply list() const;

 private:
  struct Entry {
    SharedArray array;
    ConnectionId owner;
  };
  const SharedArray& add(const std::string& name, SharedArray array, ConnectionId owner);

  std::map<std::string, Entry, std::less<>> arrays_;
};

// One consistent picture of each array that a request reads, taken when it is first needed.
class Pictures {
 public:
  explicit Pictures(const ArrayTable& arrays) : arrays_(arrays) {}
  std::span<const double> operator()(const std::string& name);

 private:
  std::vector<double> take(const std::string& name) const;

  const ArrayTable& arrays_;
  std::map<std::string, std::vector<double>> taken_;
};

}  // namespace animado::interexpserv
