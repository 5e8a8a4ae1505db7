#include "controle/results/frames_csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <iterator>

namespace animado::controle {

std::string frames_header() {
  return fmt::format("frame,time_s,{}", fmt::join(kFactNames, ","));
}

std::array<double, kFactColumns> numbers_of(const FrameFacts& f) {
  const auto count = [](int64_t n) { return static_cast<double>(n); };
  const Vec3 &p = f.linear_kg_m_s, &l = f.angular_kg_m2_s;
  return {f.step_s,
          count(f.steps),
          count(f.impacts),
          count(f.contacts),
          f.kinetic_J,
          f.potential_J,
          f.elastic_J,
          f.work_in_J,
          f.dissipated_impacts_J,
          f.dissipated_friction_J,
          f.dissipated_damping_J,
          f.residual_J,
          p.x(),
          p.y(),
          p.z(),
          l.x(),
          l.y(),
          l.z()};
}

FrameFacts facts_of(double time_s, const std::array<double, kFactColumns>& n) {
  FrameFacts f;
  f.time_s = time_s;
  f.step_s = n[0];
  f.steps = std::llround(n[1]);
  f.impacts = std::llround(n[2]);
  f.contacts = std::llround(n[3]);
  f.kinetic_J = n[4];
  f.potential_J = n[5];
  f.elastic_J = n[6];
  f.work_in_J = n[7];
  f.dissipated_impacts_J = n[8];
  f.dissipated_friction_J = n[9];
  f.dissipated_damping_J = n[10];
  f.residual_J = n[11];
  f.linear_kg_m_s = {n[12], n[13], n[14]};
  f.angular_kg_m2_s = {n[15], n[16], n[17]};
  return f;
}

FramesCsv::FramesCsv(const std::filesystem::path& file) : file_(file) {
  file_.write(frames_header() + '\n');
}

void FramesCsv::frame(int64_t frame, const FrameFacts& facts) {
  fmt::memory_buffer row;
  fmt::format_to(std::back_inserter(row), "{},{:.17g}", frame, facts.time_s);
  for (const double number : numbers_of(facts)) fmt::format_to(std::back_inserter(row), ",{:.17g}", number);
  row.push_back('\n');
  file_.write({row.data(), row.size()});
}

}  // namespace animado::controle
