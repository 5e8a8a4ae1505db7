#include "rpc/service.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "base/error.hpp"
#include "rpc/encoder.hpp"
#include "rpc/wire.hpp"

namespace animado::rpc {

const Service::Entry* Service::find(std::string_view method) const {
  if (last_found_ != nullptr && last_found_->codec->name == method) return last_found_;
  const auto found = entries_.find(method);
  if (found == entries_.end()) return nullptr;
  return last_found_ = &found->second;
}

void Service::add(const MessageCodec& codec, Handler handler) {
  const bool added = entries_.try_emplace(std::string(codec.name), Entry{&codec, std::move(handler)}).second;
  assert(added && "two handlers for one message");
}

bool Service::notify(ConnectionId connection, const MessageCodec& message, const void* request) const {
  return post && post(connection, notification(message, request)) == Delivery::sent;
}

std::string notification(const MessageCodec& message, const void* request) {
  std::string packed;
  Encoder out(packed);
  begin_notification(message.name, out);
  pack(message.request, request, out);
  return packed;
}

Array deliver(Call& call, const std::optional<Array>& out, std::vector<int64_t> shape,
              std::vector<double> values) {
  if (!out) return Array::inlined(std::move(shape), std::move(values));
  const std::span<double> pages = call.write(*out);
  if (out->shape != shape) {
    throw Error(Code::bad_shape,
                fmt::format("the result has shape ({}), out has ({})", fmt::join(shape, ", "),
                            fmt::join(out->shape, ", ")),
                "out", "create the shared array with the shape of the result");
  }
  std::copy(values.begin(), values.end(), pages.begin());
  return *out;
}

}  // namespace animado::rpc
