// One object's properties → a Body, checked on its own; what it has to do with others is checked later.
#pragma once

#include "controle/scene/constants.hpp"

namespace animado::controle {

Body read_body(const Outline& outline, size_t object, const Constants& constants);

// Its parts.
void read_motion(const Outline& outline, const Section& object, Body& body);
void read_mass(const Outline& outline, size_t object, const Constants& constants, Body& body);

// What follows from one line that gives a number within bounds.
double number_at_least(const Outline& outline, const Entry& entry, const Constants& constants, double least);

}  // namespace animado::controle
