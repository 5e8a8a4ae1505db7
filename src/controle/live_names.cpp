#include "controle/live_names.hpp"

#include "base/state.hpp"
#include "controle/edits.hpp"
#include "interexpserv/published.hpp"

namespace animado::controle {

LiveNames::LiveNames(rpc::Suite& suite, Simulation& simulation, const std::string& run, Report report)
    : client_(suite), simulation_(simulation), report_(std::move(report)), array_(run + "/published") {
  const auto bodies = static_cast<int64_t>(simulation.scene().bodies.size());
  picture_.resize(1 + kStateRows * static_cast<size_t>(bodies));
  shared_ = suite.arrays().create(array_, {1 + static_cast<int64_t>(picture_.size())}).values();
  publish();
  bind();
  define();
}

void LiveNames::bind() {
  using interexpserv::Type;
  const auto& bodies = simulation_.scene().bodies;
  const auto n = static_cast<int64_t>(bodies.size());
  std::vector<interexpserv::Bind::Bound> names = {{"t", array_, Type::scalar, 1, 1}};
  for (int64_t i = 0; i < n; ++i) {
    const auto add = [&](const std::string& name, Type type, int row) {
      names.push_back({bodies[static_cast<size_t>(i)].folded_name + name, array_, type, 2 + row * n + i, n});
    };
    add(".position", Type::vector, kPx);
    add(".velocity", Type::vector, kVx);
    add(".angular_velocity", Type::vector, kWx);
    add(".orientation.qw", Type::scalar, kQw);
    add(".orientation.qx", Type::scalar, kQx);
    add(".orientation.qy", Type::scalar, kQy);
    add(".orientation.qz", Type::scalar, kQz);
  }
  call("bind", [&] { return client_.bind(std::move(names)); });
}

void LiveNames::define() {
  std::vector<interexpserv::Define::Definition> definitions;
  for (auto& [name, text] : definitions_of(simulation_.scene())) {
    known_[name] = text;
    definitions.push_back({name, text});
  }
  version_ = call("define", [&] { return client_.define(std::move(definitions)); });
}

void LiveNames::publish() {
  const size_t n = simulation_.scene().bodies.size();
  picture_[0] = simulation_.stepper().time_s();
  double* const rows = picture_.data() + 1;
  const double* const state = simulation_.stepper().state();
  std::copy(state, state + kWx * n, rows);
  for (size_t i = 0; i < n; ++i) {
    const Vec3 w = load_body(state, n, i).angular_velocity_rad_s();
    for (size_t k = 0; k < 3; ++k) rows[(kWx + k) * n + i] = w[static_cast<int>(k)];
  }
  interexpserv::publish(shared_, picture_);
}

void LiveNames::replay(std::vector<Event> edits) {
  to_repeat_ = std::move(edits);
  repeated_ = 0;
}

void LiveNames::repeat_edits() {
  const double time_s = simulation_.stepper().time_s();
  for (; repeated_ < to_repeat_.size() && to_repeat_[repeated_].time_s <= time_s; ++repeated_) {
    const Event& edit = to_repeat_[repeated_];
    call("set", [&] { return client_.set(*edit.name, *edit.value); });
  }
}

void LiveNames::take_edits() {
  repeat_edits();
  const auto changes = call("changes", [&] { return client_.changes(version_); });
  version_ = changes.version;
  for (const interexpserv::NameState& name : changes.names) {
    const auto known = known_.find(name.name);
    const bool edited =
        name.kind == interexpserv::Kind::definition && (known == known_.end() || known->second != name.text);
    if (edited) take(name);
  }
}

void LiveNames::take(const interexpserv::NameState& name) {
  try {
    simulation_.edit(edited(simulation_.scene(), name.name, name.text));
  } catch (const Error&) {
    // The registry knows names that the scene does not (another run's, say): such an edit cannot act here.
    const auto known = known_.find(name.name);
    version_ = known == known_.end() ? call("remove", [&] { return client_.remove({name.name}); })
                                     : call("set", [&] { return client_.set(name.name, known->second); });
    return;
  }
  known_[name.name] = name.text;
  Event event;
  event.time_s = simulation_.stepper().time_s();
  event.kind = EventKind::edit;
  event.name = name.name;
  event.value = name.text;
  report_(event);
}

}  // namespace animado::controle
