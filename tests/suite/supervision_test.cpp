// Kill any service at any time: the run goes on, and its result is the same to the last bit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include "command.hpp"
#include "rpc/endpoint.hpp"

namespace animado::suite {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

// Two spinning boxes that meet between walls again and again: every service has work at every step.
constexpr auto kBusyScene = R"(
world
gravity (0, -9.81, 0)
substep 0.002
object floor
shape plane(normal=(0, 1, 0), offset=0)
motion static
object box
shape box(size=(1, 2, 0.5))
mass 3
restitution 1
position (0, 4, 0)
angular velocity (1, 2, 3)
object ball
shape sphere(radius=0.5)
mass 1
restitution 1
position (0.2, 7, 0.1)
force (-4*ball.position.x, 0, -4*ball.position.z)
time
start 0
end 12
step 0.1
)";

constexpr uintmax_t kSomeWork = 20'000;  // bytes of log: some 200 of the run's many thousand messages

class Supervision : public testing::Test {
 protected:
  Supervision() { write_text(directory_ / "scene.animado", kBusyScene); }
  ~Supervision() override { fs::remove_all(rpc::socket_directory(kRun)); }  // who is killed leaves it

  fs::path partial(const Command& command) const {
    return directory_ / "runs" / fmt::format(".scene.partial-{}", command.pid());
  }

  // How much the service has logged, a line of some 100 bytes a message.
  uintmax_t logged(const Command& command, const std::string& service) const {
    std::error_code not_yet;
    const uintmax_t size = fs::file_size(partial(command) / "logs" / (service + ".log"), not_yet);
    return not_yet ? 0 : size;
  }

  // Its process, as the suite's table has it; 0 while it is not registered.
  static pid_t pid_of(const std::string& service) {
    const Outcome outcome = animado({"ps", "--run", kRun, "--json"});
    if (outcome.code != 0) return 0;
    for (const Json& row : Json::parse(outcome.out)) {
      if (row.at("service") == service) return row.at("pid");
    }
    return 0;
  }

  // Its process once it is registered. Asked before there is work: while we ask, the run may end.
  static pid_t first_pid_of(const Command& command, const std::string& service) {
    pid_t pid = 0;
    wait_until([&] { return (pid = pid_of(service)) != 0; }, [&] { return !command.running(); });
    return pid;
  }

  // Until the service has done some of the run; false when the run is over before.
  bool wait_for_work(const Command& command, const std::string& service) const {
    return wait_until([&] { return logged(command, service) > kSomeWork; },
                      [&] { return !command.running(); });
  }

  void kill_at_work(const Command& command, const std::string& service) const {
    const pid_t pid = first_pid_of(command, service);
    ASSERT_GT(pid, 0) << command.err();  // kill(0, …) would be for all of us
    ASSERT_TRUE(wait_for_work(command, service)) << command.err();
    ASSERT_EQ(kill(pid, SIGKILL), 0);
  }

  static std::string snapshot() { return animado({"snapshot", "--run", kRun}).out; }

  Json summary() const { return Json::parse(text_of(directory_ / "runs/scene/summary.json")); }

  // Restarts among the events, by service.
  std::map<std::string, int> restarts() const {
    std::map<std::string, int> counts;
    std::istringstream events(text_of(directory_ / "runs/scene/events.jsonl"));
    for (std::string line; std::getline(events, line);) {
      const Json event = Json::parse(line);
      if (event.at("kind") == "restart") ++counts[event.at("name").get<std::string>()];
    }
    return counts;
  }

  static inline const std::string kRun = fmt::format("supervision-test-{}", getpid());
  TemporaryDirectory directory_;
};

// With equal steps of rk4, and with steps of a method that knows its error and has a dense output.
class Restarts : public Supervision, public testing::WithParamInterface<const char*> {};

TEST_P(Restarts, AKilledServiceComesBackAndTheResultIsTheSameToTheLastBit) {
  std::string scene = kBusyScene;
  const std::string_view steps = "substep 0.002";
  scene.replace(scene.find(steps), steps.size(), GetParam());
  write_text(directory_ / "scene.animado", scene);
  const Words words = {"run", "scene.animado", "--no-pictures", "--run", kRun};
  ASSERT_EQ(Command(directory_, words).finish().code, 0);
  const Json undisturbed = summary();
  ASSERT_GT(undisturbed.at("impacts"), 5);
  const std::string states = text_of(directory_ / "runs/scene/states.csv");
  EXPECT_THAT(restarts(), testing::IsEmpty());

  for (const std::string service : {"egesp", "fred", "colisao"}) {
    Command command(directory_, words);
    kill_at_work(command, service);
    if (HasFatalFailure()) return;
    const Outcome outcome = command.finish();
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(summary().at("state_hash"), undisturbed.at("state_hash")) << service;
    EXPECT_EQ(text_of(directory_ / "runs/scene/states.csv"), states) << service;
    EXPECT_THAT(restarts(), testing::ElementsAre(testing::Pair(service, 1)));
  }
}

INSTANTIATE_TEST_SUITE_P(, Restarts, testing::Values("substep 0.002", "method dop853\ntolerance 1e-12"),
                         [](const auto& tested) { return tested.index == 0 ? "rk4" : "dop853"; });

// The names come back from their file, the others register again, and nobody asks for an array that is lost.
TEST_F(Supervision, AKilledInterexpservComesBackAndTheResultIsTheSameToTheLastBit) {
  Words words = {"run", "scene.animado", "--no-pictures", "--run", kRun};
  ASSERT_EQ(Command(directory_, words).finish().code, 0);
  const std::string hash = summary().at("state_hash"), states = text_of(directory_ / "runs/scene/states.csv");
  fs::remove_all(directory_ / "runs");
  words.push_back("--keep-services");  // what is asked below may take longer than the run
  Command command(directory_, words);
  const auto over = [&] { return !command.running(); };
  const pid_t pid = first_pid_of(command, "interexpserv");
  ASSERT_GT(pid, 0) << command.err();
  ASSERT_TRUE(wait_for_work(command, "egesp")) << command.err();
  const std::string names = snapshot();
  EXPECT_THAT(names, testing::HasSubstr("ball.force = "));
  ASSERT_EQ(kill(pid, SIGKILL), 0);
  const auto is_back = [&] { return pid_of("interexpserv") != 0 && pid_of("interexpserv") != pid; };
  ASSERT_TRUE(wait_until(is_back, over)) << "interexpserv did not come back\n" << command.err();
  EXPECT_EQ(snapshot(), names);
  for (const std::string service : {"egesp", "fred", "colisao"})
    EXPECT_TRUE(wait_until([&] { return pid_of(service) != 0; }, over))
        << service << " did not register again";
  ASSERT_TRUE(wait_until([&] { return fs::exists(directory_ / "runs/scene/summary.json"); }, over))
      << command.err();
  command.signal(SIGINT);
  const Outcome outcome = command.finish();
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(summary().at("state_hash"), hash);
  EXPECT_EQ(text_of(directory_ / "runs/scene/states.csv"), states);
  EXPECT_THAT(restarts(), testing::ElementsAre(testing::Pair("interexpserv", 1)));
}

TEST_F(Supervision, WhatARunPublishesIsReadAgainOnceInterexpservIsBack) {
  std::string scene = kBusyScene;
  const std::string_view end = "end 12";
  scene.replace(scene.find(end), end.size(), "end 120");  // longer than interexpserv takes to come back
  write_text(directory_ / "scene.animado", scene);
  Command command(directory_, {"run", "scene.animado", "--no-pictures", "--run", kRun});
  const auto time_is_read = [] { return animado({"get", "t", "ball.position", "--run", kRun}).code == 0; };
  const auto over = [&] { return !command.running(); };
  const pid_t pid = first_pid_of(command, "interexpserv");
  ASSERT_GT(pid, 0) << command.err();
  ASSERT_TRUE(wait_until(time_is_read, over)) << command.err();
  ASSERT_EQ(kill(pid, SIGKILL), 0);
  EXPECT_TRUE(wait_until(time_is_read, over)) << "the run ended before";
  command.signal(SIGINT);
  EXPECT_EQ(command.finish().code, 130) << command.err();
}

TEST_F(Supervision, ServicesDieWithTheSupervisor) {
  Command command(directory_, {"run", "scene.animado", "--no-pictures", "--run", kRun});
  std::vector<pid_t> pids;
  for (const std::string service : {"interexpserv", "egesp", "fred", "colisao"})
    pids.push_back(first_pid_of(command, service));
  ASSERT_THAT(pids, testing::Each(testing::Gt(0)));  // kill(0, 0) would answer for ever
  ASSERT_TRUE(wait_for_work(command, "colisao")) << command.err();
  command.signal(SIGKILL);
  command.finish();
  for (const pid_t pid : pids) {
    EXPECT_TRUE(wait_until([&] { return kill(pid, 0) != 0; }, [] { return false; }));
  }
}

TEST_F(Supervision, KeptServicesAnswerAfterTheRunUntilInterrupted) {
  Command command(directory_, {"run", "scene.animado", "--no-pictures", "--run", kRun, "--keep-services"});
  const auto over = [&] { return !command.running(); };
  ASSERT_TRUE(wait_until([&] { return fs::exists(directory_ / "runs/scene/summary.json"); }, over))
      << command.err();
  EXPECT_EQ(animado({"ping", "--run", kRun}).code, 0);
  command.signal(SIGINT);
  EXPECT_EQ(command.finish().code, 0);
  EXPECT_EQ(animado({"ping", "--run", kRun}).code, 5);
}

}  // namespace
}  // namespace animado::suite
