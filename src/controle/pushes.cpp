#include "controle/pushes.hpp"

#include <algorithm>

namespace animado::controle {
namespace {

constexpr size_t kGroupsLookedAt = 16;  // scenes of more formulas than this, in turn, are rare

// rows += values, body by body; in body axes with R u = u + 2 q_w (q × u) + 2 q × (q × u).
template <bool kLocal, class BodyOf>
void add(const double* values, size_t lanes, const Moment& moment, BodyOf body_of, double* rows) {
  const size_t n = moment.bodies;
  const double* const q = moment.state + kQw * n;
#pragma GCC ivdep
  for (size_t lane = 0; lane < lanes; ++lane) {
    const size_t i = body_of(lane);
    double x = values[lane], y = values[lanes + lane], z = values[2 * lanes + lane];
    if constexpr (kLocal) {
      const double w = q[i], a = q[n + i], b = q[2 * n + i], c = q[3 * n + i];
      double ux = b * z - c * y, uy = c * x - a * z, uz = a * y - b * x;
      ux += ux, uy += uy, uz += uz;
      x = x + w * ux + (b * uz - c * uy);
      y = y + w * uy + (c * ux - a * uz);
      z = z + w * uz + (a * uy - b * ux);
    }
    rows[i] += x;
    rows[n + i] += y;
    rows[2 * n + i] += z;
  }
}

template <bool kLocal>
void add(const double* values, const std::vector<size_t>& bodies, const Moment& moment, double* rows) {
  const size_t first = bodies.front(), lanes = bodies.size();
  if (bodies.back() == first + lanes - 1) {  // neighbours: they are in the order of the drives
    add<kLocal>(
        values, lanes, moment, [&](size_t lane) { return first + lane; }, rows);
  } else {
    add<kLocal>(
        values, lanes, moment, [&](size_t lane) { return bodies[lane]; }, rows);
  }
}

}  // namespace

Pushes::Pushes(const std::vector<Drive>& drives) {
  for (const Drive& drive : drives) {
    for (const bool torque : {false, true}) {
      size_t turn = 0;
      for (const LiveProgram& program : torque ? drive.torques : drive.forces)
        take(program, drive.body, torque, false, turn++);
      for (const LiveProgram& program : torque ? drive.local_torques : drive.local_forces)
        take(program, drive.body, torque, true, turn++);
    }
  }
  std::ranges::stable_sort(groups_, {}, &Group::turn);
  for (Group& group : groups_) group.batch.close();
}

void Pushes::take(const LiveProgram& program, size_t body, bool torque, bool local, size_t turn) {
  const size_t looked_at = std::min(kGroupsLookedAt, groups_.size());
  for (auto group = groups_.end() - static_cast<int64_t>(looked_at); group != groups_.end(); ++group) {
    const bool fits = group->torque == torque && group->local == local && group->turn == turn;
    if (!fits || !group->batch.add(program)) continue;
    group->bodies.push_back(body);
    return;
  }
  groups_.push_back({ProgramBatch(program), torque, local, turn, {body}});
}

void Pushes::evaluate(const Moment& moment, double* out) {
  std::fill_n(out, 6 * moment.bodies, -0.0);
  for (Group& group : groups_) {
    const double* const values = group.batch.evaluate(moment);
    double* const rows = out + (group.torque ? 3 * moment.bodies : 0);
    group.local ? add<true>(values, group.bodies, moment, rows)
                : add<false>(values, group.bodies, moment, rows);
  }
}

}  // namespace animado::controle
