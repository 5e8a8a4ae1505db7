// What the tests of src/rpc share: a service with a message of every kind of field, a small table of names in
// place of interexpserv, and servers that run in threads of the test.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <optional>
#include <thread>

#include "base/error.hpp"
#include "rpc/common.hpp"
#include "rpc/endpoint.hpp"
#include "rpc/registration.hpp"
#include "rpc/server.hpp"
#include "rpc/socket_suite.hpp"
#include "tests/error_of.hpp"
#include "tests/temporary_directory.hpp"

namespace animado::rpc::testing {

namespace fs = std::filesystem;
using namespace std::string_view_literals;
using namespace std::string_literals;

enum class Color { red, green, blue };
constexpr auto names(const Color*) {
  return std::array{"red"sv, "green"sv, "blue"sv};
}

struct Point {
  double x_m = 0, y_m = 0;
  template <class Self, class F>
  static void fields(Self& s, F&& field) {
    field("x_m", s.x_m, "x");
    field("y_m", s.y_m, "y", kDefault);
  }
};

// A message with every kind of field; the reply is the request.
struct Echo {
  static constexpr auto name = "echo"sv;
  static constexpr auto doc = "Says what was said."sv;
  struct Request {
    bool flag = false;
    int64_t count = 0;
    double ratio = 0.5;
    std::string label;
    Color color = Color::green;
    Array array;
    std::vector<int64_t> list = {7};
    std::vector<std::vector<int64_t>> lists;
    std::vector<Point> points;
    std::optional<double> maybe;
    std::optional<Array> out;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("flag", s.flag, "a boolean", kDefault);
      field("count", s.count, "an integer");
      field("ratio", s.ratio, "a number", kDefault);
      field("label", s.label, "a text", kDefault);
      field("color", s.color, "a choice", kDefault);
      field("array", s.array, "an array", kDefault);
      field("list", s.list, "a list", kDefault);
      field("lists", s.lists, "a list of lists", kDefault);
      field("points", s.points, "a list of maps", kDefault);
      field("maybe", s.maybe, "an optional number");
      field("out", s.out, "an optional array");
    }
  };
  using Reply = Request;
};

inline Echo::Request full_request() {
  Echo::Request r;
  r.flag = true;
  r.count = -3;
  r.ratio = 2.0;
  r.label = "olá";
  r.color = Color::blue;
  r.array = Array::inlined({2, 2}, {1, -0.0, 1e-300, 4});
  r.list = {1, 2, 3};
  r.lists = {{1}, {}, {2, 3}};
  r.points = {{1, 2}, {3, 4}};
  r.maybe = 0.25;
  return r;
}

struct Empty {
  static constexpr auto name = "empty"sv;
  static constexpr auto doc = "Does nothing."sv;
  using Request = Nothing;
  using Reply = Nothing;
};

// Fails in the way that is asked for.
struct Fail {
  static constexpr auto name = "fail"sv;
  static constexpr auto doc = "Fails."sv;
  struct Request {
    bool bug = false;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("bug", s.bug, "as a bug would");
    }
  };
  using Reply = Nothing;
};

// Doubles the numbers of an array, and tells whoever watches.
struct Twice {
  static constexpr auto name = "twice"sv;
  static constexpr auto doc = "Doubles."sv;
  struct Request {
    Array in;
    std::optional<Array> out;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("in", s.in, "numbers");
      field("out", s.out, "where to");
    }
  };
  struct Reply {
    Array out;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("out", s.out, "doubled");
    }
  };
};

struct Told {
  static constexpr auto name = "told"sv;
  static constexpr auto doc = "A notification: something was doubled."sv;
  struct Request {
    int64_t count = 0;
    template <class Self, class F>
    static void fields(Self& s, F&& field) {
      field("count", s.count, "of numbers");
    }
  };
  using Reply = Nothing;
};

inline void fill_parrot(Service& service, Suite&) {
  service.on<Echo>([](const Echo::Request& request) { return request; });
  service.on<Empty>([](const Nothing&) { return Nothing{}; });
  service.on<Fail>([](const Fail::Request& request) -> Nothing {
    if (request.bug) throw std::runtime_error("vector out of range");
    throw Error(Code::refused, "no", "fail.bug", "do not ask");
  });
  service.on<Twice>([&service](const Twice::Request& request, Call& call) {
    std::vector<double> values;
    for (double value : call.read(request.in)) values.push_back(2 * value);
    const Told::Request told{static_cast<int64_t>(values.size())};
    service.notify(call.connection(), codec<Told>(), &told);
    return Twice::Reply{deliver(call, request.out, request.in.shape, std::move(values))};
  });
}

// As much of interexpserv as src/rpc needs.
struct Names {
  struct Entry {
    ConnectionId lease;
    Register::Request entry;
  };
  std::map<std::string, Entry> services;
  std::map<std::string, std::pair<std::vector<int64_t>, UniqueFd>> arrays;
};

inline void fill_names(Service& service, Suite&) {
  const auto names = std::make_shared<Names>();
  service.on<Register>([names](const Register::Request& request, Call& call) {
    names->services[request.name] = {call.connection(), request};
    return Nothing{};
  });
  service.on<Lookup>([names](const Lookup::Request& request) {
    const auto found = names->services.find(request.name);
    if (found == names->services.end())
      throw Error(Code::unavailable, "not registered", request.name, "start it");
    const Register::Request& entry = found->second.entry;
    return Lookup::Reply{entry.socket, entry.version, entry.pid};
  });
  service.on<ArrayCreate>([names](const ArrayCreate::Request& request, Call& call) {
    auto& [shape, fd] = names->arrays[request.name];
    shape = request.shape;
    if (!fd) fd = SharedArray::make(request.name, shape);
    call.send_descriptor(fd.get());
    return ArrayCreate::Reply{shape};
  });
  service.on<ArrayOpen>([names](const ArrayOpen::Request& request, Call& call) {
    const auto found = names->arrays.find(request.name);
    if (found == names->arrays.end())
      throw Error(Code::unknown_array, "nobody made it", request.name, "make it first");
    call.send_descriptor(found->second.second.get());
    return ArrayOpen::Reply{found->second.first};
  });
  service.on<ArrayAdopt>([names](const ArrayAdopt::Request& request, Call& call) {
    SharedArray checked(call.take_descriptor(), request.shape, request.name);
    names->arrays[request.name] = {request.shape, UniqueFd(dup(checked.descriptor()))};
    return Nothing{};
  });
  service.on_disconnect = [names](ConnectionId id) {
    std::erase_if(names->services, [&](const auto& row) { return row.second.lease == id; });
  };
}

// A service served on a socket by a thread of this process, as its program would.
class Served {
 public:
  Served(const fs::path& directory, const std::string& name,
         const std::function<void(Service&, Suite&)>& fill)
      : suite_({.directory = directory, .client = name}),
        service_(name),
        log_(name, directory / (name + ".log")),
        dispatcher_((fill(service_, suite_), service_), suite_, log_),
        server_(dispatcher_, socket_path(directory, name, getpid())) {
    if (name != kWellKnown) {
      registration_.emplace(directory, Register::Request{name, server_.socket().string(), "1", getpid()},
                            log_);
      server_.keep(*registration_);
    }
    thread_ = std::thread([this] { server_.run(); });
  }
  ~Served() {
    server_.stop();
    thread_.join();
  }
  const fs::path& socket() const { return server_.socket(); }

 private:
  SocketSuite suite_;
  Service service_;
  Log log_;
  Dispatcher dispatcher_;
  Server server_;
  std::optional<Registration> registration_;
  std::thread thread_;
};

class SocketTest : public ::testing::Test {
 protected:
  SocketSuite::Options options() const {
    return {.directory = directory_.path(), .client = "test", .trace = "7f3a"};
  }

  TemporaryDirectory directory_;
};

class ParrotTest : public SocketTest {
 protected:
  Served parrot_{directory_, "parrot", fill_parrot};
};

}  // namespace animado::rpc::testing
