// A run in five processes: interexpserv first, then the others, then controle; a service that dies is started
// again.
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <fstream>

#include "animado/programs.hpp"
#include "animado/restarts.hpp"
#include "animado/run_ways.hpp"
#include "animado/running_suite.hpp"
#include "animado/supervisor.hpp"
#include "base/error.hpp"
#include "console/terminal.hpp"
#include "rpc/common.hpp"
#include "rpc/line_reader.hpp"
#include "rpc/one_core.hpp"

namespace animado {

namespace {

namespace fs = std::filesystem;

constexpr int kLookAgain_ms = 2;  // while a service starts, which takes some 10 ms

// The text of a file, which is removed.
std::string take_text(const fs::path& file) {
  std::ifstream in(file);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  fs::remove(file);
  return text;
}

class FiveProcesses {
 public:
  explicit FiveProcesses(const RunRequest& request);

  bool start_services();  // false when interrupted meanwhile
  ExitCode run_controle();
  void write_restarts() const;
  void leave_core() { core_.reset(); }       // what comes after the run may use them all
  void keep_services(const fs::path& logs);  // until interrupted

 private:
  void start(const std::string& service);
  bool is_registered(const std::string& service);
  bool wait_until_registered(const std::string& service);
  ExitCode controle_ended(int status) const;

  const RunRequest& request_;
  std::optional<rpc::OneCore> core_{std::in_place};  // before anything is started
  const fs::path logs_;
  SocketDirectory sockets_;
  const fs::path said_;  // by controle; not where the results are: that their disk is full must be heard
  rpc::SocketSuite probe_;
  Supervisor supervisor_;
  controle::Progress last_progress_;
  std::vector<Restart> restarts_;
};

FiveProcesses::FiveProcesses(const RunRequest& request)
    : request_(request),
      logs_(request.directory / "logs"),
      sockets_(request.name),
      said_(sockets_.path() / "controle.stderr"),
      // It asks whether services are there yet: no is an answer, not something to wait for.
      probe_({.directory = sockets_.path(), .client = "animado", .trace = {}, .reconnect_s = 0}),
      supervisor_(logs_) {
  supervisor_.on_death = [this](const Death& death) {
    print_note(fmt::format("{} ended with status {}; it is started again", death.service, death.status));
    restarts_.push_back({last_progress_.time_s, death.service});
  };
}

void FiveProcesses::start(const std::string& service) {
  std::vector<std::string> arguments = {program(service), "--socket-dir", sockets_.path(), "--log",
                                        logs_ / (service + ".log")};
  if (service == "interexpserv")
    arguments.insert(arguments.end(), {"--store", sockets_.path() / "names.sqlite"});
  supervisor_.start(service, std::move(arguments));
}

bool FiveProcesses::start_services() {
  // The others look for interexpserv; they do not need each other, and start together.
  start("interexpserv");
  if (!wait_until_registered("interexpserv")) return false;
  const std::array<std::string, 3> others = {"egesp", "fred", "colisao"};
  for (const std::string& service : others) start(service);
  return std::ranges::all_of(others,
                             [this](const std::string& service) { return wait_until_registered(service); });
}

bool FiveProcesses::is_registered(const std::string& service) try {
  probe_.channel(service).call<rpc::Ping>({});
  return true;
} catch (const Error& error) {
  if (error.code() == Code::unavailable) return false;
  throw;
}

bool FiveProcesses::wait_until_registered(const std::string& service) {
  while (!is_registered(service)) {
    supervisor_.wait({}, kLookAgain_ms);
    if (supervisor_.interruptions() > 0) return false;
  }
  return true;
}

ExitCode FiveProcesses::run_controle() {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw Error(Code::unavailable, "no pipe for controle's progress");
  const rpc::UniqueFd progress(ends[0]);
  rpc::UniqueFd childs_end(ends[1]);
  fcntl(progress.get(), F_SETFL, O_NONBLOCK);
  std::vector<std::string> arguments = {program("controle"),
                                        "--scene",
                                        request_.scene,
                                        "--out",
                                        request_.directory,
                                        "--socket-dir",
                                        sockets_.path(),
                                        "--progress-fd",
                                        std::to_string(childs_end.get())};
  if (request_.physics_extensions) arguments.emplace_back("--extensions");
  if (!request_.replay.empty()) arguments.insert(arguments.end(), {"--replay", request_.replay});
  std::vector<int> kept = {childs_end.get()};
  if (request_.pace_fd >= 0) {
    arguments.insert(arguments.end(), {"--pace-fd", std::to_string(request_.pace_fd)});
    kept.push_back(request_.pace_fd);
  }
  Child controle(arguments, said_, kept);
  childs_end.reset();

  rpc::LineReader lines(progress.get());
  bool open = true;
  for (int forwarded = 0; !controle.wait(0);) {
    supervisor_.wait(std::array{controle.pidfd(), open ? progress.get() : -1}, -1);
    // The first Ctrl-C asks controle to end after its frame; who presses again will not wait for that.
    for (; forwarded < supervisor_.interruptions(); ++forwarded)
      controle.signal(forwarded == 0 ? SIGINT : SIGKILL);
    open = open && lines.read_lines([&](const std::string& line) {
      if (const auto read = controle::parse_progress_line(line)) request_.on_progress(last_progress_ = *read);
    });
  }
  return controle_ended(controle.reap());
}

ExitCode FiveProcesses::controle_ended(int status) const {
  const std::string said = take_text(said_);
  print_text(said);
  std::ofstream(logs_ / "controle.log", std::ios::app) << said;
  for (const ExitCode code : {kDone, kRefused, kDiverged, kLost, kInterrupted}) {
    if (status == code) return code;
  }
  if (supervisor_.interruptions() > 0) return kInterrupted;
  print_note(fmt::format("controle ended with status {}", status));
  return kLost;
}

void FiveProcesses::write_restarts() const {
  const fs::path events = request_.directory / "events.jsonl";
  if (fs::exists(events)) add_restarts(events, restarts_);
}

void FiveProcesses::keep_services(const fs::path& logs) {
  supervisor_.move_logs(logs);
  print_note(fmt::format("the services stay: try `animado ps --run {}`; Ctrl-C ends them", request_.name));
  const int before = supervisor_.interruptions();
  while (supervisor_.interruptions() == before) supervisor_.wait({}, -1);
}

}  // namespace

ExitCode run_with_services(const RunRequest& request, const Finish& finish) {
  FiveProcesses processes(request);
  const ExitCode code = processes.start_services() ? processes.run_controle() : kInterrupted;
  if (request.on_ended) request.on_ended();
  processes.write_restarts();
  processes.leave_core();
  const fs::path logs = finish(code);
  if (request.keep_services && code == kDone) processes.keep_services(logs);
  return code;
}

}  // namespace animado
