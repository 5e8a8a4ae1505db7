#include "rpc/wire.hpp"

#include <fmt/format.h>

#include "rpc/codec.hpp"

namespace animado::rpc {
namespace {

struct ErrorMap {
  std::string code, message, where, remedy;
  template <class Self, class F>
  static void fields(Self& s, F&& field) {
    field("code", s.code, "of the list");
    field("message", s.message, "what is wrong");
    field("where", s.where, "where it is wrong", kDefault);
    field("remedy", s.remedy, "what to do about it", kDefault);
  }
};

[[noreturn]] void refuse(std::string_view what) {
  throw Error(Code::protocol, fmt::format("this is not MessagePack-RPC: {}", what), {},
              "send [0, id, method, [params]] with params a map");
}

[[noreturn]] void refuse_kind(std::string_view what, Head::Kind found) {
  refuse(fmt::format("{} is {}", what, name_of(found)));
}

Head expect(Decoder& in, Head::Kind kind, std::string_view what) {
  const Head head = in.next();
  if (head.kind != kind) refuse_kind(what, head.kind);
  return head;
}

std::string_view read_params(Decoder& in) {
  constexpr std::string_view kNoFields = "\x80";
  const Head list = expect(in, Head::Kind::list, "params");
  if (list.count == 0) return kNoFields;
  if (list.count > 1) refuse("params holds more than one value");
  return in.rest();
}

void read_parts(Decoder& in, Envelope& envelope) {
  const Head list = expect(in, Head::Kind::list, "the message");
  const int64_t kind = list.count == 0 ? -1 : expect(in, Head::Kind::integer, "the kind of message").integer;
  if (kind < 0 || kind > 2) refuse("the kind of message is not 0, 1 or 2");
  envelope.kind = static_cast<Envelope::Kind>(kind);
  if (list.count != (envelope.kind == Envelope::Kind::notification ? 3u : 4u))
    refuse("the message has a wrong number of parts");
  if (envelope.kind != Envelope::Kind::notification)
    envelope.id = expect(in, Head::Kind::integer, "the id").integer;
  if (envelope.kind == Envelope::Kind::reply) {
    if (in.peek().kind != Head::Kind::nil) {
      envelope.error = in.skip();
    } else {
      in.next();
    }
    envelope.body = in.rest();
  } else {
    envelope.method = in.body(expect(in, Head::Kind::text, "the method"));
    envelope.body = read_params(in);
  }
}

}  // namespace

void read_envelope(std::string_view message, Envelope& envelope) {
  Decoder in(message);
  read_parts(in, envelope);
}

int64_t id_in(std::string_view beginning) {
  Envelope envelope;
  try {
    read_envelope(beginning, envelope);
  } catch (const Error&) {  // it ends too early, as it must; what was before has been read
  }
  return envelope.id;
}

void begin_request(int64_t id, std::string_view method, Encoder& out) {
  out.list(4);
  out.integer(0);
  out.integer(id);
  out.text(method);
  out.list(1);
}

void begin_notification(std::string_view method, Encoder& out) {
  out.list(3);
  out.integer(2);
  out.text(method);
  out.list(1);
}

void begin_result(int64_t id, Encoder& out) {
  out.list(4);
  out.integer(1);
  out.integer(id);
  out.nil();
}

void write_error(int64_t id, const Error& error, Encoder& out) {
  out.list(4);
  out.integer(1);
  out.integer(id);
  const ErrorMap map{std::string(name_of(error.code())), error.message(), error.where(), error.remedy()};
  pack(type_of<ErrorMap>(), &map, out);
  out.nil();
}

Error read_error(std::string_view packed) {
  ErrorMap map;
  Decoder in(packed);
  unpack(type_of<ErrorMap>(), in, &map, "error");
  return {code_named(map.code), map.message, map.where, map.remedy};
}

}  // namespace animado::rpc
