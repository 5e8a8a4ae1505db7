// MessagePack-RPC: requests [0, id, method, [params]], replies [1, id, error, result], notifications [2,
// method, [params]]. params holds one map; error is nil or a map {code, message, where, remedy}.
#pragma once

#include <string_view>

#include "base/error.hpp"
#include "rpc/decoder.hpp"
#include "rpc/encoder.hpp"

namespace animado::rpc {

struct Envelope {
  enum class Kind { request = 0, reply = 1, notification = 2 };
  Kind kind = Kind::request;
  int64_t id = 0;
  std::string_view method;
  std::string_view body;   // packed: the map of params, or the result
  std::string_view error;  // packed; empty when the reply is not an error
};

// Reads a message: one whole value, as Scanner found it. Throws Code::protocol when it is not
// MessagePack-RPC; the id is set as soon as it is known.
void read_envelope(std::string_view message, Envelope& envelope);

// The id of a request of which only the beginning has come; 0 when it is not known yet.
int64_t id_in(std::string_view beginning);

// Each is followed by one value: the map of params, or the result.
void begin_request(int64_t id, std::string_view method, Encoder& out);
void begin_notification(std::string_view method, Encoder& out);
void begin_result(int64_t id, Encoder& out);

void write_error(int64_t id, const Error& error, Encoder& out);  // a whole reply
Error read_error(std::string_view packed);

}  // namespace animado::rpc
