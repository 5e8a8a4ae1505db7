// The messages that every service answers, and the four of interexpserv that the others need to find each
// other and to share arrays. They stand here, and not in interexpserv's protocol, because src/rpc itself
// sends them.
#pragma once

#include "rpc/message.hpp"

namespace animado::rpc {

using namespace std::string_view_literals;

inline constexpr auto kProtocolName = "animado"sv;
inline constexpr int64_t kProtocolVersion =
    1;  // raised when a message changes in a way that an old peer would misread

struct Hello {
  static constexpr auto name = "hello"sv;
  static constexpr auto doc =
      "Opens a connection: the first call. A protocol or version that is not spoken here gets an error (code protocol) that says so."sv;
  struct Request {
    std::string protocol{kProtocolName};
    int64_t version = kProtocolVersion;
    std::string client, trace;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("protocol", s.protocol, "\"animado\"");
      field("version", s.version, "1");
      field("client", s.client, "who calls, for the log", kDefault);
      field("trace", s.trace, "identifies the run in the log lines of all modules", kDefault);
    }
  };
  struct Reply {
    std::string service, version;
    int64_t protocol_version = kProtocolVersion, pid = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("service", s.service, "name of the service");
      field("version", s.version, "of the program");
      field("protocol_version", s.protocol_version, "spoken here");
      field("pid", s.pid, "its process");
    }
  };
};

struct Ping {
  static constexpr auto name = "ping"sv;
  static constexpr auto doc = "Answers, and nothing else: is the service alive, how long is the way."sv;
  using Request = Nothing;
  using Reply = Nothing;
};

struct Statistics {
  static constexpr auto name = "statistics"sv;
  static constexpr auto doc =
      "What the service has done since it started, and how busy it is. Two replies tell what happened "
      "between "
      "them."sv;
  using Request = Nothing;
  struct Count {
    std::string message;
    int64_t requests = 0, errors = 0;
    double time_s = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("message", s.message, "name of the message");
      field("requests", s.requests, "how many came");
      field("errors", s.errors, "how many of them got an error");
      field("time_s", s.time_s, "that it took to read and to handle them, all together");
    }
  };
  struct Latency {
    double below_us = 0;
    int64_t requests = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("below_us", s.below_us, "from the request's arrival until its answer, microseconds");
      field("requests", s.requests, "that took less, and not less than the row before says");
    }
  };
  struct Reply {
    std::string service, version, up_since;
    int64_t pid = 0, requests = 0, errors = 0;
    std::vector<Count> messages;
    std::vector<Latency> latency;
    double up_s = 0, busy_s = 0;
    int64_t connections = 0, waiting = 0, unsent_bytes = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("service", s.service, "name of the service");
      field("version", s.version, "of the program");
      field("up_since", s.up_since, "UTC, ISO 8601");
      field("pid", s.pid, "its process");
      field("requests", s.requests, "all requests, unreadable ones too");
      field("errors", s.errors, "how many of them got an error");
      field("messages", s.messages, "by message, those that came at least once");
      field("latency", s.latency,
            "a histogram: eight steps from one time to its double, empty ones left out");
      field("up_s", s.up_s, "seconds since it started");
      field("busy_s", s.busy_s, "seconds of them in which it was serving");
      field("connections", s.connections, "open now");
      field("waiting", s.waiting, "connections with requests that are not served yet");
      field("unsent_bytes", s.unsent_bytes, "of replies and notifications that clients have not read yet");
    }
  };
};

struct Describe {
  static constexpr auto name = "describe"sv;
  static constexpr auto doc =
      "The messages that the service answers, with their fields: the manual page as data."sv;
  using Request = Nothing;
  struct FieldRow {
    std::string side, path, type, doc;
    bool required = false;
    std::string initial;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("side", s.side, "request or reply");
      field("path", s.path,
            "name; of a field inside a map or a list of maps, with the names around it: bodies.mass_kg");
      field("type", s.type, "in words");
      field("doc", s.doc, "what it means");
      field("required", s.required, "whether it must be there");
      field("initial", s.initial, "its value when it is left out", kDefault);
    }
  };
  struct Message {
    std::string name, doc;
    std::vector<FieldRow> rows;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("name", s.name, "of the message");
      field("doc", s.doc, "what it does");
      field("fields", s.rows, "of the request, then of the reply");
    }
  };
  struct Reply {
    std::vector<Message> messages;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("messages", s.messages, "by name");
    }
  };
};

struct OpenMailbox {
  static constexpr auto name = "mailbox"sv;
  static constexpr auto doc =
      "Opens a mailbox beside the connection: memory and two bells, whose descriptors come with the reply "
      "(SCM_RIGHTS). Short calls may then go through it. "
      "Asked again, it hands over the same one. Code limit when too many clients have one: the socket does all that a mailbox does."sv;
  using Request = Nothing;
  struct Reply {
    int64_t room = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("room", s.room, "bytes of a letter");
    }
  };
};

using CommonMessages = std::tuple<Hello, Ping, Statistics, Describe, OpenMailbox>;

// --- asked of interexpserv

struct Register {
  static constexpr auto name = "register"sv;
  static constexpr auto doc =
      "Puts a server into the table. The entry is a lease: it ends with the connection that made it. Several "
      "servers may offer one name. A second registration of the same name and socket replaces the first."sv;
  struct Request {
    std::string name, socket, version;
    int64_t pid = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("name", s.name, "of the service");
      field("socket", s.socket, "path of its socket");
      field("version", s.version, "of the program");
      field("pid", s.pid, "its process");
    }
  };
  using Reply = Nothing;
};

struct Lookup {
  static constexpr auto name = "lookup"sv;
  static constexpr auto doc =
      "Finds a server of that name; when there are several, one after the other. What a connection holds "
      "(handles, watches, arrays) stays with its server: look up again only when the connection is lost. "
      "Code "
      "unavailable when none is registered now."sv;
  struct Request {
    std::string name;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("name", s.name, "of the service");
    }
  };
  struct Reply {
    std::string socket, version;
    int64_t pid = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("socket", s.socket, "path of its socket");
      field("version", s.version, "of the program");
      field("pid", s.pid, "its process");
    }
  };
};

struct ArrayCreate {
  static constexpr auto name = "array_create"sv;
  static constexpr auto doc =
      "Makes a shared array of zeros and hands its descriptor over (SCM_RIGHTS with the reply). Its size is "
      "sealed. A name is used once: code "
      "conflict when it is taken, unless the array there has the same shape, which is then handed over as it is (a repeated request)."sv;
  struct Request {
    std::string name;
    std::vector<int64_t> shape;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("name", s.name, "chosen by the creator, unique for each array it makes: run/controle/state.7");
      field("shape", s.shape, "extents, row-major float64");
    }
  };
  struct Reply {
    std::vector<int64_t> shape;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("shape", s.shape, "as asked");
    }
  };
};

struct ArrayOpen {
  static constexpr auto name = "array_open"sv;
  static constexpr auto doc =
      "Hands over the descriptor of a shared array (SCM_RIGHTS with the reply). Code unknown_array when there is none of that name."sv;
  struct Request {
    std::string name;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("name", s.name, "of the array");
    }
  };
  using Reply = ArrayCreate::Reply;
};

struct ArrayAdopt {
  static constexpr auto name = "array_adopt"sv;
  static constexpr auto doc =
      "Hands an array back to an interexpserv that was restarted: its descriptor comes with the request "
      "(SCM_RIGHTS). The seals and the size are "
      "checked. Nothing happens when the name is known already."sv;
  using Request = ArrayCreate::Request;
  using Reply = Nothing;
};

}  // namespace animado::rpc
