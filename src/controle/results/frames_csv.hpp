// frames.csv: what a frame knows beside its bodies' states, a row a frame: how it was reached, and where the
// energy and the momentum are.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/spatial.hpp"
#include "controle/results/output_file.hpp"

namespace animado::controle {

struct FrameFacts {
  double time_s = 0;
  double step_s = 0;               // mean length of the steps since the last frame; 0 at the first
  int64_t steps = 0, impacts = 0;  // so far
  int64_t contacts = 0;            // points that touch at this frame
  double kinetic_J = 0, potential_J = 0, elastic_J = 0;
  double work_in_J = 0;  // the ledger so far (ledger.hpp)
  double dissipated_impacts_J = 0, dissipated_friction_J = 0, dissipated_damping_J = 0;
  double residual_J = 0;
  Vec3 linear_kg_m_s = Vec3::Zero();
  Vec3 angular_kg_m2_s = Vec3::Zero();  // about the world's origin
};

// The columns that follow `frame` and `time_s`, and their numbers in the same order.
inline constexpr size_t kFactColumns = 18;
inline constexpr std::array<std::string_view, kFactColumns> kFactNames = {"step_s",
                                                                          "steps",
                                                                          "impacts",
                                                                          "contacts",
                                                                          "kinetic_J",
                                                                          "potential_J",
                                                                          "elastic_J",
                                                                          "work_in_J",
                                                                          "dissipated_impacts_J",
                                                                          "dissipated_friction_J",
                                                                          "dissipated_damping_J",
                                                                          "residual_J",
                                                                          "px_kg_m_s",
                                                                          "py_kg_m_s",
                                                                          "pz_kg_m_s",
                                                                          "lx_kg_m2_s",
                                                                          "ly_kg_m2_s",
                                                                          "lz_kg_m2_s"};
std::string frames_header();  // without the line's end
std::array<double, kFactColumns> numbers_of(const FrameFacts& facts);
FrameFacts facts_of(double time_s, const std::array<double, kFactColumns>& numbers);

class FramesCsv {
 public:
  explicit FramesCsv(const std::filesystem::path& file);

  void frame(int64_t frame, const FrameFacts& facts);
  void flush() { file_.flush(); }
  void close() { file_.close(); }

 private:
  OutputFile file_;
};

}  // namespace animado::controle
