// INTEREXPSERV: names and expressions, services, shared arrays. The messages, as the module's manual page. It
// is started first, at the one well-known address; it knows no physics. docs/expressions.md describes the
// language.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "interexpserv/value.hpp"
#include "rpc/common.hpp"

namespace animado::interexpserv {

using rpc::kDefault;
using rpc::Nothing;
using namespace std::string_view_literals;

constexpr auto names(const Type*) {
  return std::array{"boolean"sv, "scalar"sv, "vector"sv};
}

// definition: an expression. live: elements of a shared array that a running program publishes. removed: no
// longer there.
enum class Kind { definition, live, removed };
constexpr auto names(const Kind*) {
  return std::array{"definition"sv, "live"sv, "removed"sv};
}

struct NameState {
  std::string name, text;
  Kind kind = Kind::definition;
  Type type = Type::scalar;
  int64_t version = 0;
  std::vector<double> values;
  template <class Self, class F>
  static void fields(Self& s, F&& field) {
    field("name", s.name, "folded: small letters without accents");
    field("text", s.text, "the expression; empty of a live or removed name");
    field("kind", s.kind, "definition, live or removed");
    field("type", s.type, "of its value");
    field("version", s.version, "when it last changed, by itself or through what it depends on");
    field("values", s.values,
          "one number, three of a vector, 0 or 1 of a boolean; none when it has no value now");
  }
};

// --- services

struct List {
  static constexpr auto name = "list"sv;
  static constexpr auto doc =
      "The servers that are registered now, by name; those of one name in the order in which they came. "
      "Whoever "
      "asks has interexpserv itself."sv;
  using Request = Nothing;
  struct Service {
    std::string name, socket, version, since;
    int64_t pid = 0, restarts = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("name", s.name, "of the service");
      field("socket", s.socket, "path of its socket");
      field("version", s.version, "of the program");
      field("since", s.since, "when it registered: UTC, ISO 8601");
      field("pid", s.pid, "its process");
      field("restarts", s.restarts,
            "of the name: how often a server came in the place of one that had ended");
    }
  };
  struct Reply {
    std::vector<Service> services;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("services", s.services, "all of them");
    }
  };
};

// --- names

struct Changed {
  int64_t version = 0;
  std::vector<std::string> changed;
  template <class Self, class F>
  static void fields(Self& s, F&& field) {
    field("version", s.version, "of the registry after the request");
    field("changed", s.changed, "the names that changed, dependents included; none when all were so already");
  }
};

// Compare and set: the request is made only if every version is as expected.
struct Expected {
  std::string name;
  int64_t version = 0;
  template <class Self, class F>
  static void fields(Self& s, F&& field) {
    field("name", s.name, "any name, also one that the request does not change");
    field("version", s.version, "as get told it; 0: the name is not there");
  }
};

struct Define {
  static constexpr auto name = "define"sv;
  static constexpr auto doc =
      "Defines names by expressions, all of them or, when one is refused, none; their order does not matter. "
      "What depends on them is "
      "compiled again and must still be right. Inside `ball.force` the prefix may be left out: `mass` is "
      "`ball.mass`. A name keeps the "
      "type it has. Codes: syntax, type, unknown_name, cycle (lists the names), conflict (a live name, or a "
      "name "
      "that has not the expected version: the error tells which it has and who made it), limit."sv;
  struct Definition {
    std::string name, text;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("name", s.name, "identifiers joined by dots: spring.k");
      field("text", s.text, "an expression: 4*pi^2*ball.mass");
    }
  };
  struct Request {
    std::vector<Definition> definitions;
    std::vector<Expected> expected = {};
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("definitions", s.definitions, "the transaction");
      field("expected", s.expected, "what must still be so", kDefault);
    }
  };
  using Reply = Changed;
};

struct Set {
  static constexpr auto name = "set"sv;
  static constexpr auto doc = "Defines one name, as define does."sv;
  struct Request {
    std::string name, text;
    std::optional<int64_t> expected = {};
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      Define::Definition::fields(s, field);
      field("expected", s.expected, "the version that the name must have; 0: it is not there");
    }
  };
  using Reply = Changed;
};

struct Remove {
  static constexpr auto name = "remove"sv;
  static constexpr auto doc =
      "Takes names away, all or none. Code conflict when a name that stays needs one of them, unknown_name for one that never was."sv;
  struct Request {
    std::vector<std::string> names;
    std::vector<Expected> expected = {};
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("names", s.names, "live ones too");
      field("expected", s.expected, "what must still be so", kDefault);
    }
  };
  using Reply = Changed;
};

struct Get {
  static constexpr auto name = "get"sv;
  static constexpr auto doc =
      "Names with their values now. Live ones of one array come from one instant. Codes: unknown_name; "
      "unavailable when a value needs "
      "a program that is not running; unknown_array when the program that published it is gone."sv;
  struct Request {
    std::vector<std::string> names;
    std::string prefix;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("names", s.names, "when empty: all names within `prefix`", kDefault);
      field("prefix", s.prefix, "a namespace: ball, ball. or ball.*; empty means all", kDefault);
    }
  };
  struct Reply {
    std::vector<NameState> names;
    int64_t version = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("names", s.names,
            "in the order asked; by name within a prefix, where a name without a value has no values");
      field("version", s.version, "of the registry");
    }
  };
};

struct Evaluate {
  static constexpr auto name = "evaluate"sv;
  static constexpr auto doc = "The value of an expression of the names that are known."sv;
  struct Request {
    std::string text, home;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("text", s.text, "an expression");
      field("home", s.home, "the namespace whose prefix may be left out", kDefault);
    }
  };
  struct Reply {
    Type type = Type::scalar;
    std::vector<double> values;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("type", s.type, "of the value");
      field("values", s.values,
            "one number, three of a vector, 0 or 1 of a boolean; NaN and infinity may occur");
    }
  };
};

struct Changes {
  static constexpr auto name = "changes"sv;
  static constexpr auto doc =
      "What was defined or removed since a version, dependents included; live names do not count. A version "
      "that the registry has not "
      "reached comes from another life of it, and everything is told."sv;
  struct Request {
    int64_t since = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("since", s.since, "the version that the caller knows", kDefault);
    }
  };
  struct Reply {
    std::vector<NameState> names;
    int64_t version = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("names", s.names, "by version, then name; without values");
      field("version", s.version, "to ask from next time");
    }
  };
};

struct Bind {
  static constexpr auto name = "bind"sv;
  static constexpr auto doc =
      "Binds names to elements of shared arrays, so that they can be read while a program runs. Element 0 of "
      "such an array counts: odd "
      "while the array is being written, even when it is whole (interexpserv/published.hpp). `t` can be "
      "bound too. Codes: "
      "unknown_array, bad_shape (outside the array), conflict (a defined name)."sv;
  struct Bound {
    std::string name, array;
    Type type = Type::scalar;
    int64_t element = 1, stride = 1;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("name", s.name, "identifiers joined by dots: ball.position, ball.orientation.qw");
      field("array", s.array, "name of the shared array");
      field("type", s.type, "boolean, scalar or vector");
      field("element", s.element, "the first component, from 1");
      field("stride", s.stride, "from one component to the next", kDefault);
    }
  };
  struct Request {
    std::vector<Bound> names;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("names", s.names, "all or none");
    }
  };
  using Reply = Changed;
};

struct History {
  static constexpr auto name = "history"sv;
  static constexpr auto doc =
      "What a name was made to stand for: its last 16 revisions, the present one included. A change of what "
      "it depends on is none of its own. Code unknown_name."sv;
  struct Revision {
    int64_t version = 0;
    std::string time, who, text;
    Kind kind = Kind::definition;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("version", s.version, "of the registry, which the change made");
      field("time", s.time, "UTC, ISO 8601");
      field("who", s.who, "client, as it said in hello");
      field("text", s.text, "the expression; of a live name its array");
      field("kind", s.kind, "definition, live or removed");
    }
  };
  struct Request {
    std::string name;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("name", s.name, "of a name that is there, or was");
    }
  };
  struct Reply {
    std::vector<Revision> revisions;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("revisions", s.revisions, "oldest first");
    }
  };
};

struct Snapshot {
  static constexpr auto name = "snapshot"sv;
  static constexpr auto doc =
      "All definitions within a prefix at one instant; live names have none. Code limit when a message "
      "cannot "
      "hold them: take one namespace after the other."sv;
  struct Request {
    std::string prefix;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("prefix", s.prefix, "a namespace: ball, ball. or ball.*; empty means all", kDefault);
    }
  };
  struct Reply {
    int64_t version = 0;
    std::vector<std::string> names, texts;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("version", s.version, "of the registry");
      field("names", s.names, "in order");
      field("texts", s.texts, "the expression of each");
    }
  };
};

struct Restore {
  static constexpr auto name = "restore"sv;
  static constexpr auto doc =
      "Makes the definitions within a prefix exactly these, in one transaction: what differs is defined "
      "anew, "
      "what is not among them is removed, live names stay. Codes: as define and remove."sv;
  struct Request {
    std::vector<std::string> names, texts;
    std::string prefix;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("names", s.names, "of a snapshot");
      field("texts", s.texts, "the expression of each");
      field("prefix", s.prefix, "of that snapshot", kDefault);
    }
  };
  struct Reply {
    int64_t version = 0, changed = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("version", s.version, "of the registry after the request");
      field("changed", s.changed, "how many names changed, dependents included");
    }
  };
};

struct Watch {
  static constexpr auto name = "watch"sv;
  static constexpr auto doc =
      "From now on this connection gets a notification `changed` for each change of a name within a prefix: "
      "every one, in order. A connection that leaves 256 KiB of them unread is told no more until it has "
      "read "
      "them, and then gets `fell_behind`; nobody else waits for it. Of live names it is told when they are "
      "bound and removed. Their values change in shared memory, of which interexpserv hears nothing: get "
      "them "
      "as often as they are wanted."sv;
  struct Request {
    std::string prefix;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("prefix", s.prefix, "a name or a namespace: ball, ball. or ball.*; empty means all", kDefault);
    }
  };
  struct Reply {
    int64_t version = 0, sequence = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("version", s.version, "changes after this one are told");
      field("sequence", s.sequence, "of the last change until now; 0 when there was none");
    }
  };
};

struct Unwatch {
  static constexpr auto name = "unwatch"sv;
  static constexpr auto doc = "Ends a watch of this connection; nothing happens when there is none."sv;
  using Request = Watch::Request;
  using Reply = Nothing;
};

// The notifications of a watch: sent by interexpserv, answered by nobody.
struct NameChanged {
  static constexpr auto name = "changed"sv;
  static constexpr auto doc =
      "A name that is watched has changed, by itself or through what it depends on."sv;
  struct Request : NameState {
    int64_t sequence = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("sequence", s.sequence,
            "number of the change since interexpserv started: each changed name is one, watched or not");
      NameState::fields(s, field);
    }
  };
  using Reply = Nothing;
};

struct FellBehind {
  static constexpr auto name = "fell_behind"sv;
  static constexpr auto doc =
      "This connection did not read its notifications in time, and some were not sent. `changes` since "
      "`since` tells how the names are now; what is told from here on counts where its version is beyond "
      "that reply's."sv;
  struct Request {
    int64_t first_lost = 0, sequence = 0, since = 0, version = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("first_lost", s.first_lost, "sequence of the first change that was not sent");
      field("sequence", s.sequence, "of the last one: what comes after it is sent again");
      field("since", s.since, "the version up to which everything was told");
      field("version", s.version, "of the registry now");
    }
  };
  using Reply = Nothing;
};

// --- shared arrays (array_create, array_open, array_adopt: rpc/common.hpp)

struct ArrayRelease {
  static constexpr auto name = "array_release"sv;
  static constexpr auto doc =
      "Forgets a shared array; who has it mapped keeps it. Nothing happens when there is none of that name. "
      "The arrays of a connection "
      "are forgotten when it ends."sv;
  using Request = rpc::ArrayOpen::Request;
  using Reply = Nothing;
};

struct ArrayList {
  static constexpr auto name = "array_list"sv;
  static constexpr auto doc = "The shared arrays, by name."sv;
  using Request = Nothing;
  struct Entry {
    std::string name;
    std::vector<int64_t> shape;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("name", s.name, "of the array");
      field("shape", s.shape, "extents, row-major float64");
    }
  };
  struct Reply {
    std::vector<Entry> arrays;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("arrays", s.arrays, "all of them");
    }
  };
};

using Messages = std::tuple<rpc::Register, rpc::Lookup, List, Define, Set, Remove, Get, Evaluate, Changes,
                            History, Snapshot, Restore, Bind, Watch, Unwatch, rpc::ArrayCreate,
                            rpc::ArrayOpen, rpc::ArrayAdopt, ArrayRelease, ArrayList>;
using Notifications = std::tuple<NameChanged, FellBehind>;

}  // namespace animado::interexpserv
