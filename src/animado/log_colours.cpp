#include "animado/log_colours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace animado {

namespace {

constexpr std::string_view kDim = "2", kMethod = "1", kPlain = "0";

// 256-colour codes that colour-blind people tell apart on black and on white (after Okabe and Ito), each
// module its own.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kModules = {
    {{"interexpserv", "38;5;214"},
     {"egesp", "38;5;75"},
     {"fred", "38;5;36"},
     {"colisao", "38;5;175"},
     {"controle", "38;5;178"}}};

constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kLevels = {
    {{"info", kDim}, {"warning", "1;33"}, {"error", "1;31"}}};

std::string_view code_of(const auto& codes, std::string_view name) {
  const auto found = std::ranges::find(codes, name, [](const auto& entry) { return entry.first; });
  return found == codes.end() ? std::string_view() : found->second;
}

std::string_view next_word(std::string_view& rest) {
  const size_t end = std::min(rest.find(' '), rest.size());
  const std::string_view word = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return word;
}

std::string in(std::string_view code, std::string_view text) {
  return text.empty() ? std::string() : fmt::format("\x1b[{}m{}\x1b[0m", code, text);
}

}  // namespace

std::string coloured_log_line(std::string_view line) {
  std::string_view rest = line;
  const auto time = next_word(rest), level = next_word(rest), module = next_word(rest);
  const auto level_code = code_of(kLevels, level), module_code = code_of(kModules, module);
  if (level_code.empty() || module_code.empty()) return std::string(line);
  const auto trace = next_word(rest), method = next_word(rest);
  const bool alarming = level != "info";
  return fmt::format("{} {} {} {} {} {}", in(kDim, time), in(level_code, level), in(module_code, module),
                     in(kDim, trace), in(alarming ? level_code : kMethod, method),
                     in(alarming ? level_code : kPlain, rest));
}

}  // namespace animado
