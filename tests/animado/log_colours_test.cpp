// src/animado/log_colours.cpp
#include "animado/log_colours.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace animado {
namespace {

std::string without_colours(std::string text) {
  for (size_t begin; (begin = text.find('\x1b')) != text.npos;)
    text.erase(begin, text.find('m', begin) + 1 - begin);
  return text;
}

// What stands between the last escape before a word and the word.
std::string colour_of(const std::string& word, const std::string& line) {
  const size_t at = line.find(word), begin = line.rfind('\x1b', at);
  return begin == line.npos ? "" : line.substr(begin, at - begin);
}

std::string line_of(const std::string& module, const std::string& level = "info") {
  return "2026-11-22T15:30:07.907416Z " + level + " " + module + " 24784#22 prepare matrices=2 1.8 µs ok";
}

TEST(LogColours, TheTextStaysAsItIs) {
  for (const std::string& line :
       {line_of("egesp"), line_of("fred", "warning"), line_of("controle", "error")}) {
    EXPECT_NE(coloured_log_line(line), line);
    EXPECT_EQ(without_colours(coloured_log_line(line)), line);
  }
}

TEST(LogColours, EachModuleHasItsOwn) {
  std::set<std::string> seen;
  for (const std::string module : {"interexpserv", "egesp", "fred", "colisao", "controle"}) {
    const std::string colour = colour_of(module, coloured_log_line(line_of(module)));
    EXPECT_TRUE(colour.ends_with('m')) << module;
    seen.insert(colour);
  }
  EXPECT_EQ(seen.size(), 5u);
}

TEST(LogColours, WarningsAndErrorsStandOut) {
  EXPECT_THAT(coloured_log_line(line_of("egesp", "warning")), testing::HasSubstr("\x1b[1;33mwarning"));
  EXPECT_THAT(coloured_log_line(line_of("egesp", "error")), testing::HasSubstr("\x1b[1;31mprepare"));
}

TEST(LogColours, AnotherLineComesBackAsItIs) {
  for (const std::string line : {"", "no log", "a b c d e f", "time info nobody - text"})
    EXPECT_EQ(coloured_log_line(line), line);
}

}  // namespace
}  // namespace animado
