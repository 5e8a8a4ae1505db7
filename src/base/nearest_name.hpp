// The known name nearest to what was typed, for messages that suggest it.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace animado {

// The candidate with the smallest Damerau–Levenshtein (optimal string alignment) distance to `word`, if that
// is at most a third of the word's length, or 1 in words of two or more letters; else empty. The first of
// equals.
std::string nearest_name(std::string_view word, std::span<const std::string> candidates);

}  // namespace animado
