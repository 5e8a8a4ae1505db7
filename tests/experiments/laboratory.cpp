#include "laboratory.hpp"
#include "tests/temporary_directory.hpp"

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace animado::experiments {
namespace {

namespace fs = std::filesystem;

Row parse_row(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> cells;
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  if (cells.size() != 19)
    throw std::runtime_error("states.csv: a row of " + std::to_string(cells.size()) + " cells");
  const auto number = [&](size_t k) { return std::stod(cells[k]); };
  Row row;
  row.frame = std::stoi(cells[0]);
  row.time_s = number(1);
  row.body = cells[2];
  row.position_m = {number(3), number(4), number(5)};
  row.orientation = Quat(number(6), number(7), number(8), number(9));
  row.euler_rad = {number(10), number(11), number(12)};
  row.velocity_m_s = {number(13), number(14), number(15)};
  row.angular_velocity_rad_s = {number(16), number(17), number(18)};
  return row;
}

Record read_results(const fs::path& directory) {
  Record record;
  std::ifstream states(directory / "states.csv"), events(directory / "events.jsonl"),
      summary(directory / "summary.json");
  std::string line;
  std::getline(states, line);  // the header
  while (std::getline(states, line)) record.rows.push_back(parse_row(line));
  while (std::getline(events, line)) record.events.push_back(nlohmann::json::parse(line));
  record.summary = nlohmann::json::parse(summary);
  return record;
}

}  // namespace

std::vector<Row> Record::of(const std::string& body) const {
  std::vector<Row> found;
  for (const Row& row : rows) {
    if (row.body == body) found.push_back(row);
  }
  return found;
}

std::vector<nlohmann::json> Record::impacts() const {
  std::vector<nlohmann::json> found;
  for (const auto& event : events) {
    if (event.at("kind") == "impact") found.push_back(event);
  }
  return found;
}

Record simulate_file(const std::string& path, Way way) {
  const TemporaryDirectory bench;
  const fs::path out = bench.path() / "results", log = bench.path() / "messages";
  const std::string command = std::string(ANIMADO_BIN_DIR) + "/animado run '" + path + "' --out '" +
                              out.string() + "' --quiet --no-pictures" +
                              (way == Way::in_process ? " --in-process" : "") + " > '" + log.string() +
                              "' 2>&1";
  const int status = std::system(command.c_str());
  if (status != 0) {
    std::ifstream in(log);
    std::stringstream text;
    text << in.rdbuf();
    ADD_FAILURE() << command << "\nended with status " << status << "\n" << text.str();
    throw std::runtime_error("the run failed");
  }
  return read_results(out);
}

Record simulate(const std::string& scene, Way way) {
  const TemporaryDirectory bench;
  const fs::path file = bench.path() / "experiment.animado";
  std::ofstream(file) << scene;
  return simulate_file(file.string(), way);
}

std::string name_of(const testing::TestParamInfo<Way>& info) {
  return info.param == Way::sockets ? "sockets" : "in_process";
}

}  // namespace animado::experiments
