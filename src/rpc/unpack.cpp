// Reading a message into its struct, and every way in which that may be refused.
#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "base/error.hpp"
#include "base/nearest_name.hpp"
#include "base/number_text.hpp"
#include "rpc/codec.hpp"
#include "rpc/decoder.hpp"

namespace animado::rpc {
namespace {

using Kind = Head::Kind;

constexpr size_t kMaxDimensions = 8;  // protocols use 4 at most
constexpr int64_t kMaxElements =
    int64_t{1} << 40;  // 8 TiB: a shape beyond it is a mistake, and products stay far from overflow

// Where we are: solve.bodies[3].mass_kg. Lives on the stack; text is made only for an error.
struct Path {
  const Path* up = nullptr;
  std::string_view name;
  size_t index = 0;  // of a list element, which has no name

  std::string text() const {
    if (up == nullptr) return std::string(name);
    return name.empty() ? fmt::format("{}[{}]", up->text(), index) : fmt::format("{}.{}", up->text(), name);
  }
};

[[noreturn]] void refuse_type(const Path& path, std::string_view expected, Kind found) {
  throw Error(Code::bad_params, fmt::format("expected {}, found {}", expected, name_of(found)), path.text(),
              "the message describe lists the fields of every message with their types");
}

[[noreturn]] void refuse_shape(const Path& path, std::string message) {
  throw Error(Code::bad_shape, std::move(message), path.text(),
              "shape lists the extents; data holds their product of float64 numbers in row-major order");
}

void check_finite(double value, const Path& path, const Decoder& in) {
  if (!in.finite_only() || std::isfinite(value)) return;
  throw Error(Code::not_finite, number_text(value) + " is not a finite number", path.text(),
              "send finite numbers only");
}

double read_number(Decoder& in, const Path& path) {
  const Head head = in.next();
  if (head.kind != Kind::number && head.kind != Kind::integer) refuse_type(path, "a number", head.kind);
  const double value = head.kind == Kind::number ? head.number : static_cast<double>(head.integer);
  check_finite(value, path, in);
  return value;
}

Head read(Decoder& in, Kind kind, std::string_view expected, const Path& path) {
  const Head head = in.next();
  if (head.kind != kind) refuse_type(path, expected, head.kind);
  return head;
}

std::string_view read_text(Decoder& in, const Path& path) {
  return in.body(read(in, Kind::text, "text", path));
}

// --- arrays

std::vector<int64_t> read_shape(Decoder& in, const Path& path) {
  const Head list = read(in, Kind::list, "a list of extents", path);
  if (list.count > kMaxDimensions)
    refuse_shape(path, fmt::format("{} extents, more than {}", list.count, kMaxDimensions));
  std::vector<int64_t> shape;
  shape.reserve(list.count);
  int64_t elements = 1;
  for (size_t i = 0; i < list.count; ++i) {
    const int64_t extent = read(in, Kind::integer, "an integer", {&path, {}, i}).integer;
    if (extent < 0) refuse_shape(path, fmt::format("extent {} is negative", extent));
    shape.push_back(extent);
    // An extent of 0 must not hide an impossible one beside it.
    if (extent > kMaxElements / elements)
      refuse_shape(path, fmt::format("more than {} elements", kMaxElements));
    elements *= std::max<int64_t>(extent, 1);
  }
  return shape;
}

// Numbers as nested lists, as a person types them. Finds the shape on the way.
void read_nested(Decoder& in, const Path& path, size_t depth, Array& array) {
  const Head head = in.peek();
  if (head.kind != Kind::list) {
    if (depth != array.shape.size()) refuse_shape(path, "the lists are not all of one depth");
    array.values.push_back(read_number(in, path));
    return;
  }
  in.next();
  const auto extent = static_cast<int64_t>(head.count);
  if (depth == array.shape.size() && array.values.empty()) {
    if (depth == kMaxDimensions)
      refuse_shape(path, fmt::format("lists nested more than {} deep", kMaxDimensions));
    array.shape.push_back(extent);
  }
  if (depth >= array.shape.size() || array.shape[depth] != extent)
    refuse_shape(path, "the lists are not all of one length");
  for (size_t i = 0; i < head.count; ++i) read_nested(in, {&path, {}, i}, depth + 1, array);
}

void read_bytes(Decoder& in, const Path& path, std::vector<double>& values) {
  const std::string_view bytes = in.body(in.next());
  if (bytes.size() % sizeof(double) != 0) {
    refuse_shape(path, fmt::format("{} bytes are not a whole number of float64", bytes.size()));
  }
  values.resize(bytes.size() / sizeof(double));
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  if (!in.finite_only()) return;
  for (size_t i = 0; i < values.size(); ++i) check_finite(values[i], {&path, {}, i}, in);
}

void read_array_map(Decoder& in, const Path& path, Array& array) {
  const Head map = in.next();
  bool has_shape = false, has_data = false;
  for (size_t i = 0; i < map.count; ++i) {
    const std::string_view key = read_text(in, path);
    const Path here{&path, key};
    if (key == "shape") {
      array.shape = read_shape(in, here);
      has_shape = true;
    } else if (key == "data") {
      has_data = true;
      if (in.peek().kind == Kind::bytes) {
        read_bytes(in, here, array.values);
      } else {
        const Head list = read(in, Kind::list, "bytes of float64, or a list of numbers", here);
        for (size_t k = 0; k < list.count; ++k) array.values.push_back(read_number(in, {&here, {}, k}));
      }
    } else if (key == "shared") {
      array.shared = read_text(in, here);
    } else if (key == "offset") {
      array.offset = read(in, Kind::integer, "an integer", here).integer;
    } else {
      throw Error(Code::bad_params, "an array has no such key", here.text(),
                  "an array is {shape, data} or {shape, shared, offset}");
    }
  }
  if (has_data == array.is_shared()) {
    throw Error(Code::bad_params, "an array holds either data or the name of a shared array", path.text(),
                "an array is {shape, data} or {shape, shared, offset}");
  }
  if (!has_shape) {
    if (array.is_shared())
      throw Error(Code::bad_params, "a shared array needs its shape", path.text(), "add the key shape");
    array.shape = {static_cast<int64_t>(array.values.size())};
  }
}

void read_array(Decoder& in, const Path& path, Array& array) {
  array = {};
  const Kind kind = in.peek().kind;
  if (kind == Kind::list) return read_nested(in, path, 0, array);
  if (kind != Kind::map)
    refuse_type(path, "an array ({shape, data}, {shape, shared, offset} or nested lists)", kind);
  read_array_map(in, path, array);
  if (array.offset < 0 || array.offset > kMaxElements)
    refuse_shape(path, fmt::format("offset {} is impossible", array.offset));
  if (array.shape.empty() && array.values.empty()) return;  // no array: what a reply leaves out
  if (!array.is_shared() && array.count() != static_cast<int64_t>(array.values.size())) {
    refuse_shape(path, fmt::format("shape ({}) needs {} numbers, data holds {}", fmt::join(array.shape, ", "),
                                   array.count(), array.values.size()));
  }
}

// --- everything else

void read_value(const Type& type, Decoder& in, void* value, const Path& path);

[[noreturn]] void refuse_unknown(const Type& type, std::string_view key, const Path& path) {
  std::vector<std::string> known;
  for (const Field& field : type.fields) known.emplace_back(field.name);
  const std::string near = nearest_name(key, known);
  const std::string fields =
      known.empty() ? "there are no fields" : fmt::format("fields: {}", fmt::join(known, ", "));
  throw Error(Code::bad_params, fmt::format("there is no field '{}'", key), path.text(),
              near.empty() ? fields : fmt::format("did you mean '{}'? {}", near, fields));
}

// Senders that walk the same list send the fields in its order, so the one after the last found is tried
// first.
size_t find_field(const Type& type, std::string_view key, size_t likely) {
  if (likely < type.fields.size() && type.fields[likely].name == key) return likely;
  size_t i = 0;
  while (i < type.fields.size() && type.fields[i].name != key) ++i;
  return i;
}

bool read_mark(Decoder& in, std::string_view key, const Path& path) {
  if (path.up != nullptr || key.empty() || key[0] != '_') return false;
  if (key == "_trace") {
    in.marks.trace = read_text(in, {&path, key});
  } else if (key == "_seq") {
    in.marks.seq = read(in, Kind::integer, "an integer", {&path, key}).integer;
  } else {
    return false;
  }
  return true;
}

void read_record(const Type& type, Decoder& in, void* value, const Path& path) {
  const Head map = read(in, Kind::map, "a map of fields", path);
  uint64_t seen = 0;
  size_t likely = 0;
  for (size_t i = 0; i < map.count; ++i) {
    const std::string_view key = read_text(in, path);
    const size_t at = find_field(type, key, likely);
    if (at == type.fields.size()) {
      if (read_mark(in, key, path)) continue;
      refuse_unknown(type, key, path);
    }
    const Field& field = type.fields[at];
    const Path here{&path, field.name};
    if (seen >> at & 1)
      throw Error(Code::bad_params, "the field is given twice", here.text(), "give it once");
    seen |= uint64_t{1} << at;
    likely = at + 1;
    read_value(*field.type, in, static_cast<char*>(value) + field.offset, here);
  }
  for (size_t at = 0; at < type.fields.size(); ++at) {
    const Field& field = type.fields[at];
    if (field.required && !(seen >> at & 1)) {
      throw Error(Code::bad_params, "the field is missing", Path{&path, field.name}.text(),
                  fmt::format("add '{}': {} ({})", field.name, field.doc, type_text(*field.type)));
    }
  }
}

void read_choice(const Type& type, Decoder& in, void* value, const Path& path) {
  const std::string_view name = read_text(in, path);
  const auto found = std::find(type.names.begin(), type.names.end(), name);
  if (found == type.names.end()) {
    throw Error(Code::bad_params, fmt::format("there is no '{}' here", name), path.text(), type_text(type));
  }
  type.choose(value, found - type.names.begin());
}

void read_list(const Type& type, Decoder& in, void* value, const Path& path) {
  const size_t count = read(in, Kind::list, "a list", path).count;
  auto* at = static_cast<char*>(type.resize(value, count));
  for (size_t i = 0; i < count; ++i)
    read_value(*type.element, in, at + i * type.element->size, {&path, {}, i});
}

void read_optional(const Type& type, Decoder& in, void* value, const Path& path) {
  if (in.peek().kind == Kind::nil) {
    in.next();
  } else {
    read_value(*type.element, in, type.emplace(value), path);
  }
}

void read_value(const Type& type, Decoder& in, void* value, const Path& path) {
  switch (type.kind) {
    case Type::Kind::boolean:
      *static_cast<bool*>(value) = read(in, Kind::boolean, "a boolean", path).integer != 0;
      return;
    case Type::Kind::integer:
      *static_cast<int64_t*>(value) = read(in, Kind::integer, "an integer", path).integer;
      return;
    case Type::Kind::number:
      *static_cast<double*>(value) = read_number(in, path);
      return;
    case Type::Kind::text:
      *static_cast<std::string*>(value) = read_text(in, path);
      return;
    case Type::Kind::choice:
      return read_choice(type, in, value, path);
    case Type::Kind::array:
      return read_array(in, path, *static_cast<Array*>(value));
    case Type::Kind::record:
      return read_record(type, in, value, path);
    case Type::Kind::list:
      return read_list(type, in, value, path);
    case Type::Kind::optional:
      return read_optional(type, in, value, path);
  }
}

}  // namespace

void unpack(const Type& type, Decoder& in, void* value, std::string_view where) {
  read_value(type, in, value, {nullptr, where});
}

}  // namespace animado::rpc
