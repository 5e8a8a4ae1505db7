// Packing and the words for types. Reading is in unpack.cpp, text in summary.cpp and json.cpp.
#include "rpc/codec.hpp"

#include <fmt/format.h>

#include "rpc/decoder.hpp"
#include "rpc/encoder.hpp"

namespace animado::rpc {
namespace {

const void* member(const Field& field, const void* record) {
  return static_cast<const char*>(record) + field.offset;
}

bool is_left_out(const Field& field, const void* record) {
  return field.type->kind == Type::Kind::optional && field.type->content(member(field, record)) == nullptr;
}

void pack_array(const Array& array, Encoder& out) {
  out.map(array.is_shared() ? 3 : 2);
  out.text("shape");
  out.list(array.shape.size());
  for (int64_t extent : array.shape) out.integer(extent);
  if (array.is_shared()) {
    out.text("shared");
    out.text(array.shared);
    out.text("offset");
    out.integer(array.offset);
  } else {
    out.text("data");
    out.numbers(array.values);
  }
}

size_t count_fields(const Type& type, const void* value) {
  size_t count = type.fields.size();
  for (const Field& field : type.fields) count -= is_left_out(field, value);
  return count;
}

void pack_fields(const Type& type, const void* value, Encoder& out) {
  for (const Field& field : type.fields) {
    if (is_left_out(field, value)) continue;
    out.text(field.name);
    pack(*field.type, member(field, value), out);
  }
}

void pack_list(const Type& type, const void* value, Encoder& out) {
  const size_t count = type.count(value);
  const auto* at = static_cast<const char*>(type.elements(value));
  out.list(count);
  for (size_t i = 0; i < count; ++i) pack(*type.element, at + i * type.element->size, out);
}

}  // namespace

void pack(const Type& type, const void* value, Encoder& out) {
  switch (type.kind) {
    case Type::Kind::boolean:
      return out.boolean(*static_cast<const bool*>(value));
    case Type::Kind::integer:
      return out.integer(*static_cast<const int64_t*>(value));
    case Type::Kind::number:
      return out.number(*static_cast<const double*>(value));
    case Type::Kind::text:
      return out.text(*static_cast<const std::string*>(value));
    case Type::Kind::choice:
      return out.text(type.names[static_cast<size_t>(type.choice(value))]);
    case Type::Kind::array:
      return pack_array(*static_cast<const Array*>(value), out);
    case Type::Kind::record:
      out.map(count_fields(type, value));
      return pack_fields(type, value, out);
    case Type::Kind::list:
      return pack_list(type, value, out);
    case Type::Kind::optional:
      if (const void* content = type.content(value)) return pack(*type.element, content, out);
      return out.nil();
  }
}

void pack_params(const Type& type, const void* request, const Marks& marks, Encoder& out) {
  out.map(count_fields(type, request) + 1 + !marks.trace.empty());
  if (!marks.trace.empty()) {
    out.text("_trace");
    out.text(marks.trace);
  }
  out.text("_seq");
  out.integer(marks.seq);
  pack_fields(type, request, out);
}

std::string type_text(const Type& type) {
  switch (type.kind) {
    case Type::Kind::boolean:
      return "boolean";
    case Type::Kind::integer:
      return "integer";
    case Type::Kind::number:
      return "number";
    case Type::Kind::text:
      return "text";
    case Type::Kind::choice:
      return fmt::format("one of {}", fmt::join(type.names, ", "));
    case Type::Kind::array:
      return "array";
    case Type::Kind::record:
      return "map";
    case Type::Kind::list:
      return "list of " + type_text(*type.element);
    case Type::Kind::optional:
      return type_text(*type.element);
  }
  return {};
}

}  // namespace animado::rpc
