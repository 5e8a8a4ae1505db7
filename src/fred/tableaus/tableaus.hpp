// The explicit methods, the default first: the one list from which tableaus() is made and steps are compiled.
#pragma once

#include "fred/tableaus/classical.hpp"
#include "fred/tableaus/dop853.hpp"
#include "fred/tableaus/embedded.hpp"
#include "fred/tableaus/verner87.hpp"

namespace animado::fred {

template <const auto&... kMethods>
struct ListOf {};

using EveryMethod = ListOf<kRk4, kGill, kRk38, kHeun3, kMidpoint, kHeun, kEuler, kBs23, kFehlberg45,
                           kCashKarp, kDopri5, kDop853, kVerner87>;

}  // namespace animado::fred
