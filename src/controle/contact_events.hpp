// What happens between bodies, told: impacts, and pairs that come to rest on each other or part.
#pragma once

#include <functional>
#include <set>

#include "colisao/client.hpp"
#include "controle/meter.hpp"
#include "controle/results/events_jsonl.hpp"
#include "controle/scene/scene.hpp"
#include "controle/workspace.hpp"

namespace animado::controle {

class ContactEvents {
 public:
  using Report = std::function<void(const Event&)>;

  ContactEvents(const Scene& scene, colisao::Client& colisao, Meter& meter, Report report)
      : scene_(scene), colisao_(colisao), meter_(meter), report_(std::move(report)) {}

  // Impacts of a step that started at time_s.
  void record(const std::vector<colisao::ImpactRecord>& impacts, double time_s);

  // Says which pairs came to rest on each other, and which parted.
  void follow(const Lanes& state, double time_s);

  bool any_touching() const { return !touching_.empty(); }

 private:
  using Pair = std::pair<int64_t, int64_t>;

  std::vector<std::string> names(int64_t a, int64_t b) const;

  const Scene& scene_;
  colisao::Client& colisao_;
  Meter& meter_;
  Report report_;
  std::set<Pair> touching_;
};

}  // namespace animado::controle
