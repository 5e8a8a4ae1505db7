// The messages between a run that is watched and the pages that watch it: JSON objects as WebSocket texts,
// told apart by `type`.
//
// To the page:
//   hello     version, scene, scene_text, bodies (as in bodies.json), start_s, end_s, step_s, frames, names:
//   [{name,
//             text}] that may be edited, modules; the first one
//   frame     frame, time_s, position: [x, y, z, …] m, rotation: [w, x, y, z, …], facts: {column of
//   frames.csv: number} event     a line of events.jsonl log       module, lines pace      paused, speed
//   (simulated seconds a second; 0: as fast as it can) checked   name, text, error: null or {message, where,
//   remedy} edited    name, text: it was sent, and acts from the next frame on; an event `edit` tells when it
//   does refused   name, text, error end       status, state_hash
// From the page:
//   pause · resume · step · speed (value) · check (name, text) · edit (name, text)
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
