#include "base/fold.hpp"

#include <cstdint>

namespace animado {
namespace {

// U+00C0 … U+00FF without their accents; '?' where there is no such letter.
constexpr std::string_view kLatin1 =
    "aaaaaaaceeeeiiiidnooooo?ouuuuyts"
    "aaaaaaaceeeeiiiidnooooo?ouuuuyty";

size_t length_of_sequence(unsigned char lead) {
  if (lead < 0x80) return 1;
  if ((lead & 0xE0) == 0xC0) return 2;
  if ((lead & 0xF0) == 0xE0) return 3;
  if ((lead & 0xF8) == 0xF0) return 4;
  return 1;
}

}  // namespace

std::string fold(std::string_view text) {
  std::string folded;
  folded.reserve(text.size());
  for (size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const size_t length = length_of_sequence(lead);
    if (lead < 0x80) {
      folded += lead >= 'A' && lead <= 'Z' ? static_cast<char>(lead - 'A' + 'a') : static_cast<char>(lead);
    } else if (lead == 0xC3 && i + 1 < text.size()) {
      folded += kLatin1[static_cast<unsigned char>(text[i + 1]) & 0x3F];
    } else {
      folded += '?';
    }
    i += length;
  }
  return folded;
}

}  // namespace animado
