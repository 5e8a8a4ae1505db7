// What egesp's handlers refuse alike, and what they all say about accuracy.
#pragma once

#include <span>

#include "egesp/batch.hpp"
#include "egesp/protocol.accuracy.hpp"
#include "egesp/protocol.batch.hpp"

namespace animado::egesp {

// Throws bad_params unless 0 ≤ T < 1.
double checked_threshold(double threshold);

PivotRule checked_rule(Pivoting pivoting, double threshold);  // throws bad_params likewise

// What a reply says about the systems that have no solution. Throws singular or not_finite about the first of
// them unless the request wants them reported. n, count: of the batch.
std::vector<RefusedSystem> reported(const std::vector<Refusal>& refusals, OnSingular on_singular,
                                    size_t count, size_t n, const PivotRule& rule);

// Throws not_finite, which names the element.
void refuse_infinite(std::span<const double> numbers, const char* where);

// How many right-hand sides, shape (n) or (n, m), one matrix of n rows has. Throws bad_shape, limit.
size_t right_sides_of(std::span<const int64_t> shape, int64_t n);

// Throws not_finite when a solution left the doubles.
void refuse_overflow(std::span<const double> solutions);

// The reply's account of these, with a warning when the worst condition asks for one.
Accuracy accuracy_of(std::vector<double> backward_errors, std::vector<double> reciprocal_conditions);

}  // namespace animado::egesp
