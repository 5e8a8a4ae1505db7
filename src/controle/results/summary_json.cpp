#include "controle/results/summary_json.hpp"

#include <cassert>

#include "base/hash.hpp"
#include "controle/results/json_vector.hpp"
#include "controle/results/output_file.hpp"

namespace animado::controle {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Momentum& momentum) {
  return {{"linear", json_vector(momentum.linear_kg_m_s)},
          {"angular", json_vector(momentum.angular_kg_m2_s)}};
}

Json json_of(const EnergyLedger& energy) {
  return {{"initial", energy.initial_J},
          {"final", energy.final_J},
          {"work_in", energy.work_in_J},
          {"dissipated_impacts", energy.dissipated_impacts_J},
          {"dissipated_friction", energy.dissipated_friction_J},
          {"dissipated_damping", energy.dissipated_damping_J},
          {"residual", energy.residual_J()}};
}

template <class Value>
Json json_of(const std::vector<std::pair<std::string, Value>>& modules) {
  Json object = Json::object();
  for (const auto& [module, value] : modules) object[module] = value;
  return object;
}

}  // namespace

std::string summary_text(const Summary& summary) {
  const Json page = {
      {"scene", summary.scene},
      {"scene_hash", hex(summary.scene_hash)},
      {"version", ANIMADO_VERSION},
      {"status", kRunStatuses[static_cast<size_t>(summary.status)]},
      {"frames", summary.frames},
      {"bodies", summary.bodies},
      {"steps", summary.steps},
      {"impacts", summary.impacts},
      {"energy", json_of(summary.energy)},
      {"momentum",
       {{"initial", json_of(summary.momentum_initial)}, {"final", json_of(summary.momentum_final)}}},
      {"state_hash", hex(summary.state_hash)},
      {"wall_time_s", summary.wall_time_s},
      {"time_per_module", json_of(summary.time_per_module_s)},
      {"messages_per_module", json_of(summary.messages_per_module)},
      {"units", {{"energy", "J"}, {"linear", "kg m/s"}, {"angular", "kg m^2/s"}, {"time_per_module", "s"}}}};
  return page.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

void write_summary(const std::filesystem::path& file, const Summary& summary) {
  OutputFile output(file);
  output.write(summary_text(summary));
  output.close();
}

}  // namespace animado::controle
