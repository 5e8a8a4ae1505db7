// What a page of the documentation shows.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/temporary_directory.hpp"

namespace animado::suite {

// The code blocks of a page that open with ```LANGUAGE.
inline std::vector<std::string> blocks(const std::filesystem::path& page, const std::string& language) {
  const std::string text = text_of(page), opening = "\n```" + language + "\n", closing = "\n```";
  std::vector<std::string> found;
  for (size_t at = text.find(opening); at != std::string::npos; at = text.find(opening, at)) {
    const size_t begin = at + opening.size();
    at = text.find(closing, begin);
    if (at == std::string::npos) break;
    found.push_back(text.substr(begin, at + 1 - begin));
  }
  return found;
}

}  // namespace animado::suite
