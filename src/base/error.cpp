#include "base/error.hpp"

#include <array>

namespace animado {
namespace {

constexpr std::array<std::string_view, 18> kNames = {
    "protocol",       "unknown_method", "bad_params",   "bad_shape", "not_finite",  "singular",
    "syntax",         "type",           "unknown_name", "cycle",     "conflict",    "unknown_array",
    "unknown_handle", "limit",          "refused",      "diverged",  "unavailable", "internal"};

std::string sentence(const std::string& message, const std::string& where, const std::string& remedy) {
  std::string text = where.empty() ? message : where + ": " + message;
  if (!remedy.empty()) text += "\n  " + remedy;
  return text;
}

}  // namespace

std::string_view name_of(Code code) {
  return kNames[static_cast<size_t>(code)];
}

Code code_named(std::string_view name) {
  for (size_t i = 0; i < kNames.size(); ++i) {
    if (kNames[i] == name) return static_cast<Code>(i);
  }
  return Code::internal;
}

Error::Error(Code code, std::string message, std::string where, std::string remedy)
    : std::runtime_error(sentence(message, where, remedy)),
      code_(code),
      message_(std::move(message)),
      where_(std::move(where)),
      remedy_(std::move(remedy)) {}

}  // namespace animado
