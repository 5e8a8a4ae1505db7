// The tolerances of the response to collisions, each with its reason.
#pragma once

namespace animado::colisao {

// Surfaces nearer than this touch. Far above the rounding of positions of some hundred metres (1e-13 m) and
// of the time of an impact (1e-9 of a step), far below what can be seen.
inline constexpr double kTouch_m = 1e-6;

// Overlap that is left alone. Pushing bodies apart to zero would lift resting ones off their support again
// and again.
inline constexpr double kSlop_m = 1e-7;

// Share of an overlap that a sub-step removes: bodies that overlap come apart within a few sub-steps and are
// not thrown.
inline constexpr double kPushShare = 0.3;

// No sub-step moves a body further than this to remove an overlap.
inline constexpr double kLongestPush_m = 0.01;

// Displacements that remove an overlap need no more than this relative precision: the next sub-step measures
// again.
inline constexpr double kPushTolerance = 1e-4;

// The contact solver has converged when an iteration changes no relative velocity by more than this share of
// the largest one. A box at rest on an incline then creeps by 1e-12 of h g, which adds up to nothing in any
// run.
inline constexpr double kSolverTolerance = 1e-12;

// Impacts are answered more finely: what is left is the error of the momentum's distribution, not of a
// velocity that is solved again at the next sub-step.
inline constexpr double kImpactTolerance = 1e-14;

// Approach slower than this share of the largest relative velocity of the impact is rounding, and no reason
// for another round.
inline constexpr double kApproachTolerance = 1e-12;

// Contact blocks that one call of the solver may visit, and the iterations that it may always make: a handful
// of contacts converges, a heap of thousands stays affordable.
inline constexpr int kSolverVisits = 200'000;
inline constexpr int kFewestIterations = 30;
inline constexpr int kMostIterations = 2000;

// An island that is not through after so many iterations is near jamming, where the plain iteration needs
// thousands; a window of a few steps brings it down to tens. A large heap ends by its bound anyway.
inline constexpr int kPlainIterations = 15;
inline constexpr int kAndersonWindow = 6;
inline constexpr int kAndersonContacts = 100;

// Iterations without halving the residual after which more of them are of no use: it has reached the rounding
// of a contact that is about to open, or the heap is too large for this solver.
inline constexpr int kPatience = 150;

// Relative velocities are differences: below this share of the velocities themselves they are rounding.
inline constexpr double kRounding = 1e-15;

// Rounds of reflection: a chain of n bodies needs about n, so each contact adds some.
inline constexpr int kRoundsAlways = 100;
inline constexpr int kRoundsEachContact = 10;

}  // namespace animado::colisao
