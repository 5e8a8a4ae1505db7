// The text of a message in a log line.
#include <fmt/format.h>

#include <iterator>

#include "rpc/codec.hpp"

namespace animado::rpc {
namespace {

constexpr size_t kMaxText = 60;   // characters of a text that a log line shows
constexpr size_t kMaxListed = 4;  // a longer list shows as its length

void append_text(std::string_view text, std::string& out) {
  out += '"';
  append_printable(text.substr(0, kMaxText), out);
  out += text.size() > kMaxText ? "…\"" : "\"";
}

void append_array(const Array& array, std::string& out) {
  if (array.is_shared()) {
    out += '@';
    append_text(array.shared, out);
  }
  out += '(';
  for (size_t k = 0; k < array.shape.size(); ++k) {
    if (k > 0) out += ',';
    append_integer(array.shape[k], out);
  }
  out += ')';
}

void append_value(const Type& type, const void* value, std::string& out);

void append_record(const Type& type, const void* value, std::string& out) {
  bool first = true;
  for (const Field& field : type.fields) {
    const void* member = static_cast<const char*>(value) + field.offset;
    if (field.type->kind == Type::Kind::optional && field.type->content(member) == nullptr) continue;
    if (!first) out += ' ';
    first = false;
    out += field.name;
    out += '=';
    append_value(*field.type, member, out);
  }
}

void append_list(const Type& type, const void* value, std::string& out) {
  const size_t count = type.count(value);
  const auto* at = static_cast<const char*>(type.elements(value));
  out += '[';
  if (count > kMaxListed || type.element->kind == Type::Kind::record) {
    append_integer(static_cast<int64_t>(count), out);
  } else {
    for (size_t i = 0; i < count; ++i) {
      if (i > 0) out += ' ';
      append_value(*type.element, at + i * type.element->size, out);
    }
  }
  out += ']';
}

void append_value(const Type& type, const void* value, std::string& out) {
  switch (type.kind) {
    case Type::Kind::boolean:
      out += *static_cast<const bool*>(value) ? "true" : "false";
      return;
    case Type::Kind::integer:
      return append_integer(*static_cast<const int64_t*>(value), out);
    case Type::Kind::number:
      fmt::format_to(std::back_inserter(out), "{}", *static_cast<const double*>(value));
      return;
    case Type::Kind::text:
      return append_text(*static_cast<const std::string*>(value), out);
    case Type::Kind::choice:
      out += type.names[static_cast<size_t>(type.choice(value))];
      return;
    case Type::Kind::array:
      return append_array(*static_cast<const Array*>(value), out);
    case Type::Kind::record:
      out += '{';
      append_record(type, value, out);
      out += '}';
      return;
    case Type::Kind::list:
      return append_list(type, value, out);
    case Type::Kind::optional:
      if (const void* content = type.content(value)) return append_value(*type.element, content, out);
      out += '-';
      return;
  }
}

}  // namespace

void append_printable(std::string_view text, std::string& out) {
  const size_t begin = out.size();
  out += text;
  for (char& c : std::span(out).subspan(begin))
    c = static_cast<unsigned char>(c) < ' ' || c == 0x7f ? '?' : c;
}

void append_integer(int64_t value, std::string& out) {
  const fmt::format_int digits(value);
  out.append(digits.data(), digits.size());
}

void summarize(const Type& type, const void* value, std::string& out) {
  type.kind == Type::Kind::record ? append_record(type, value, out) : append_value(type, value, out);
}

}  // namespace animado::rpc
