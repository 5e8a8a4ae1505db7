#include "interexpserv/expression_error.hpp"

#include <algorithm>
#include <vector>

namespace animado::interexpserv {
namespace {

constexpr size_t kShownBefore = 60, kShownAfter = 40;  // code points around the caret: a line of a terminal

size_t length_of(unsigned char lead) {
  return lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
}

// The text cut into code points. Line breaks and tabs would move the caret and become blanks; bytes that are
// not UTF-8 would make the message unreadable for others and become '?'.
std::vector<std::string> code_points(std::string_view text) {
  std::vector<std::string> points;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0) == 0x80 && !points.empty()) {
      points.back() += c;
    } else {
      points.emplace_back(1, byte < 0x20 ? ' ' : c);
    }
  }
  for (std::string& point : points) {
    const auto lead = static_cast<unsigned char>(point[0]);
    const bool whole = lead < 0x80 ? point.size() == 1 : lead >= 0xC0 && point.size() == length_of(lead);
    if (!whole) point.assign(1, '?');
  }
  return points;
}

std::string with_caret(std::string_view text, size_t column) {
  const std::vector<std::string> points = code_points(text);
  const size_t first = column > kShownBefore ? column - kShownBefore : 0;
  const size_t last = std::min(points.size(), column + kShownAfter);
  std::string shown = first > 0 ? "…" : "";
  std::string caret(first > 0 ? 1 : 0, ' ');
  for (size_t i = first; i < last; ++i) shown += points[i];
  if (last < points.size()) shown += "…";
  caret += std::string(column - first, ' ') + "^";
  return "  " + shown + "\n  " + caret;
}

}  // namespace

ExpressionError::ExpressionError(Code code, std::string_view what_is_wrong, std::string_view text,
                                 size_t column, std::string_view where, std::string remedy)
    : Error(code, std::string(what_is_wrong) + "\n" + with_caret(text, column), std::string(where),
            remedy.empty() ? "docs/expressions.md lists what can be written" : std::move(remedy)),
      column_(column),
      what_is_wrong_(what_is_wrong) {}

ExpressionError::ExpressionError(Code code, const std::string& message, std::string_view where,
                                 std::string remedy, size_t column, std::string_view what_is_wrong)
    : Error(code, message, std::string(where), std::move(remedy)),
      column_(column),
      what_is_wrong_(what_is_wrong) {}

ExpressionError ExpressionError::within(std::string_view definition, size_t column,
                                        std::string_view where) const {
  const std::string_view shown_text = std::string_view(message()).substr(what_is_wrong_.size());
  const std::string prefix = "in the definition of `" + std::string(definition) + "`: ";
  const bool innermost = !what_is_wrong_.starts_with("in the definition of ");
  const std::string wrong = (innermost ? prefix : "") + what_is_wrong_;
  return {code(), wrong + std::string(shown_text), where, remedy(), column, wrong};
}

}  // namespace animado::interexpserv
