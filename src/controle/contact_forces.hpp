// Elastic contact (the paper, section 3.4.2, equation 2): colisao's spring forces, added at every stage
// (response spring).
#pragma once

#include <vector>

#include "colisao/client.hpp"
#include "controle/equations_of_motion.hpp"
#include "controle/free_motion.hpp"
#include "controle/meter.hpp"

namespace animado::controle {

class SpringContacts : public ContactForces {
 public:
  SpringContacts(colisao::Client& colisao, Workspace& workspace, Meter& meter, const World& world,
                 std::span<const Inertia> inertias);

  double add(const Lanes& state, double* wrenches) override;
  double stored_J(const Lanes& state);  // in the springs, of a state

 private:
  colisao::Springs::Reply springs(const Lanes& state);

  colisao::Client& colisao_;
  Meter& meter_;
  std::vector<Inertia> inertias_;
  colisao::Springs::Request request_;
  Lanes wrenches_;
};

}  // namespace animado::controle
