#include "live/watch.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>

#include "base/error.hpp"
#include "controle/edits.hpp"
#include "controle/results/bodies_json.hpp"
#include "controle/run.hpp"
#include "live/messages.hpp"

namespace animado::live {
namespace {

using Json = nlohmann::json;

constexpr size_t kHistory_bytes = 64 << 20;
constexpr double kSlowest = 1.0 / 64, kFastest = 1024;  // simulated seconds a second

Json editable(const controle::Scene& scene) {
  Json names = Json::array();
  for (const auto& [name, text] : controle::definitions_of(scene)) {
    if (controle::may_be_edited(name)) names.push_back({{"name", name}, {"text", text}});
  }
  return names;
}

// A signal is for the thread that supervises.
std::thread without_signals(std::function<void()> work) {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  std::thread thread(std::move(work));
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return thread;
}

}  // namespace

Watch::Watch(Watched watched)
    : watched_(std::move(watched)),
      feed_(watched_.directory, watched_.scene.bodies.size()),
      history_(kHistory_bytes),
      server_(watched_.port, std::move(watched_.page),
              {[this] { return greet(); }, [this](const std::string& message) { take(message); },
               [this] { look(); }}) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC | O_NONBLOCK) != 0) throw Error(Code::unavailable, "no pipe for the run's pace");
  childs_pace_.reset(ends[0]);
  pace_.reset(ends[1]);
  command("speed 1");
  command("pause");
  thread_ = without_signals([this] { serve(); });
}

Watch::~Watch() {
  if (!thread_.joinable()) return;
  server_.stop();
  thread_.join();
}

void Watch::serve() {
  try {
    server_.run();
  } catch (const std::exception& error) {
    const auto note = fmt::format("animado: the run goes on without its page: {}\n", error.what());
    std::fputs(note.c_str(), stderr);
    pace_.reset();
    server_.stop();
    server_.run();
  }
}

void Watch::end(const std::string& status, const std::string& state_hash) {
  server_.post([this, status, state_hash] {
    look();
    remember_and_send({{"type", "end"}, {"status", status}, {"state_hash", state_hash}}, false);
  });
  server_.stop();
  thread_.join();
}

std::vector<std::string> Watch::greet() {
  const controle::Scene& scene = watched_.scene;
  const std::string bodies = controle::bodies_text(controle::recorded(controle::result_bodies(scene)));
  std::vector<std::string> messages = {text_of({{"type", "hello"},
                                                {"version", ANIMADO_VERSION},
                                                {"scene", scene.path},
                                                {"scene_text", scene.text},
                                                {"bodies", Json::parse(bodies).at("bodies")},
                                                {"start_s", scene.time.start_s},
                                                {"end_s", scene.time.end_s},
                                                {"step_s", scene.time.step_s},
                                                {"frames", scene.time.frames()},
                                                {"names", editable(scene)},
                                                {"modules", kModules}})};
  messages.insert(messages.end(), history_.messages().begin(), history_.messages().end());
  if (!was_seen_) {
    was_seen_ = true;
    paused_ = false;
    command("resume");
  }
  messages.push_back(text_of({{"type", "pace"}, {"paused", paused_}, {"speed", speed_}}));
  return messages;
}

void Watch::look() {
  for (const Json& message : feed_.take()) {
    if (message.at("type") == "log") {
      server_.send(text_of(message), true);
      continue;
    }
    remember_and_send(message, true);
    if (message.value("kind", "") == "edit") tell_edit(message);
  }
}

void Watch::tell_edit(const Json& event) {
  server_.send(text_of({{"type", "edited"},
                        {"name", event.at("name")},
                        {"text", event.at("value")},
                        {"time_s", event.at("time_s")}}));
}

void Watch::take(const std::string& text) try {
  const Json message = Json::parse(text);
  const std::string type = message.at("type");
  if (type == "check" || type == "edit") {
    check(message, type == "edit");
  } else {
    pace(message);
  }
} catch (const Json::exception& error) {
  server_.send(text_of({{"type", "refused"}, {"error", {{"message", error.what()}}}}));
}

void Watch::pace(const Json& message) {
  const std::string type = message.at("type");
  if (type == "pause" || type == "step") {
    paused_ = true;
    command(type);
  } else if (type == "resume") {
    paused_ = false;
    command(type);
  } else if (type == "speed") {
    const double wanted = message.at("value");
    speed_ = wanted <= 0 ? 0 : std::clamp(wanted, kSlowest, kFastest);
    command(fmt::format("speed {}", speed_));
  }
  server_.send(text_of({{"type", "pace"}, {"paused", paused_}, {"speed", speed_}}));
}

void Watch::check(const Json& message, bool and_edit) {
  const std::string name = message.value("name", ""), text = message.value("text", "");
  Json answer = {{"type", "checked"}, {"name", name}, {"text", text}, {"error", nullptr}};
  try {
    controle::Scene changed = controle::checked_edit(watched_.scene, name, text);
    if (and_edit) {
      watched_.edit(name, text);
      watched_.scene = std::move(changed);
    }
  } catch (const Error& error) {
    answer["error"] = json_of(error);
    if (and_edit) answer["type"] = "refused";
  }
  server_.send(text_of(answer));
}

void Watch::remember_and_send(const Json& message, bool may_be_left_out) {
  std::string text = text_of(message);
  server_.send(text, may_be_left_out);
  history_.add(std::move(text));
}

void Watch::command(const std::string& line) {
  const std::string whole = line + '\n';
  // A run that has ended reads no more: that is no error.
  [[maybe_unused]] const auto written = write(pace_.get(), whole.data(), whole.size());
}

}  // namespace animado::live
