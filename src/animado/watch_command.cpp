// animado watch: tells the values of names whenever they change.
#include <chrono>
#include <limits>
#include <map>

#include "animado/commands.hpp"
#include "animado/value_text.hpp"
#include "base/error.hpp"
#include "console/terminal.hpp"
#include "interexpserv/client.hpp"

namespace animado {

namespace {

struct WatchOptions {
  SuiteChoice suite;
  std::vector<std::string> names;
  double every_s = 0.1;
  int64_t count = std::numeric_limits<int64_t>::max();
  bool json = false;
};

class Watcher {
 public:
  explicit Watcher(const WatchOptions& options)
      : options_(options), suite_(connect_to_suite(options.suite)), interexpserv_(*suite_) {
    for (const std::string& name : options.names) interexpserv_.watch(name);
  }

  // Until enough was told, or the suite ends.
  void run() {
    while (told_ < options_.count) {
      for (const std::string& name : options_.names) look_at(name);
      std::fflush(stdout);
      take_changes();
    }
  }

 private:
  void look_at(const std::string& name) {
    if (!name.ends_with('.') && !name.ends_with('*')) return tell(interexpserv_.get(name));
    for (const auto& state : interexpserv_.get_within(name)) tell(state);
  }

  // Changes of definitions come by themselves, each of them in order; values in shared arrays change without
  // notice, and are looked at again when the time is over.
  void take_changes() {
    const auto next_look = std::chrono::steady_clock::now() + std::chrono::duration<double>(options_.every_s);
    interexpserv::NameChanged::Request change;
    interexpserv::FellBehind::Request lost;
    while (told_ < options_.count) {
      const std::chrono::duration<double> left = next_look - std::chrono::steady_clock::now();
      if (!interexpserv_.wait_change(change, std::max(left.count(), 0.0))) break;
      tell(change);
      std::fflush(stdout);
      change = {};
    }
    if (interexpserv_.fell_behind(lost))
      print_note(
          fmt::format("{} changes came faster than they could be told", lost.sequence - lost.first_lost + 1));
  }

  void tell(const interexpserv::NameState& name) {
    const std::string value = value_text(name.type, name.values);
    std::string& last = last_[name.name];
    if (value == last || told_ == options_.count) return;
    last = value;
    ++told_;
    fmt::print("{}\n", options_.json ? name_json(name).dump() : fmt::format("{} = {}", name.name, value));
  }

  const WatchOptions& options_;
  std::unique_ptr<rpc::SocketSuite> suite_;
  interexpserv::Client interexpserv_;
  std::map<std::string, std::string> last_;
  int64_t told_ = 0;
};

void watch(const WatchOptions& options) {
  Watcher watcher(options);
  try {
    watcher.run();
  } catch (const Error& error) {
    if (error.code() != Code::unavailable) throw;  // the suite has ended, and so does this
  }
}

}  // namespace

void add_watch_command(CommandLine& line) {
  const auto options = std::make_shared<WatchOptions>();
  CLI::App& command = add_command(line, "watch", "Tell values whenever they change, until the suite ends",
                                  "  animado watch ball.position\n"
                                  "  animado watch t ball.velocity --every 1\n"
                                  "  animado watch spring.k --count 10\n"
                                  "  animado watch 'ball.*'              all names within ball\n");
  command.add_option("name", options->names, "Names, or namespaces: ball.*")->required();
  command.add_option("--every", options->every_s, "Seconds between looks at what moves")
      ->check(CLI::PositiveNumber);
  command.add_option("--count", options->count, "Lines to tell")->check(CLI::PositiveNumber);
  command.add_flag("--json", options->json, "An object a line");
  add_suite_choice(command, options->suite);
  command.callback([options] { watch(*options); });
}

}  // namespace animado
