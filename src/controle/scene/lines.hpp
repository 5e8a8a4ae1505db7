// The lines of a scene file: UTF-8 checked, comments cut off, folded for reading. Columns count characters,
// not bytes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "controle/scene/scene.hpp"

namespace animado::controle {

class Line {
 public:
  Line(int number, std::string_view raw);

  const std::string& folded() const { return folded_; }  // a character each, no blanks at the end
  std::string written(size_t from, size_t to) const;     // the characters [from, to) as in the file
  Place place(size_t at) const { return {number_, static_cast<int>(at) + 1}; }

  size_t skip_blanks(size_t at) const;
  size_t end_of_word(size_t at) const;  // letters, digits and _ from `at` on

  // The text of a heading, "##### text", from its column; folded().size() when the line is none.
  size_t heading() const { return heading_; }

 private:
  int number_;
  std::string raw_, folded_;
  std::vector<size_t> starts_;  // byte of raw_ where each character starts, and where the last one ends
  size_t heading_;
};

// Throws Error: syntax when the text is not UTF-8 or holds control characters.
std::vector<Line> lines_of(std::string_view text, std::string_view path);

bool is_letter(char c);     // of an identifier; folded
bool is_word_char(char c);  // a letter or a digit

}  // namespace animado::controle
