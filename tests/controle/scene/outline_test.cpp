// src/controle/scene/outline.cpp, lines.cpp: the grammar.
#include "controle/scene/outline.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"

namespace animado::controle {
namespace {

using testing::ElementsAre;

Outline outline_of(const std::string& text) {
  return read_outline(text, "s");
}

TEST(Outline, LinesMayBeSeparatedByEqualsColonOrBlank) {
  const Outline outline = outline_of("object a\nmass 1\nfriction=2\nposition : (1, 2, 3)\nvelocity(1,2,3)\n");
  std::vector<std::string> values;
  for (const Entry& entry : outline.objects[0].entries) values.push_back(entry.value.text);
  EXPECT_THAT(values, ElementsAre("1", "2", "(1, 2, 3)", "(1,2,3)"));
}

TEST(Outline, LongestNameWins) {
  const Outline outline = outline_of(
      "object a\nrotation order zyx\nrotation (1,2,3)\npath position (1,2,3)\nmomento de inercia "
      "(1,1,1)\nvelocidade angular (0,0,0)\n");
  std::vector<std::string_view> names;
  for (const Entry& entry : outline.objects[0].entries) names.push_back(entry.property->canonical);
  EXPECT_THAT(names, ElementsAre("rotation order", "rotation", "path position", "moments of inertia",
                                 "angular velocity"));
}

TEST(Outline, CommentsEndLinesButNotTexts) {
  const Outline outline = outline_of(
      "object a # the first\nmass 1# kg\nshape hull(\"a#1.obj\") # a file\n#####\n# mass 2\n###### OBJETO "
      "b\n##### a remark\n");
  ASSERT_EQ(outline.objects.size(), 1u);
  EXPECT_EQ(outline.objects[0].find("mass")->value.text, "1");
  EXPECT_EQ(outline.objects[0].find("shape")->value.text, "hull(\"a#1.obj\")");
}

TEST(Outline, HeadingsOfThePaperOpenAndReopenObjects) {
  const Outline outline = outline_of(
      "##### OBJETOS ENVOLVIDOS: esfera, cubo e cone\n##### CARACTERÍSTICAS DA ESFERA\nmassa 1\n##### "
      "CARACTERISTICAS DO CUBO\nmassa do cubo 2\n"
      "##### CONDICoes INICIAIS DA ESFERA\nmovimento static\n##### TEMPO NA ANIMACAO #####\ntempo final "
      "3\n##### MUNDO\ngravidade (0,0,0)\n");
  EXPECT_THAT(outline.object_names(), ElementsAre("esfera", "cubo", "cone"));
  EXPECT_EQ(outline.objects[0].entries.size(), 2u);
  EXPECT_EQ(outline.objects[1].find("mass")->value.text, "2");
  EXPECT_EQ(outline.time.find("end")->value.text, "3");
  EXPECT_TRUE(outline.world.find("gravity"));
}

TEST(Outline, HeadingsMayBeEnglish) {
  const Outline outline = outline_of(
      "##### OBJECTS INVOLVED: ball and cube\n##### CHARACTERISTICS OF THE BALL\nmass of the ball 1\n##### "
      "INITIAL CONDITIONS OF CUBE\nmass 2\n"
      "##### TIME OF THE ANIMATION\nend 1\n");
  EXPECT_EQ(outline.objects[0].find("mass")->value.text, "1");
  EXPECT_EQ(outline.objects[1].find("mass")->value.text, "2");
  EXPECT_TRUE(outline.time.find("end"));
}

TEST(Outline, ObjectsMayJoinThoseOfTheHeading) {
  const Outline outline =
      outline_of("##### OBJETOS ENVOLVIDOS: esfera e cubo\nobject floor\nmotion static\n");
  EXPECT_THAT(outline.object_names(), ElementsAre("esfera", "cubo", "floor"));
}

TEST(Outline, DefinitionsHaveDottedNames) {
  const Outline outline = outline_of("spring.k = 3\nobject a\nArm.Len.x=mass/2\nmass = 1\n");
  ASSERT_EQ(outline.names.size(), 2u);
  EXPECT_EQ(outline.names[0].name, "spring.k");
  EXPECT_EQ(outline.names[0].value.owner, -1);
  EXPECT_EQ(outline.names[1].name, "arm.len.x");
  EXPECT_EQ(outline.names[1].value.owner, 0);
  EXPECT_EQ(outline.names[1].value.place.column, 11);
}

TEST(Outline, LineEndsAndMarksOfOtherSystemsAreFine) {
  const Outline outline = outline_of("\xEF\xBB\xBFobject a\r\n\tmass 1\r\n");
  EXPECT_EQ(outline.objects[0].place.column, 8);
  EXPECT_EQ(outline.objects[0].find("mass")->value.text, "1");
}

TEST(Outline, NamesKeepTheirSpelling) {
  const Outline outline = outline_of("object Maçã\nmass 1\nobject MACA\nfriction 1\n");
  ASSERT_EQ(outline.objects.size(), 1u);
  EXPECT_EQ(outline.objects[0].name, "Maçã");
  EXPECT_EQ(outline.objects[0].folded_name, "maca");
}

}  // namespace
}  // namespace animado::controle
