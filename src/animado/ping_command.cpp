// animado ping: is a service alive, and how far away.
#include <chrono>
#include <nlohmann/json.hpp>

#include "animado/commands.hpp"
#include "rpc/common.hpp"

namespace animado {

namespace {

struct PingOptions {
  SuiteChoice suite;
  std::vector<std::string> services = {"interexpserv", "egesp", "fred", "colisao"};
  int count = 100;
  bool json = false;
};

// Round trips in µs, sorted.
std::vector<double> round_trips_us(rpc::Channel& channel, int count) {
  std::vector<double> times_us;
  channel.call<rpc::Ping>({});  // the first one also finds the service and connects
  for (int i = 0; i < count; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    channel.call<rpc::Ping>({});
    times_us.push_back(
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count());
  }
  std::ranges::sort(times_us);
  return times_us;
}

void ping(const PingOptions& options) {
  const auto suite = connect_to_suite(options.suite);
  for (const std::string& service : options.services) {
    const auto times_us = round_trips_us(suite->channel(service), options.count);
    const double median_us = times_us[times_us.size() / 2];
    if (options.json) {
      fmt::print("{}\n", nlohmann::ordered_json{{"service", service},
                                                {"count", options.count},
                                                {"median_us", median_us},
                                                {"max_us", times_us.back()}}
                             .dump());
    } else {
      fmt::print("{:<14}{:>8.1f} µs (median of {}, longest {:.1f} µs)\n", service, median_us, options.count,
                 times_us.back());
    }
  }
}

}  // namespace

void add_ping_command(CommandLine& line) {
  const auto options = std::make_shared<PingOptions>();
  CLI::App& command = add_command(line, "ping", "Measure round trips to services",
                                  "  animado ping                    all four services\n"
                                  "  animado ping egesp --count 1000\n");
  command.add_option("service", options->services, "Services (default: all)");
  command.add_option("--count", options->count, "Round trips")->check(CLI::PositiveNumber);
  command.add_flag("--json", options->json, "An object a service, a line each");
  add_suite_choice(command, options->suite);
  command.callback([options] { ping(*options); });
}

}  // namespace animado
