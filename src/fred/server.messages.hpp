// FRED's table in parts: server.stage.cpp for callers that own the derivative, server.integrate.cpp for
// systems of expressions.
#pragma once

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"
#include "fred/control.hpp"
#include "rpc/service.hpp"

namespace animado::fred {

void add_stage_messages(rpc::Service& service);
void add_integrate_message(rpc::Service& service, rpc::Suite& suite);

void refuse_infinite(double value, const std::string& where);

// Throws bad_params for what is no tolerance of `size` numbers.
Tolerance checked_tolerance(std::vector<double> absolute, std::vector<double> relative, size_t size);

}  // namespace animado::fred
