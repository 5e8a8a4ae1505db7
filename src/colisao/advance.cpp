#include "colisao/advance.hpp"

#include <algorithm>
#include <cassert>

#include "colisao/impulse.hpp"
#include "colisao/islands.hpp"
#include "colisao/response_tolerances.hpp"

namespace animado::colisao {

namespace {

class Step {
 public:
  Step(const Bodies& bodies, const ContactFinder& finder, const AdvanceInput& input)
      : bodies_(bodies), finder_(finder), input_(input), count_(bodies.size()) {}

  AdvanceResult run() {
    AdvanceResult result;
    result.state.assign(input_.free, input_.free + kStateRows * count_);
    const ContactFinder::Pairs pairs = input_.crowded ? pairs_within_reach() : touching_pairs();
    std::vector<bool> is_dynamic;
    for (const Body& body : bodies_.list) is_dynamic.push_back(body.is_dynamic());
    for (const Island& island : islands(is_dynamic, pairs)) {
      ++result.islands;
      move(island, pairs, result);
    }
    std::sort(result.moved.begin(), result.moved.end());
    std::stable_sort(result.account.impacts.begin(), result.account.impacts.end(),
                     [](const TimedImpact& x, const TimedImpact& y) { return x.time_s < y.time_s; });
    return result;
  }

 private:
  BodyState start(int i) const { return load_body(input_.state, count_, static_cast<size_t>(i)); }

  Flight flight(int i) const {
    const Body& body = bodies_[static_cast<size_t>(i)];
    if (!body.is_dynamic()) {
      return {body, start(i), load_body(input_.free, count_, static_cast<size_t>(i)), input_.step_s};
    }
    const auto a = [&](size_t row) { return input_.accelerations[row * count_ + static_cast<size_t>(i)]; };
    return {body, start(i), {a(0), a(1), a(2)}, {a(3), a(4), a(5)}};
  }

  bool touches(int a, int b) const {
    const BodyState state_a = start(a), state_b = start(b);
    std::vector<Contact> contacts;
    finder_.manifold(a, state_a.pose, b, state_b.pose, kTouch_m, contacts);
    if (contacts.empty()) return false;
    const Moving moving_a = moving(bodies_[static_cast<size_t>(a)], state_a);
    const Moving moving_b = moving(bodies_[static_cast<size_t>(b)], state_b);
    return std::any_of(contacts.begin(), contacts.end(), [&](const Contact& c) {
      return relative_velocity(moving_a, moving_b, c.point_m).dot(c.normal) <= bodies_.contact_threshold_m_s;
    });
  }

  ContactFinder::Pairs touching_pairs() const {
    ContactFinder::Pairs pairs = finder_.pairs_at(input_.state, kTouch_m);
    std::erase_if(pairs, [&](const std::pair<int, int>& pair) { return !touches(pair.first, pair.second); });
    return pairs;
  }

  // A body that a contact throws may go where its free motion does not: as far as the fastest one could bring
  // it.
  ContactFinder::Pairs pairs_within_reach() const {
    double fastest = 0;
    for (int i = 0; i < static_cast<int>(count_); ++i) {
      const Flight body = flight(i);
      fastest =
          std::max(fastest, body.now().velocity_m_s.norm() + body.speed_about_center_m_s(input_.step_s));
    }
    ContactFinder::Pairs pairs =
        finder_.pairs_between(input_.state, input_.free, input_.step_s, kTouch_m + fastest * input_.step_s);
    std::vector<Contact> contacts;
    std::erase_if(pairs, [&](const std::pair<int, int>& pair) {
      const Flight a = flight(pair.first), b = flight(pair.second);
      contacts.clear();
      finder_.manifold(pair.first, a.pose(), pair.second, b.pose(), kTouch_m + 2 * fastest * input_.step_s,
                       contacts);
      return contacts.empty();
    });
    return pairs;
  }

  void move(const Island& island, const ContactFinder::Pairs& pairs, AdvanceResult& result) const {
    std::map<int, Flight> flights;
    std::vector<std::pair<int, int>> links;
    for (int n : island.links) {
      const auto& [a, b] = links.emplace_back(pairs[static_cast<size_t>(n)]);
      for (int i : {a, b}) {
        if (!flights.contains(i)) flights.emplace(i, flight(i));
      }
    }
    IslandMotion motion(bodies_, finder_.manifold, std::move(flights), std::move(links));
    motion.advance(input_.step_s, input_.substeps);
    for (int i : island.bodies) {
      if (!motion.touched(i)) continue;
      store_body(result.state.data(), count_, static_cast<size_t>(i), motion.state(i));
      result.moved.push_back(i);
    }
    add(motion.account(), result.account);
  }

  static void add(const ContactAccount& island, ContactAccount& all) {
    all.impacts.insert(all.impacts.end(), island.impacts.begin(), island.impacts.end());
    all.dissipated_impact_J += island.dissipated_impact_J;
    all.dissipated_friction_J += island.dissipated_friction_J;
    all.work_of_told_J += island.work_of_told_J;
    all.contacts += island.contacts;
    all.iterations = std::max(all.iterations, island.iterations);
    all.residual_m_s = std::max(all.residual_m_s, island.residual_m_s);
  }

  const Bodies& bodies_;
  const ContactFinder& finder_;
  const AdvanceInput& input_;
  size_t count_;
};

}  // namespace

AdvanceResult advance(const Bodies& bodies, const ContactFinder& finder, const AdvanceInput& input) {
  assert(input.step_s > 0 && input.substeps >= 1);
  return Step(bodies, finder, input).run();
}

}  // namespace animado::colisao
