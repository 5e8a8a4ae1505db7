// src/controle/scene/vocabulary.cpp, colors.cpp, and the tables of docs/scene-format.md, which are theirs.
#include "controle/scene/vocabulary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "base/fold.hpp"
#include "controle/scene/colors.hpp"
#include "controle/scene/shape_syntax.hpp"
#include "controle/scene/text_file.hpp"

namespace animado::controle {
namespace {

using testing::HasSubstr;

std::string code(std::string_view text) {
  return fmt::format("`{}`", text);
}

std::string row_of(const Property& property) {
  std::string synonyms;
  for (const std::string_view synonym : property.synonyms)
    synonyms += fmt::format("{}`{}`", synonyms.empty() ? "" : ", ", synonym);
  return fmt::format("| {} | {} | {} | {} |", code(property.canonical), synonyms, property.value,
                     property.otherwise.empty() ? "—" : property.otherwise);
}

std::string row_of(const ShapeForm& form) {
  return fmt::format("| {} | {} |", code(form.example), form.meaning);
}

size_t count(const std::string& text, const std::string& part) {
  size_t n = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(ScenePage, HasTheRowsOfTheVocabularyAndNoOthers) {
  const std::string page = read_text(ANIMADO_SOURCE_DIR "/docs/scene-format.md");
  for (const Property& property : vocabulary()) EXPECT_THAT(page, HasSubstr(row_of(property)));
  for (const ShapeForm& form : shape_forms()) EXPECT_THAT(page, HasSubstr(row_of(form)));
  EXPECT_EQ(count(page, "\n| `"), vocabulary().size() + shape_forms().size());
}

TEST(Vocabulary, NoNameMeansTwoThings) {
  std::set<std::string_view> seen;
  for (const Property& property : vocabulary()) {
    EXPECT_TRUE(seen.insert(property.canonical).second) << property.canonical;
    for (const std::string_view synonym : property.synonyms) {
      EXPECT_TRUE(seen.insert(synonym).second) << synonym;
      EXPECT_EQ(fold(synonym), synonym);
    }
  }
}

TEST(Vocabulary, EveryNameFindsItsProperty) {
  for (const Property& property : vocabulary()) {
    std::vector<std::string_view> names = property.synonyms;
    names.push_back(property.canonical);
    for (const std::string_view name : names) {
      const auto match = longest_property(std::string(name) + " 1");
      ASSERT_TRUE(match) << name;
      EXPECT_EQ(match->property->canonical, property.canonical);
      EXPECT_EQ(match->length, name.size());
    }
  }
}

TEST(Vocabulary, NamesEndWithTheirWord) {
  EXPECT_FALSE(longest_property("masses 1"));
  EXPECT_FALSE(longest_property("mass_1"));
  EXPECT_FALSE(longest_property("center ofmass 1"));
  EXPECT_EQ(longest_property("center \t of  mass(1,2,3)")->length, 17u);
  EXPECT_EQ(longest_property("position(1,2,3)")->length, 8u);
}

TEST(Colors, AreThoseOfCss) {
  EXPECT_EQ(color_names().size(), 148u);
  const Color color = *color_named("rebeccapurple");
  EXPECT_DOUBLE_EQ(color.r * 255, 0x66);
  EXPECT_DOUBLE_EQ(color.g * 255, 0x33);
  EXPECT_DOUBLE_EQ(color.b * 255, 0x99);
  EXPECT_FALSE(color_named("blurple"));
}

}  // namespace
}  // namespace animado::controle
