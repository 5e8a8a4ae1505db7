#include "base/fold.hpp"

#include <algorithm>
#include <cstdint>

namespace animado {
namespace {

// U+00C0 … U+00FF without their accents; '?' where there is no such letter.
constexpr std::string_view kLatin1 =
    "aaaaaaaceeeeiiiidnooooo?ouuuuyts"
    "aaaaaaaceeeeiiiidnooooo?ouuuuyty";

bool continues(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0) == 0x80;
}

// Of the code point at the front. Where a lead byte lacks its continuations it stands alone, and takes no
// line's end with it.
size_t length_of_sequence(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  size_t length = 1;
  if ((lead & 0xE0) == 0xC0) length = 2;
  if ((lead & 0xF0) == 0xE0) length = 3;
  if ((lead & 0xF8) == 0xF0) length = 4;
  if (length > text.size()) return 1;
  return std::all_of(text.begin() + 1, text.begin() + static_cast<ptrdiff_t>(length), continues) ? length : 1;
}

}  // namespace

std::string fold(std::string_view text) {
  std::string folded;
  folded.reserve(text.size());
  for (size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const size_t length = length_of_sequence(text.substr(i));
    if (lead < 0x80) {
      folded += lead >= 'A' && lead <= 'Z' ? static_cast<char>(lead - 'A' + 'a') : static_cast<char>(lead);
    } else if (lead == 0xC3 && length == 2) {
      folded += kLatin1[static_cast<unsigned char>(text[i + 1]) & 0x3F];
    } else {
      folded += '?';
    }
    i += length;
  }
  return folded;
}

}  // namespace animado
