// states.csv: the motion as a table, a row a body a frame, numbers that read back to the same bits.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/euler.hpp"
#include "controle/results/output_file.hpp"

namespace animado::controle {

inline constexpr std::string_view kStatesHeader =
    "frame,time_s,body,px_m,py_m,pz_m,qw,qx,qy,qz,ex_rad,ey_rad,ez_rad,vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_"
    "s,wz_rad_s";

class StatesCsv {
 public:
  struct Body {
    std::string name = {};
    RotationOrder rotation_order = {0, 1, 2};  // of its Euler angles
  };

  StatesCsv(const std::filesystem::path& file, std::vector<Body> bodies);

  // state: shape (13, bodies), rows as in base/state.hpp. In the file the angular velocity is in world axes.
  void frame(int64_t frame, double time_s, std::span<const double> state);
  void flush() { file_.flush(); }
  void close() { file_.close(); }

 private:
  OutputFile file_;
  std::vector<Body> bodies_;
};

}  // namespace animado::controle
