// The registry of names: what each stands for, what depends on it, since which version.
//
// A name is defined by an expression, or bound to elements of a shared array that a running program
// publishes. A request changes all of its names or none. What has been accepted always compiles: a change
// that would break a definition that depends on it is refused, and so is a cycle.
//
// Dependence is kept as the names that were looked up while a definition was compiled, in vain or not: were
// one of those defined tomorrow (ball.k beside a global k), the definition would mean something else, and is
// compiled again.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "interexpserv/program.hpp"

namespace animado::interexpserv {

// Component k of a bound name is element `element + k * stride` of the array.
struct Binding {
  std::string array;
  int64_t element = 0;
  int64_t stride = 1;
  bool operator==(const Binding&) const = default;
};

// What a store keeps of a name.
struct NameRow {
  enum class Kind { definition, binding, removed };
  Kind kind = Kind::definition;
  std::string name, text;  // text of a definition
  Type type = Type::scalar;
  Binding binding;
  int64_t version = 0;  // when it last changed, by itself or through what it depends on
  bool operator==(const NameRow&) const = default;
};

struct NamedText {
  std::string name, text;
};

struct NamedBinding {
  std::string name;
  Type type = Type::scalar;
  Binding binding;
};

class Names {
 public:
  // Called before a change takes effect, with the rows that change; when it throws, nothing has changed.
  using Commit = std::function<void(int64_t version, std::span<const NameRow> rows)>;
  // The numbers of a shared array, one consistent picture. Throws when there is none.
  using Numbers = std::function<std::span<const double>(const std::string& array)>;

  Names() = default;
  explicit Names(Commit commit) : commit_(std::move(commit)) {}
  void restore(std::span<const NameRow> rows, int64_t version);

  // Each of these is one transaction. The rows that changed come back by name, dependents included; the
  // version grows by one if there are any: a request that is sent again changes nothing. Names may be written
  // with capitals and accents. Errors: syntax, type, unknown_name, cycle, limit with the name as `where`;
  // type also when a name that is defined would change its type; conflict when a live name is defined, a
  // defined one is bound, or one is removed that others need; bad_params for what is no name.
  std::vector<NameRow> define(std::span<const NamedText> definitions);
  std::vector<NameRow> bind(std::span<const NamedBinding> bindings);
  std::vector<NameRow> remove(std::span<const std::string> names);

  int64_t version() const { return version_; }
  const NameRow& row(std::string_view name) const;           // throws unknown_name with the nearest one
  std::vector<NameRow> rows(std::string_view prefix) const;  // by name
  std::vector<NameRow> changes(
      int64_t since_version) const;  // by version, then name; removed ones too, live ones not

  Value value(std::string_view name, const Numbers& numbers) const;
  Value evaluate(std::string_view text, std::string_view home, const Numbers& numbers) const;

 private:
  struct Entry {
    NameRow row;
    std::shared_ptr<const Program> program;  // of a definition
    std::set<std::string, std::less<>> looked_up;
  };
  using Entries = std::map<std::string, Entry, std::less<>>;
  class Lookup;
  class Undo;

  const Entry* find(std::string_view name) const;  // null when unknown or removed
  void compile_entry(Entry& entry) const;
  std::vector<NameRow> take_effect(Entries edits);
  Value run(const Program& program, const Numbers& numbers) const;
  void read(const Input& input, const Numbers& numbers, double* out) const;

  Commit commit_;
  Entries entries_;  // removed ones stay as rows, so that changes() can tell
  int64_t version_ = 0;
};

// Whether `name` is `prefix` or lies in that namespace; every name does in the empty one.
bool is_within(std::string_view name, std::string_view prefix);

}  // namespace animado::interexpserv
