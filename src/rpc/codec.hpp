// A message of a protocol without its C++ types, for whoever carries it: channels, servers, logs,
// documentation.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rpc/schema.hpp"

namespace animado::rpc {

class Encoder;
class Decoder;
struct Marks;

struct MessageCodec {
  std::string_view name, doc;
  const Type& request;
  const Type& reply;
};

template <class M>
const MessageCodec& codec() {
  static const MessageCodec codec{M::name, M::doc, type_of<typename M::Request>(),
                                  type_of<typename M::Reply>()};
  return codec;
}

// The codecs of a std::tuple of messages, in its order.
template <class Messages>
struct CodecsOf;
template <class... M>
struct CodecsOf<std::tuple<M...>> {
  static std::vector<const MessageCodec*> list() { return {&codec<M>()...}; }
};
template <class Messages>
std::vector<const MessageCodec*> codecs() {
  return CodecsOf<Messages>::list();
}

// Writes a value of the type. An optional field without a value is left out.
void pack(const Type& type, const void* value, Encoder& out);
// The same for the fields of a request, with the marks under their reserved keys.
void pack_params(const Type& type, const void* request, const Marks& marks, Encoder& out);

// Reads a value of the type into a default-constructed one. `where` opens the path in errors ("solve"):
// bad_params for a field that is unknown, missing or of the wrong type, bad_shape for an array whose shape is
// impossible or does not fit its numbers, not_finite for NaN or infinity when the decoder asks for finite
// numbers.
void unpack(const Type& type, Decoder& in, void* value, std::string_view where);

// One line for logs: name=value …, arrays as their shape, long lists as their length.
void summarize(const Type& type, const void* value, std::string& out);

// Appends text from outside so that a log line stays one line: control characters become '?'.
void append_printable(std::string_view text, std::string& out);
void append_integer(int64_t value, std::string& out);

// JSON text of a value; numbers of arrays are written in full, NaN and infinity as null.
std::string to_json(const Type& type, const void* value);
// Throws Code::syntax for text that is not JSON, and what unpack throws.
void from_json(const Type& type, std::string_view json, void* value, std::string_view where);

// The type in a reader's words: "integer", "list of text", "one of partial, complete".
std::string type_text(const Type& type);

}  // namespace animado::rpc
