// A run that is watched: a page on 127.0.0.1 sees its files grow, tells it how fast to go, and edits its
// names.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "controle/scene/scene.hpp"
#include "live/feed.hpp"
#include "live/history.hpp"
#include "live/web_server.hpp"
#include "rpc/unique_fd.hpp"

namespace animado::live {

struct Watched {
  controle::Scene scene;
  std::filesystem::path directory;  // where its files grow
  std::string page;                 // HTML
  uint16_t port = 0;                // 0: any that is free
  // Sends an expression for a name to the run. Throws Error when it cannot.
  std::function<void(const std::string& name, const std::string& text)> edit;
};

class Watch {
 public:
  // Serves from now on, in a thread of its own. The run waits, paused, until a page is there. When the
  // serving fails, that is told on stderr, and the run goes on unwatched.
  explicit Watch(Watched watched);
  ~Watch();

  std::string address() const { return server_.address(); }
  int pace_fd() const { return childs_pace_.get(); }  // where the run reads how fast to go

  // Tells the pages the rest and how it ended, and closes. The files must be as the run left them.
  void end(const std::string& status, const std::string& state_hash);

 private:
  using Json = nlohmann::json;

  void serve();
  std::vector<std::string> greet();
  void look();
  void take(const std::string& message);
  void tell_edit(const Json& event);
  void pace(const Json& message);
  void check(const Json& message, bool and_edit);
  void remember_and_send(const Json& message, bool may_be_left_out);
  void command(const std::string& line);

  Watched watched_;
  Feed feed_;
  rpc::UniqueFd pace_, childs_pace_;
  History history_;  // all but the logs
  bool was_seen_ = false, paused_ = true;
  double speed_ = 1;
  WebServer server_;
  std::thread thread_;
};

}  // namespace animado::live
