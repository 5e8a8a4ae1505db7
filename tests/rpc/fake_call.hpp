// A service's handlers called directly, with shared arrays that are plain vectors of this process.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "rpc/channel.hpp"
#include "rpc/service.hpp"

namespace animado::rpc {

class FakeCall : public Call {
 public:
  std::map<std::string, std::vector<double>> shared;

  ConnectionId connection() const override { return 1; }
  std::span<const double> read(const Array& array) override {
    if (array.is_shared()) return write(array);
    if (array.count() != static_cast<int64_t>(array.values.size())) throw Error(Code::bad_shape, "too few");
    return array.values;
  }
  std::span<double> write(const Array& array) override {
    return std::span(shared.at(array.shared))
        .subspan(static_cast<size_t>(array.offset), static_cast<size_t>(array.count()));
  }
  void send_descriptor(int) override {}
};

// For a service that calls no other one.
class NoSuite : public Suite {
 public:
  Channel& channel(std::string_view) override { throw Error(Code::unavailable, "none"); }
  SharedArrays& arrays() override { throw Error(Code::unavailable, "none"); }
};

// What the service answers to a message M.
template <class M>
typename M::Reply ask(const Service& service, const typename M::Request& request, Call& call) {
  typename M::Reply reply;
  service.find(M::name)->handler(&request, &reply, call);
  return reply;
}

template <class M>
typename M::Reply ask(const Service& service, const typename M::Request& request) {
  FakeCall call;
  return ask<M>(service, request, call);
}

// The error that it answers; fails with Code::internal when there is none.
template <class M>
Error refusal(const Service& service, const typename M::Request& request) {
  try {
    ask<M>(service, request);
  } catch (const Error& error) {
    return error;
  }
  return Error(Code::internal, "accepted");
}

}  // namespace animado::rpc
