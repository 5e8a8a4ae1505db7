// What messages between a run that is watched and the pages that watch it have in common. Each is a JSON
// object, a WebSocket text; web/README.md lists them.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "base/error.hpp"

namespace animado::live {

inline constexpr std::array<std::string_view, 5> kModules = {"interexpserv", "egesp", "fred", "colisao",
                                                             "controle"};

inline std::string text_of(const nlohmann::json& message) {
  return message.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

inline nlohmann::json json_of(const Error& error) {
  return {{"message", error.message()}, {"where", error.where()}, {"remedy", error.remedy()}};
}

}  // namespace animado::live
