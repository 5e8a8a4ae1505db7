#include "rpc/daemon.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <optional>

#include "base/error.hpp"
#include "console/output.hpp"
#include "console/program_manual.hpp"
#include "console/terminal.hpp"
#include "console/usage_error.hpp"
#include "rpc/dispatcher.hpp"
#include "rpc/endpoint.hpp"
#include "rpc/registration.hpp"
#include "rpc/server.hpp"
#include "rpc/socket_suite.hpp"

namespace animado::rpc {
namespace {

Server* g_server = nullptr;  // a signal handler reaches nothing but globals

void on_signal(int) {
  if (g_server) g_server->stop();
}

void set_signals(Server& server) {
  g_server = &server;
  struct sigaction action {};
  action.sa_handler = on_signal;
  sigaction(SIGTERM, &action, nullptr);
  sigaction(SIGINT, &action, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
}

struct Options {
  std::filesystem::path directory, log;
  LogLevel level = LogLevel::info;
  bool list = false;
};

const std::map<std::string, LogLevel> kLevels = {{"info", LogLevel::info},
                                                 {"warning", LogLevel::warning},
                                                 {"error", LogLevel::error},
                                                 {"off", LogLevel::off}};

void add_options(CLI::App& app, Options& options) {
  app.add_option("--socket-dir", options.directory,
                 "folder of the run's sockets (default: $ANIMADO_SOCKET_DIR, or one in $XDG_RUNTIME_DIR)");
  app.add_option("--log", options.log, "log file, a line a message (default: NAME.log beside the socket)");
  CLI::CheckedTransformer levels(kLevels, CLI::ignore_case);
  levels.description("");  // it would list the numbers, too
  app.add_option("--log-level", options.level, "info, warning, error or off (default: info)")
      ->transform(levels)
      ->type_name("LEVEL");
  app.add_flag("--messages", options.list, "list the messages that it answers, and leave");
  app.set_version_flag("--version", ANIMADO_VERSION);
}

void print_messages(const Service& service) {
  // Not by fmt::print, whose exception would end as one of a service; with_output sees what did not arrive.
  for (const auto& [name, entry] : service.entries())
    std::fputs(fmt::format("{:<16} {}\n", name, entry.codec->doc).c_str(), stdout);
}

void serve(const std::string& name, Dispatcher& dispatcher, const Options& options) {
  Log& log = dispatcher.log();
  remove_stale(options.directory, name);
  Server server(dispatcher, socket_path(options.directory, name, getpid()));
  set_signals(server);
  std::optional<Registration> registration;
  if (name != kWellKnown) {
    registration.emplace(options.directory,
                         Register::Request{name, server.socket().string(), ANIMADO_VERSION, getpid()}, log);
    server.keep(*registration);
  }
  log.info(fmt::format("serves on {}", server.socket().string()));
  server.run();
  g_server = nullptr;
  log.info("ended as asked");
}

void start(const DaemonInfo& info, Options options, const std::function<void(Service&, Suite&)>& table) {
  if (options.directory.empty()) options.directory = socket_directory();
  SocketSuite suite({.directory = options.directory, .client = info.name});
  Service service(info.name);
  if (!options.list) prepare_directory(options.directory);
  table(service, suite);
  if (options.log.empty()) options.log = options.directory / (info.name + ".log");
  Log log = options.list ? Log() : Log(info.name, options.log, options.level);
  Dispatcher dispatcher(service, suite, log);
  options.list ? print_messages(service) : serve(info.name, dispatcher, options);
}

int run(int argc, char** argv, const DaemonInfo& info, const std::function<void(Service&, Suite&)>& table) {
  CLI::App app(info.manual, info.name);
  Options options;
  add_options(app, options);
  if (info.add_options) info.add_options(app);
  add_manual(app, info.name,
             fmt::format("  {0:<{1}}serves until Ctrl-C\n"
                         "  {2:<{1}}what it can be asked; docs/protocol.md says more\n"
                         "  {3}\n",
                         info.name, info.name.size() + 15, info.name + " --messages", info.example));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return exit_of_parse(app, error);
  }
  try {
    start(info, std::move(options), table);
    return 0;
  } catch (const std::exception& error) {
    print_note(fmt::format("{}: {}", info.name, error.what()));
    return 1;
  }
}

}  // namespace

int run_daemon(int argc, char** argv, const DaemonInfo& info,
               const std::function<void(Service&, Suite&)>& table) {
  return with_output([&] { return run(argc, argv, info, table); });
}

}  // namespace animado::rpc
