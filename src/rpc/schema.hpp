// What a message is made of, as data. `fields` of a message struct is walked once, on a default-constructed
// value, and leaves a table of names, types and offsets. Packing, unpacking, logs, JSON and the manual page
// are ordinary functions over that table: they are compiled once, whatever the number of messages.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "rpc/message.hpp"

namespace animado::rpc {

struct Type;

struct Field {
  std::string_view name, doc;
  const Type* type;
  size_t offset;  // of the member in its struct
  bool required;
};

using Value = std::unique_ptr<void, void (*)(void*)>;

// A C++ type of which only the table is known. Pointers are to values of that type.
struct Type {
  enum class Kind { boolean, integer, number, text, choice, array, record, list, optional };
  Kind kind;
  size_t size = 0;
  Value (*make)() = nullptr;  // a default-constructed value

  std::vector<Field> fields = {};                // record
  std::span<const std::string_view> names = {};  // choice
  int64_t (*choice)(const void*) = nullptr;      // choice: index into names
  void (*choose)(void*, int64_t) = nullptr;      // choice
  const Type* element = nullptr;                 // list, optional
  size_t (*count)(const void*) = nullptr;        // list
  const void* (*elements)(const void*) =
      nullptr;                               // list: the first of count values, each element->size apart
  void* (*resize)(void*, size_t) = nullptr;  // list: that many default values, and nothing of what was there
  const void* (*content)(const void*) = nullptr;  // optional: the value, or null
  void* (*emplace)(void*) = nullptr;              // optional: makes a default value
};

template <class T>
const Type& type_of();

namespace schema {

template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};
template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};

template <class T>
Type plain(Type::Kind kind) {
  return {kind, sizeof(T), [] { return Value(new T(), [](void* value) { delete static_cast<T*>(value); }); }};
}

template <class T>
Type record() {
  Type type = plain<T>(Type::Kind::record);
  T sample{};
  const auto add = [&]<class Member>(const char* name, Member& member, const char* doc, auto... has_default) {
    const auto offset = reinterpret_cast<const char*>(&member) - reinterpret_cast<const char*>(&sample);
    const bool required = sizeof...(has_default) == 0 && !IsOptional<Member>::value;
    type.fields.push_back({name, doc, &type_of<Member>(), static_cast<size_t>(offset), required});
  };
  T::fields(sample, add);
  assert(type.fields.size() <= 64 && "unpacking marks the fields that it has seen in 64 bits");
  return type;
}

template <class T>
Type list() {
  using Element = typename T::value_type;
  static_assert(!std::is_same_v<Element, bool>, "std::vector<bool> holds no bools");
  Type type = plain<T>(Type::Kind::list);
  type.element = &type_of<Element>();
  type.count = [](const void* value) { return static_cast<const T*>(value)->size(); };
  type.elements = [](const void* value) -> const void* { return static_cast<const T*>(value)->data(); };
  type.resize = [](void* value, size_t count) -> void* {
    auto& vector = *static_cast<T*>(value);
    vector.clear();
    vector.resize(count);
    return vector.data();
  };
  return type;
}

template <class T>
Type optional() {
  Type type = plain<T>(Type::Kind::optional);
  type.element = &type_of<typename T::value_type>();
  type.content = [](const void* value) -> const void* {
    const auto& optional = *static_cast<const T*>(value);
    return optional ? &*optional : nullptr;
  };
  type.emplace = [](void* value) -> void* { return &static_cast<T*>(value)->emplace(); };
  return type;
}

template <class T>
Type choice() {
  static constexpr auto kNames = names(static_cast<const T*>(nullptr));
  Type type = plain<T>(Type::Kind::choice);
  type.names = kNames;
  type.choice = [](const void* value) { return static_cast<int64_t>(*static_cast<const T*>(value)); };
  type.choose = [](void* value, int64_t index) { *static_cast<T*>(value) = static_cast<T>(index); };
  return type;
}

template <class T>
Type describe() {
  if constexpr (std::is_same_v<T, bool>) {
    return plain<T>(Type::Kind::boolean);
  } else if constexpr (std::is_same_v<T, int64_t>) {
    return plain<T>(Type::Kind::integer);
  } else if constexpr (std::is_same_v<T, double>) {
    return plain<T>(Type::Kind::number);
  } else if constexpr (std::is_same_v<T, std::string>) {
    return plain<T>(Type::Kind::text);
  } else if constexpr (std::is_same_v<T, Array>) {
    return plain<T>(Type::Kind::array);
  } else if constexpr (std::is_enum_v<T>) {
    return choice<T>();
  } else if constexpr (IsVector<T>::value) {
    return list<T>();
  } else if constexpr (IsOptional<T>::value) {
    return optional<T>();
  } else {
    return record<T>();
  }
}

}  // namespace schema

template <class T>
const Type& type_of() {
  static const Type type = schema::describe<T>();
  return type;
}

}  // namespace animado::rpc
