#include "animado/end_report.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "console/terminal.hpp"

namespace animado {

namespace {

using Json = nlohmann::json;

std::string counted(int64_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

// JSON has no infinity: what is not finite is null.
double joules_in(const Json& energy, const char* key) {
  return energy.at(key).is_null() ? NAN : energy.at(key).get<double>();
}

std::string energy_text(const Json& energy) {
  const auto joules = [&](const char* key) { return joules_in(energy, key); };
  if (!std::isfinite(joules("residual"))) return "more than a number holds";
  std::string text =
      fmt::format("{:.6g} J at the start, {:.6g} J at the end", joules("initial"), joules("final"));
  constexpr std::array<std::pair<const char*, const char*>, 4> kFlows = {
      {{"work_in", "work put in"},
       {"dissipated_impacts", "lost in impacts"},
       {"dissipated_friction", "lost to friction"},
       {"dissipated_damping", "lost to damping"}}};
  constexpr double kRounding = 1e-12;  // of the largest energy: what is less came of rounding alone
  const auto amount = [&](const char* key) { return std::abs(joules(key)); };
  double largest_J = std::max(amount("initial"), amount("final"));
  for (const auto& [key, words] : kFlows) largest_J = std::max(largest_J, amount(key));
  for (const auto& [key, words] : kFlows) {
    if (amount(key) > kRounding * largest_J) text += fmt::format(", {:.6g} J {}", joules(key), words);
  }
  if (amount("residual") <= kRounding * largest_J) return text + "; nothing is unaccounted for";
  return text + fmt::format("; {:.2g} J ({:.1g} %) unaccounted for", joules("residual"),
                            100 * amount("residual") / largest_J);
}

// What a person opens first, of what is there.
std::string files_text(const std::filesystem::path& directory) {
  std::string text;
  for (const char* file : {"report.html", "sheet.png", "film.mp4", "animation.glb", "states.csv"}) {
    if (!std::filesystem::exists(directory / file)) continue;
    text += (text.empty() ? ": " : ", ") + std::string(file);
  }
  return text;
}

}  // namespace

std::string end_report(const std::filesystem::path& directory) try {
  const auto file = directory / "summary.json";
  std::ifstream in(file);
  if (!in) throw Error(Code::unavailable, "cannot read " + file.string());
  const Json summary = Json::parse(in);
  const auto status = summary.at("status").get<std::string>();
  const auto paint = status == "done" ? Paint::green : Paint::red;
  return fmt::format("{}: {} of {} in {} and {:.3g} s; {}\n", painted(status, paint),
                     counted(summary.at("frames").get<int64_t>(), "frame", "frames"),
                     counted(summary.at("bodies").get<int64_t>(), "body", "bodies"),
                     counted(summary.at("steps").get<int64_t>(), "step", "steps"),
                     summary.at("wall_time_s").get<double>(),
                     counted(summary.at("impacts").get<int64_t>(), "impact", "impacts")) +
         fmt::format("energy: {}\n", energy_text(summary.at("energy"))) +
         fmt::format("state hash {}\n", summary.at("state_hash").get<std::string>()) +
         fmt::format("results in {}{}\n", std::filesystem::proximate(directory).string(),
                     files_text(directory));
} catch (const Json::exception& error) {
  throw Error(Code::unavailable, std::string("the summary cannot be read: ") + error.what(),
              (directory / "summary.json").string());
}

}  // namespace animado
