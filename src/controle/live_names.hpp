// A run as interexpserv sees it: the state of the last frame under the objects' names (`animado get
// ball.position`), and the scene's expressions as definitions that may be edited while the run goes (`animado
// set ball.force "…"`). Edits take effect at frame boundaries.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "controle/results/events_jsonl.hpp"
#include "controle/simulation.hpp"
#include "controle/workspace.hpp"
#include "interexpserv/client.hpp"

namespace animado::controle {

class LiveNames {
 public:
  using Report = std::function<void(const Event&)>;

  // `run` tells this run's array from another's. Edits that took effect go to `report`.
  LiveNames(rpc::Suite& suite, Simulation& simulation, const std::string& run, Report report);

  // At a frame boundary: first the state is shown, then the edits since the last frame are taken. An edit
  // that does not fit the scene is taken back in the registry, so that what is read there is what acts.
  void publish();
  void take_edits();

  // From now on `edits` (of events.jsonl, by time) are made again at the frames at which they were made.
  void replay(std::vector<Event> edits);

 private:
  void bind();
  void define();
  void repeat_edits();
  void take(const interexpserv::NameState& edited);
  template <class F>
  auto call(const char* message, F&& ask) {
    return simulation_.meter().timed("interexpserv", message, ask);
  }

  interexpserv::Client client_;
  Simulation& simulation_;
  Report report_;
  std::string array_;
  std::span<double> shared_;
  std::vector<double> picture_;  // t, then 13 rows of N: the state with the angular velocity in world axes
  std::map<std::string, std::string> known_;  // texts that act
  int64_t version_ = 0;
  std::vector<Event> to_repeat_;
  size_t repeated_ = 0;
};

}  // namespace animado::controle
