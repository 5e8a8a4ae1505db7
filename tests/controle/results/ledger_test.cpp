// src/controle/results/ledger.hpp
#include "controle/results/ledger.hpp"

#include <gtest/gtest.h>

namespace animado::controle {
namespace {

// A ball is pushed from rest with 100 J, bounces with ε = 0.5 and is looked at right after: three quarters of
// the energy went into the impact.
TEST(EnergyLedger, ClosesOverABounce) {
  const EnergyLedger ledger{.initial_J = 0, .final_J = 25, .work_in_J = 100, .dissipated_impacts_J = 75};
  EXPECT_EQ(ledger.residual_J(), 0);
}

TEST(EnergyLedger, EveryLossCounts) {
  const EnergyLedger ledger{.initial_J = 64,
                            .final_J = 1,
                            .work_in_J = -32,
                            .dissipated_impacts_J = 16,
                            .dissipated_friction_J = 8,
                            .dissipated_damping_J = 4};
  EXPECT_EQ(ledger.residual_J(), -3);
}

TEST(EnergyLedger, EnergyFromNowhereIsPositive) {
  EXPECT_EQ((EnergyLedger{.initial_J = 1, .final_J = 1.5}.residual_J()), 0.5);
}

}  // namespace
}  // namespace animado::controle
