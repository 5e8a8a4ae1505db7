#include "controle/results/states_csv.hpp"

#include <fmt/format.h>

#include <cassert>
#include <iterator>
#include <utility>

#include "base/state.hpp"

namespace animado::controle {
namespace {

void put(fmt::memory_buffer& row, const Vec3& v) {
  fmt::format_to(std::back_inserter(row), ",{:.17g},{:.17g},{:.17g}", v.x(), v.y(), v.z());
}

void put(fmt::memory_buffer& row, const Quat& q) {
  fmt::format_to(std::back_inserter(row), ",{:.17g},{:.17g},{:.17g},{:.17g}", q.w(), q.x(), q.y(), q.z());
}

}  // namespace

StatesCsv::StatesCsv(const std::filesystem::path& file, std::vector<Body> bodies)
    : file_(file), bodies_(std::move(bodies)) {
  file_.write(fmt::format("{}\n", kStatesHeader));
}

void StatesCsv::frame(int64_t frame, double time_s, std::span<const double> state) {
  assert(state.size() == bodies_.size() * kStateRows);
  fmt::memory_buffer row;
  for (size_t i = 0; i < bodies_.size(); ++i) {
    const BodyState body = load_body(state.data(), bodies_.size(), i);
    row.clear();
    fmt::format_to(std::back_inserter(row), "{},{:.17g},{}", frame, time_s, bodies_[i].name);
    put(row, body.pose.position_m);
    put(row, body.pose.orientation);
    put(row, angles_of(body.pose.orientation, bodies_[i].rotation_order));
    put(row, body.velocity_m_s);
    put(row, body.angular_velocity_rad_s());
    row.push_back('\n');
    file_.write({row.data(), row.size()});
  }
}

}  // namespace animado::controle
