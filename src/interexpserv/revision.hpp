// What a name was made to stand for, when and by whom.
#pragma once

#include <cstdint>
#include <string>

#include "interexpserv/value.hpp"

namespace animado::interexpserv {

// Component k of a bound name is element `element + k * stride` of the array.
struct Binding {
  std::string array;
  int64_t element = 0;
  int64_t stride = 1;
  bool operator==(const Binding&) const = default;
};

struct Revision {
  enum class Kind { definition, binding, removed };
  Kind kind = Kind::definition;
  Type type = Type::scalar;  // of a definition it follows from the text
  std::string text = {};     // of a definition
  Binding binding = {};
  int64_t version = 0;  // of the registry, which this change made
  int64_t time_us = 0;  // since 1970, UTC
  std::string who = {};
  bool operator==(const Revision&) const = default;
};

struct NamedRevision {
  std::string name;
  Revision revision;
  bool operator==(const NamedRevision&) const = default;
};

constexpr size_t kRevisionsKept =
    16;  // of a name, the present one included: what a person would look back at

}  // namespace animado::interexpserv
