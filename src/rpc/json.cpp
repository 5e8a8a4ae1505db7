#include "rpc/json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "rpc/codec.hpp"
#include "rpc/decoder.hpp"
#include "rpc/encoder.hpp"

namespace animado::rpc {
namespace {

using Json = nlohmann::ordered_json;

Json numbers_of(std::string_view bytes) {
  Json list = Json::array();
  for (size_t at = 0; at + sizeof(double) <= bytes.size(); at += sizeof(double)) {
    double value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    list.push_back(value);
  }
  return list;
}

Json read(Decoder& in) {
  const Head head = in.next();
  switch (head.kind) {
    case Head::Kind::boolean:
      return head.integer != 0;
    case Head::Kind::integer:
      return head.integer;
    case Head::Kind::large:
      return static_cast<uint64_t>(head.integer);
    case Head::Kind::number:
      return head.number;
    case Head::Kind::text:
      return std::string(in.body(head));
    case Head::Kind::bytes:
      return numbers_of(in.body(head));
    case Head::Kind::extension:
      in.body(head);
      return nullptr;
    case Head::Kind::list: {
      Json list = Json::array();
      for (size_t i = 0; i < head.count; ++i) list.push_back(read(in));
      return list;
    }
    case Head::Kind::map: {
      Json map = Json::object();
      for (size_t i = 0; i < head.count; ++i) {
        const Json key = read(in);
        map[key.is_string() ? key.get<std::string>() : key.dump()] = read(in);
      }
      return map;
    }
    case Head::Kind::nil:
      return nullptr;
  }
  return nullptr;
}

void write(const Json& json, Encoder& out) {
  switch (json.type()) {
    case Json::value_t::boolean:
      return out.boolean(json.get<bool>());
    case Json::value_t::number_integer:
      return out.integer(json.get<int64_t>());
    case Json::value_t::number_unsigned:
      // What does not fit in 63 bits can only be meant as a number.
      if (json.get<uint64_t>() > INT64_MAX) return out.number(json.get<double>());
      return out.integer(json.get<int64_t>());
    case Json::value_t::number_float:
      return out.number(json.get<double>());
    case Json::value_t::string:
      return out.text(json.get_ref<const std::string&>());
    case Json::value_t::array:
      out.list(json.size());
      for (const Json& element : json) write(element, out);
      return;
    case Json::value_t::object:
      out.map(json.size());
      for (const auto& [key, element] : json.items()) {
        out.text(key);
        write(element, out);
      }
      return;
    default:
      return out.nil();
  }
}

}  // namespace

std::string json_of(std::string_view packed) {
  Decoder in(packed);
  return read(in).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string packed_of(std::string_view json) {
  std::string packed;
  Encoder out(packed);
  try {
    write(Json::parse(json), out);
  } catch (const Json::parse_error& error) {
    throw Error(Code::syntax, error.what(), fmt::format("byte {}", error.byte),
                "write JSON, as in {\"name\": 1.5}");
  }
  return packed;
}

std::string to_json(const Type& type, const void* value) {
  std::string packed;
  Encoder out(packed);
  pack(type, value, out);
  return json_of(packed);
}

void from_json(const Type& type, std::string_view json, void* value, std::string_view where) {
  const std::string packed = packed_of(json);
  Decoder in(packed, Numbers::finite);
  unpack(type, in, value, where);
}

}  // namespace animado::rpc
