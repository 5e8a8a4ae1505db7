// The words of a scene, in one table: the parser, its suggestions and the table of docs/scene-format.md come
// from it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "interexpserv/program.hpp"

namespace animado::controle {

enum class Block { object, world, time };
std::string_view name_of(Block block);

struct Property {
  std::string_view canonical;
  Block block;
  interexpserv::Dimension dimension;       // plain: of what is no quantity
  std::vector<std::string_view> synonyms;  // folded
  std::string_view value;                  // what stands after it, for messages and the page
  std::string_view otherwise;              // what holds when it is left out; empty: nothing does
  bool adds_up = false;                    // may be given again; else a second time is an error
};
std::span<const Property> vocabulary();
std::vector<std::string> names_in(Block block);  // canonical names and synonyms

// The property with the longest name that `folded` begins with, up to a word's end; blanks between words may
// be any.
struct Match {
  const Property* property;
  size_t length;  // characters of `folded` that the name takes
};
std::optional<Match> longest_property(std::string_view folded);

// How many characters of `folded` the phrase takes, up to a word's end; 0 when it does not begin with it.
size_t match_phrase(std::string_view folded, std::string_view phrase);

// A word of a fixed list and the other ways to say it.
struct Word {
  std::string_view canonical;
  std::vector<std::string_view> synonyms;
};
// The canonical form, or empty.
std::string_view canonical_word(std::span<const Word> words, std::string_view folded);
std::vector<std::string> all_forms(std::span<const Word> words);

}  // namespace animado::controle
