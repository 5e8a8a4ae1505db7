// The registry of names: what each stands for, what depends on it, since which version.
//
// A name is defined by an expression, or bound to elements of a shared array that a running program
// publishes. A request changes all of its names or none. What has been accepted always compiles: a change
// that would break a definition that depends on it is refused, and so is a cycle.
//
// Dependence is kept as the names that were looked up while a definition was compiled, in vain or not: were
// one of those defined tomorrow (ball.k beside a global k), the definition would mean something else, and is
// compiled again. Every request takes a time that depends on what it changes, not on how many names there
// are.
#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "interexpserv/program.hpp"
#include "interexpserv/revision.hpp"

namespace animado::interexpserv {

// A name as it is now.
struct NameRow {
  using Kind = Revision::Kind;
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

// Who asks for a change, when, and which versions names must still have for it to be made (0: not there).
struct ExpectedVersion {
  std::string name;
  int64_t version = 0;
};
struct Terms {
  std::string who = {};
  int64_t time_us = 0;
  std::vector<ExpectedVersion> expected = {};
};

class Names {
 public:
  // Called before a change takes effect, with what it makes of the names that the request names; when it
  // throws, nothing has changed.
  using Commit = std::function<void(std::span<const NamedRevision> revisions)>;
  // The numbers of a shared array, one consistent picture. Throws when there is none.
  using Numbers = std::function<std::span<const double>(const std::string& array)>;

  Names() = default;
  explicit Names(Commit commit) : commit_(std::move(commit)) {}
  Names(Names&&) = default;
  Names& operator=(Names&&) = default;
  // What was committed in another life, those of one name in the order of their versions.
  void load(std::vector<NamedRevision> revisions);

  // Each of these is one transaction. The rows that changed come back by name, dependents included; the
  // version grows by one if there are any: a request that is sent again changes nothing. Names may be written
  // with capitals and accents. Errors: syntax, type, unknown_name, cycle, limit with the name as `where`;
  // type also when a name that is defined would change its type; conflict when a name has another version
  // than expected, a live name is defined, a defined one is bound, or one is removed that others need;
  // bad_params for what is no name.
  std::vector<NameRow> define(std::span<const NamedText> definitions, const Terms& terms = {});
  std::vector<NameRow> bind(std::span<const NamedBinding> bindings, const Terms& terms = {});
  std::vector<NameRow> remove(std::span<const std::string> names, const Terms& terms = {});
  // Makes the definitions within a prefix exactly these: others are removed, live names stay.
  std::vector<NameRow> replace(std::span<const NamedText> definitions, std::string_view prefix,
                               const Terms& terms = {});

  int64_t version() const { return version_; }
  size_t size() const { return entries_.size(); }            // removed ones too
  NameRow row(std::string_view name) const;                  // throws unknown_name with the nearest one
  std::vector<NameRow> rows(std::string_view prefix) const;  // by name
  std::vector<NamedText> definitions(std::string_view prefix) const;  // by name
  std::vector<NameRow> changes(
      int64_t since_version) const;  // by version, then name; removed ones too, live ones not
  // The last kRevisionsKept of a name, oldest first; of a removed one too. Throws unknown_name.
  std::vector<Revision> history(std::string_view name) const;

  Value value(std::string_view name, const Numbers& numbers) const;
  Value evaluate(std::string_view text, std::string_view home, const Numbers& numbers) const;

 private:
  // What follows from a definition and from the names that it uses.
  struct Meaning {
    int64_t version = 0;  // of the last change to it or to them
    Type type = Type::scalar;
    std::shared_ptr<const Program> program = {};  // null when it is a constant
    Value constant = {};
    std::vector<std::string> looked_up = {};  // sorted
  };
  struct Entry {
    Revision now;
    Meaning meaning;
    std::vector<Revision> past;                     // oldest first
    std::list<const std::string*>::iterator place;  // in changed_
  };
  using Entries = std::map<std::string, Entry, std::less<>>;
  using Edits = std::map<std::string, Revision>;
  class Lookup;
  class Undo;

  const Entry* find(std::string_view name) const;   // null when unknown or removed
  const Entry& known(std::string_view name) const;  // throws unknown_name
  std::vector<std::string> names_near(std::string_view name) const;
  int64_t version_of(std::string_view name) const;  // 0: not there
  void add_definitions(std::span<const NamedText> definitions, Edits& edits) const;
  void refuse_unexpected(std::span<const ExpectedVersion> expected) const;
  Meaning compiled(const std::string& name, const Revision& revision) const;
  void give_meaning(const std::string& name, Entry& entry, Meaning meaning);
  std::vector<NameRow> take_effect(Edits edits, const Terms& terms);
  std::set<std::string> affected_by(const Edits& edits) const;
  NameRow renew(const std::string& name, std::optional<Type> type, Undo& undo);
  template <class F>
  void for_each_within(std::string_view prefix, F&& visit) const;
  Value run(const Program& program, const Numbers& numbers) const;
  void read(const Input& input, const Numbers& numbers, double* out) const;

  Commit commit_;
  Entries entries_;  // removed ones stay, so that changes() can tell
  std::map<std::string, std::set<std::string>, std::less<>> users_;  // by a name: who looked it up
  std::list<const std::string*> changed_;                            // all names, the last changed at the end
  int64_t version_ = 0;
};

// Whether `name` is `prefix` or lies in that namespace; every name does in the empty one.
bool is_within(std::string_view name, std::string_view prefix);

// A prefix as people write it, folded: ball, ball. and ball.* are the same; so are * and nothing. Throws
// bad_params for a star elsewhere.
std::string folded_prefix(std::string_view written);

}  // namespace animado::interexpserv
