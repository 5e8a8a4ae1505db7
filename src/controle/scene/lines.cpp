#include "controle/scene/lines.hpp"

#include "base/fold.hpp"
#include "controle/scene/refusal.hpp"

namespace animado::controle {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}
bool continues(char c) {
  return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

// The bytes of the well-formed UTF-8 sequence at `at`, 0 when it is not one. (Overlong forms and surrogates
// carry no text that a scene needs: the lengths alone keep columns right.)
size_t sequence(std::string_view text, size_t at) {
  const auto lead = static_cast<unsigned char>(text[at]);
  const size_t length = lead < 0x80                   ? 1
                        : lead >= 0xC2 && lead < 0xE0 ? 2
                        : (lead & 0xF0) == 0xE0       ? 3
                        : lead >= 0xF0 && lead < 0xF5 ? 4
                                                      : 0;
  if (length == 0 || at + length > text.size()) return 0;
  for (size_t k = 1; k < length; ++k) {
    if (!continues(text[at + k])) return 0;
  }
  return length;
}

void check_text(std::string_view line, int number, std::string_view path) {
  int column = 1;
  for (size_t at = 0; at < line.size(); ++column) {
    const size_t length = sequence(line, at);
    if (length == 0) {
      refuse(path, {number, column}, Code::syntax,
             fmt::format("byte 0x{:02X} is not UTF-8 text", static_cast<unsigned char>(line[at])),
             "save the scene as UTF-8 text");
    }
    const auto c = static_cast<unsigned char>(line[at]);
    if (c < 0x20 && c != '\t') {
      refuse(path, {number, column}, Code::syntax,
             fmt::format("control character 0x{:02X}: this is not a text file", c),
             "a scene is plain text, see docs/scene-format.md");
    }
    at += length;
  }
}

// Where the comment starts: the first # that is not between quotes.
size_t comment(std::string_view line) {
  bool quoted = false;
  for (size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (line[i] == '#' && !quoted) return i;
  }
  return line.size();
}

std::string_view trimmed_right(std::string_view text) {
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

// "##### text": exactly five. Where the text starts, or the line's end.
size_t heading_start(std::string_view line) {
  size_t at = 0;
  while (at < line.size() && is_blank(line[at])) ++at;
  const size_t text = line.find_first_not_of('#', at);
  if (text == std::string_view::npos || text - at != 5) return line.size();
  const size_t start = line.find_first_not_of(" \t", text);
  return start == std::string_view::npos ? line.size() : start;
}

}  // namespace

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || c == '_';
}
bool is_word_char(char c) {
  return is_letter(c) || (c >= '0' && c <= '9');
}

Line::Line(int number, std::string_view raw) : number_(number) {
  const bool is_heading = heading_start(raw) < raw.size();
  raw_ = trimmed_right(is_heading ? raw : raw.substr(0, comment(raw)));
  folded_ = fold(raw_);
  heading_ = is_heading ? heading_start(folded_) : folded_.size();
  for (size_t i = 0; i < raw_.size(); ++i) {
    if (!continues(raw_[i])) starts_.push_back(i);
  }
  starts_.push_back(raw_.size());
  assert(starts_.size() == folded_.size() + 1);
}

std::string Line::written(size_t from, size_t to) const {
  return raw_.substr(starts_[from], starts_[to] - starts_[from]);
}

size_t Line::skip_blanks(size_t at) const {
  while (at < folded_.size() && is_blank(folded_[at])) ++at;
  return at;
}

size_t Line::end_of_word(size_t at) const {
  while (at < folded_.size() && is_word_char(folded_[at])) ++at;
  return at;
}

std::vector<Line> lines_of(std::string_view text, std::string_view path) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  std::vector<Line> lines;
  while (!text.empty()) {
    const size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    const int number = static_cast<int>(lines.size()) + 1;
    check_text(line, number, path);
    lines.emplace_back(number, line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

}  // namespace animado::controle
