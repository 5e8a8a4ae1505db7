#include "controle/program_batch.hpp"

#include <algorithm>
#include <functional>

namespace animado::controle {
namespace {

constexpr size_t kFewestLanes = 8;  // what the widest register holds: fewer are evaluated one by one

// The first row of the state that holds a member; none where it has to be computed.
std::optional<size_t> row_of(Member member) {
  switch (member) {
    case Member::position:
      return kPx;
    case Member::velocity:
      return kVx;
    case Member::qw:
      return kQw;
    case Member::qx:
      return kQx;
    case Member::qy:
      return kQy;
    case Member::qz:
      return kQz;
    default:
      return std::nullopt;
  }
}

size_t width(Member member) {
  return interexpserv::width_of(type_of(member));
}

template <class T>
bool are_equal(const std::vector<T>& values) {
  return std::adjacent_find(values.begin(), values.end(), std::not_equal_to<T>()) == values.end();
}

bool are_neighbours(const std::vector<int>& bodies) {
  const auto apart = [](int a, int b) { return b != a + 1; };
  return std::adjacent_find(bodies.begin(), bodies.end(), apart) == bodies.end();
}

}  // namespace

bool ProgramBatch::add(const LiveProgram& program) {
  const LiveProgram& first = *members_.front();
  const auto same_member = [](const Reading& a, const Reading& b) { return a.member == b.member; };
  const bool same = program.program().same_form(first.program()) &&
                    std::equal(program.readings().begin(), program.readings().end(), first.readings().begin(),
                               first.readings().end(), same_member);
  if (same) members_.push_back(&program);
  return same;
}

void ProgramBatch::close() {
  const size_t lanes = members_.size();
  const LiveProgram& first = *members_.front();
  values_.resize(3 * lanes);
  if (lanes < kFewestLanes) return;
  opened_ = first.program().with_open_constants();
  for (size_t k = 0; k < first.program().constants().size(); ++k) {
    std::vector<double> constant;
    for (const LiveProgram* member : members_) constant.push_back(member->program().constants()[k]);
    if (are_equal(constant)) constant.resize(1);
    constants_.push_back(std::move(constant));
  }
  for (size_t k = 0; k < first.readings().size(); ++k) {
    Column column{first.readings()[k], {}, false, {}};
    for (const LiveProgram* member : members_) column.bodies.push_back(member->readings()[k].body);
    if (are_equal(column.bodies)) column.bodies.resize(1);
    column.in_place =
        column.bodies.size() == lanes && row_of(column.reading.member) && are_neighbours(column.bodies);
    if (!column.in_place) column.rows.resize(width(column.reading.member) * column.bodies.size());
    columns_.push_back(std::move(column));
  }
}

void ProgramBatch::gather(Column& column, const Moment& moment) {
  const size_t n = moment.bodies, lanes = column.bodies.size();
  double* const rows = column.rows.data();
  if (column.reading.member == Member::time) {
    *rows = moment.time_s;
  } else if (const auto row = row_of(column.reading.member)) {
    for (size_t k = 0; k < width(column.reading.member); ++k) {
      const double* const from = moment.state + (*row + k) * n;
      for (size_t i = 0; i < lanes; ++i) rows[k * lanes + i] = from[column.bodies[i]];
    }
  } else {
    assert(column.reading.member == Member::angular_velocity);
    for (size_t i = 0; i < lanes; ++i) {
      const auto body = static_cast<size_t>(column.bodies[i]);
      const Vec3 w = load_body(moment.state, n, body).angular_velocity_rad_s();
      for (size_t k = 0; k < 3; ++k) rows[k * lanes + i] = w[static_cast<int>(k)];
    }
  }
}

const double* ProgramBatch::evaluate(const Moment& moment) {
  const size_t lanes = members_.size();
  double* const out[3] = {values_.data(), values_.data() + lanes, values_.data() + 2 * lanes};
  if (!opened_) {
    for (size_t i = 0; i < lanes; ++i) {
      const Vec3 value = members_[i]->vector(moment);
      for (size_t k = 0; k < 3; ++k) out[k][i] = value[static_cast<int>(k)];
    }
    return values_.data();
  }
  inputs_.clear();
  for (const auto& constant : constants_) inputs_.push_back({constant.data(), constant.size() == 1});
  for (Column& column : columns_) {
    if (!column.in_place) gather(column, moment);
    for (size_t k = 0; k < width(column.reading.member); ++k) {
      if (column.in_place) {
        const size_t row = *row_of(column.reading.member) + k;
        inputs_.push_back({moment.state + row * moment.bodies + column.bodies[0], false});
      } else {
        inputs_.push_back({column.rows.data() + k * column.bodies.size(), column.bodies.size() == 1});
      }
    }
  }
  opened_->evaluate_batch(inputs_, lanes, out);
  return values_.data();
}

}  // namespace animado::controle
