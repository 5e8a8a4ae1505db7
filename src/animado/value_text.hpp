// Values of names and expressions, as people and as programs read them.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "interexpserv/protocol.hpp"

namespace animado {

// "1.5", "true", "(0, -9.81, 0)": what the expression language reads again as the same value; "-" without
// values.
std::string value_text(interexpserv::Type type, std::span<const double> values);

// 1.5, true, [0, -9.81, 0]; null without values, and for numbers that are not finite.
nlohmann::ordered_json value_json(interexpserv::Type type, std::span<const double> values);

nlohmann::ordered_json name_json(const interexpserv::NameState& name);

}  // namespace animado
