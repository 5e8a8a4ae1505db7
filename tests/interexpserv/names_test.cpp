// src/interexpserv/names.cpp: all or nothing, dependents follow, cycles are listed.
#include "interexpserv/names.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/error_of.hpp"

namespace animado::interexpserv {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::span<const double> no_numbers(const std::string& array) {
  throw Error(Code::unknown_array, "no shared array " + array, array, "");
}

std::vector<std::string> names_of(const std::vector<NameRow>& rows) {
  std::vector<std::string> names;
  for (const NameRow& row : rows) names.push_back(row.name);
  return names;
}

std::vector<std::string> define(Names& names, std::vector<NamedText> definitions) {
  return names_of(names.define(definitions));
}

std::vector<std::string> remove(Names& names, std::vector<std::string> which) {
  return names_of(names.remove(which));
}

double number(const Names& names, std::string_view name) {
  return names.value(name, no_numbers).v[0];
}

Names spring() {
  Names names;
  define(names, {{"ball.mass", "2"}, {"spring.k", "4*pi^2*ball.mass"}, {"ball.weight", "(0, -10*mass, 0)"}});
  return names;
}

TEST(Names, AChangeFlowsToWhatDependsOnIt) {
  Names names = spring();
  EXPECT_DOUBLE_EQ(number(names, "spring.k"), 8 * M_PI * M_PI);
  EXPECT_THAT(define(names, {{"Ball.Mass", "3"}}), ElementsAre("ball.mass", "ball.weight", "spring.k"));
  EXPECT_DOUBLE_EQ(number(names, "spring.k"), 12 * M_PI * M_PI);
  EXPECT_EQ(names.value("ball.weight", no_numbers), Value::vector(0, -30, 0));
}

TEST(Names, TheOrderInARequestDoesNotMatter) {
  Names names;
  define(names, {{"a", "b + 1"}, {"b", "c + 1"}, {"c", "1"}});
  EXPECT_EQ(number(names, "a"), 3);
  EXPECT_EQ(names.version(), 1);
}

TEST(Names, ARequestIsDoneWholeOrNotAtAll) {
  Names names = spring();
  const Error error = error_of([&] { define(names, {{"ball.mass", "5"}, {"other", "1 +"}}); });
  EXPECT_EQ(error.code(), Code::syntax);
  EXPECT_EQ(error.where(), "other");
  EXPECT_EQ(number(names, "ball.mass"), 2);
  EXPECT_EQ(names.version(), 1);
  EXPECT_THAT(names_of(names.rows("")), ElementsAre("ball.mass", "ball.weight", "spring.k"));
}

TEST(Names, ACycleIsListed) {
  Names names;
  define(names, {{"a", "1"}, {"b", "a"}, {"c", "b"}});
  const Error error = error_of([&] { define(names, {{"a", "2*c"}}); });
  EXPECT_EQ(error.code(), Code::cycle);
  EXPECT_THAT(error.message(), HasSubstr("c → b → a → c"));
  EXPECT_EQ(number(names, "c"), 1);
  EXPECT_EQ(error_of([&] { define(names, {{"x1", "x2"}, {"x2", "x1"}}); }).code(), Code::cycle);
  EXPECT_EQ(error_of([&] { define(names, {{"own", "own + 1"}}); }).code(), Code::cycle);
}

// ball.force uses the world's k until the ball has one of its own.
TEST(Names, ANearerNameTakesOver) {
  Names names;
  define(names, {{"k", "1"}, {"ball.force", "(k, 0, 0)"}});
  EXPECT_THAT(define(names, {{"ball.k", "7"}}), ElementsAre("ball.force", "ball.k"));
  EXPECT_EQ(number(names, "ball.force"), 7);
  EXPECT_THAT(remove(names, {"ball.k"}), ElementsAre("ball.force", "ball.k"));
  EXPECT_EQ(number(names, "ball.force"), 1);
}

TEST(Names, KeepTheirType) {
  Names names = spring();
  const Error error = error_of([&] { define(names, {{"ball.weight", "3"}}); });
  EXPECT_EQ(error.code(), Code::type);
  EXPECT_THAT(error.message(), HasSubstr("is a vector, this would make it a scalar"));
  remove(names, {"ball.weight"});
  define(names, {{"ball.weight", "3"}});
  EXPECT_EQ(names.row("ball.weight").type, Type::scalar);
}

TEST(Names, KeepTheirTypeWhenANearerNameTakesOver) {
  Names names;
  define(names, {{"k", "1"}, {"ball.pull", "2*k"}});
  EXPECT_EQ(error_of([&] { define(names, {{"ball.k", "(1, 2, 3)"}}); }).code(), Code::type);
  EXPECT_EQ(names.row("ball.pull").type, Type::scalar);
  EXPECT_EQ(number(names, "ball.pull"), 2);
  EXPECT_THAT(define(names, {{"k", "3"}}), ElementsAre("ball.pull", "k"));
}

TEST(Names, WhatOthersNeedIsNotRemoved) {
  Names names = spring();
  const Error error = error_of([&] { remove(names, {"ball.mass"}); });
  EXPECT_EQ(error.code(), Code::conflict);
  EXPECT_THAT(error.message(), HasSubstr("ball.weight needs"));
  EXPECT_EQ(number(names, "ball.mass"), 2);
  remove(names, {"spring.k", "ball.weight", "ball.mass"});
  EXPECT_TRUE(names.rows("").empty());
  EXPECT_EQ(error_of([&] { remove(names, {"ball.volume"}); }).code(), Code::unknown_name);
}

TEST(Names, RefusesWhatIsNoName) {
  Names names;
  for (const char* name :
       {"", ".", "a.", ".a", "a..b", "2a", "a b", "a-b", "pi", "ball.t", "e", "not", "true", "a\xff", "中"}) {
    EXPECT_EQ(error_of([&] { define(names, {{name, "1"}}); }).code(), Code::bad_params) << name;
  }
  EXPECT_EQ(error_of([&] { define(names, {{"a", "1"}, {"A", "2"}}); }).code(), Code::bad_params);
  define(names, {{"Posição.Inicial", "1"}});
  EXPECT_EQ(number(names, "posicao.inicial"), 1);
}

TEST(Names, AnUnknownNameSuggestsTheNearest) {
  const Names names = spring();
  const Error error = error_of([&] { names.value("ball.mas", no_numbers); });
  EXPECT_EQ(error.code(), Code::unknown_name);
  EXPECT_THAT(error.remedy(), HasSubstr("`ball.mass`"));
}

TEST(Names, ChangesSinceAVersion) {
  Names names = spring();               // version 1
  define(names, {{"free", "1"}});       // 2
  define(names, {{"ball.mass", "4"}});  // 3
  remove(names, {"free"});              // 4
  EXPECT_EQ(names.version(), 4);
  EXPECT_THAT(names_of(names.changes(0)), ElementsAre("ball.mass", "ball.weight", "spring.k", "free"));
  EXPECT_THAT(names_of(names.changes(3)), ElementsAre("free"));
  EXPECT_EQ(names.changes(3)[0].kind, NameRow::Kind::removed);
  EXPECT_TRUE(names.changes(4).empty());
  EXPECT_EQ(names.changes(99).size(), 4u);  // the asker knew a registry that is gone
}

TEST(Names, PrefixesAreNamespaces) {
  EXPECT_TRUE(is_within("ball.mass", "ball"));
  EXPECT_TRUE(is_within("ball.mass", "ball."));
  EXPECT_TRUE(is_within("ball.mass", "ball.mass"));
  EXPECT_TRUE(is_within("ball.mass", ""));
  EXPECT_FALSE(is_within("ballast", "ball"));
  EXPECT_FALSE(is_within("ball", "ball.mass"));
  const Names names = spring();
  EXPECT_THAT(names_of(names.rows("BALL")), ElementsAre("ball.mass", "ball.weight"));
}

TEST(Names, ARequestSentAgainChangesNothing) {
  Names names = spring();
  EXPECT_TRUE(define(names, {{"ball.mass", "2"}, {"spring.k", "4*pi^2*ball.mass"}}).empty());
  EXPECT_EQ(names.version(), 1);
  EXPECT_THAT(remove(names, {"spring.k"}), ElementsAre("spring.k"));
  EXPECT_TRUE(remove(names, {"spring.k"}).empty());
  EXPECT_EQ(names.version(), 2);
}

// Two bodies in rows of two, behind the counter: t, px, px, py, py, pz, pz.
struct LiveWorld {
  std::vector<double> array = {4, 0.5, 10, 11, 20, 21, 30, 31};
  int pictures = 0;
  std::span<const double> operator()(const std::string& name) {
    if (name != "run.state") no_numbers(name);
    ++pictures;
    return array;
  }
};

void bind_world(Names& names) {
  const std::vector<NamedBinding> bindings = {{"t", Type::scalar, {"run.state", 1, 1}},
                                              {"ball.position", Type::vector, {"run.state", 2, 2}},
                                              {"cube.position", Type::vector, {"run.state", 3, 2}}};
  names.bind(bindings);
}

TEST(Names, ABoundNameIsReadWhereItLives) {
  LiveWorld world;
  Names names;
  bind_world(names);
  define(names, {{"gap", "norm(cube.position - ball.position)"}, {"late", "t > 1"}});
  EXPECT_EQ(names.value("Ball.Position", std::ref(world)), Value::vector(10, 20, 30));
  EXPECT_EQ(names.value("cube.position", std::ref(world)), Value::vector(11, 21, 31));
  EXPECT_DOUBLE_EQ(names.value("gap", std::ref(world)).v[0], std::sqrt(3.0));
  EXPECT_EQ(names.value("late", std::ref(world)), Value::boolean(false));
  world.array[1] = 2;
  EXPECT_EQ(names.value("late", std::ref(world)), Value::boolean(true));
  EXPECT_EQ(names.evaluate("2*position.y + t", "ball", std::ref(world)), Value::scalar(42));
}

TEST(Names, LiveNamesAndDefinitionsDoNotReplaceEachOther) {
  Names names;
  bind_world(names);
  EXPECT_EQ(error_of([&] { define(names, {{"ball.position", "(0, 0, 0)"}}); }).code(), Code::conflict);
  define(names, {{"k", "1"}});
  const std::vector<NamedBinding> over = {{"k", Type::scalar, {"run.state", 1, 1}}};
  EXPECT_EQ(error_of([&] { names.bind(over); }).code(), Code::conflict);
  bind_world(names);  // a new run takes its names again
  EXPECT_THAT(names_of(names.changes(0)), ElementsAre("k"));
}

TEST(Names, ABindingOutsideItsArrayIsRefusedWhenRead) {
  LiveWorld world;
  Names names;
  const std::vector<NamedBinding> bindings = {{"far", Type::vector, {"run.state", 6, 1}},
                                              {"gone", Type::scalar, {"other", 1, 1}}};
  names.bind(bindings);
  EXPECT_EQ(error_of([&] { names.value("far", std::ref(world)); }).code(), Code::bad_shape);
  EXPECT_EQ(error_of([&] { names.value("gone", std::ref(world)); }).code(), Code::unknown_array);
}

TEST(Names, TimeHasNoValueWhileNothingRuns) {
  Names names;
  define(names, {{"wave", "sin(t)"}});  // may be said before the run starts
  EXPECT_EQ(error_of([&] { names.value("wave", no_numbers); }).code(), Code::unavailable);
  LiveWorld world;
  bind_world(names);
  EXPECT_EQ(names.value("wave", std::ref(world)).v[0], std::sin(0.5));
}

TEST(Names, NothingChangesWhenTheStoreRefuses) {
  bool full = false;
  std::vector<std::string> kept;
  Names names([&](std::span<const NamedRevision> revisions) {
    if (full) throw Error(Code::unavailable, "the disk is full");
    for (const NamedRevision& revision : revisions) kept.push_back(revision.name);
  });
  define(names, {{"a", "1"}, {"b", "a"}});
  EXPECT_THAT(kept, ElementsAre("a", "b"));
  full = true;
  EXPECT_EQ(error_of([&] { define(names, {{"a", "2"}, {"new", "a"}}); }).code(), Code::unavailable);
  EXPECT_EQ(number(names, "b"), 1);
  EXPECT_EQ(names.version(), 1);
  EXPECT_EQ(names.history("a").size(), 1u);
  EXPECT_THAT(names_of(names.changes(0)), ElementsAre("a", "b"));
  full = false;
  EXPECT_THAT(define(names, {{"a", "3"}}), ElementsAre("a", "b"));
}

TEST(Names, AreTheSameAfterARestart) {
  std::vector<NamedRevision> kept;
  Names before([&](std::span<const NamedRevision> revisions) {
    kept.insert(kept.end(), revisions.begin(), revisions.end());
  });
  define(before, {{"ball.mass", "2"}, {"spring.k", "4*pi^2*ball.mass"}, {"ball.weight", "(0, -10*mass, 0)"}});
  bind_world(before);
  define(before, {{"height", "ball.position.y"}, {"free", "1"}});
  remove(before, {"free"});
  define(before, {{"ball.mass", "5"}});
  define(before, {{"last", "1"}});
  Names after;
  after.load(kept);
  EXPECT_EQ(after.version(), before.version());
  EXPECT_EQ(after.rows(""), before.rows(""));
  EXPECT_EQ(after.changes(0), before.changes(0));
  EXPECT_EQ(after.changes(4), before.changes(4));
  EXPECT_EQ(after.history("ball.mass"), before.history("ball.mass"));
  LiveWorld world;
  EXPECT_EQ(after.value("height", std::ref(world)), Value::scalar(20));
  EXPECT_THAT(define(after, {{"ball.mass", "1"}}), ElementsAre("ball.mass", "ball.weight", "spring.k"));
}

TEST(Names, AreSetOnlyAtTheExpectedVersion) {
  Names names = spring();  // version 1
  const auto set = [&](std::string text, std::vector<ExpectedVersion> expected) {
    const std::array definitions = {NamedText{"spring.k", std::move(text)}};
    return names.define(definitions, {.who = "editor", .expected = std::move(expected)});
  };
  set("1", {{"Spring.K", 1}});
  const Error late = error_of([&] { set("2", {{"spring.k", 1}}); });
  EXPECT_EQ(late.code(), Code::conflict);
  EXPECT_EQ(late.where(), "spring.k");
  EXPECT_THAT(late.message(), HasSubstr("`spring.k` has version 2, last changed by editor; 1 was expected"));
  EXPECT_EQ(number(names, "spring.k"), 1);
  // The same text as there is no excuse: who read version 1 has not seen it.
  EXPECT_EQ(error_of([&] { set("1", {{"spring.k", 1}}); }).code(), Code::conflict);
  // Other names may be asked for, and what they depend on counts.
  set("3", {{"ball.weight", 1}});
  define(names, {{"ball.mass", "7"}});
  EXPECT_EQ(error_of([&] { set("4", {{"ball.weight", 1}}); }).code(), Code::conflict);
  EXPECT_EQ(number(names, "spring.k"), 3);
}

TEST(Names, ZeroIsTheVersionOfWhatIsNotThere) {
  Names names;
  const std::array once = {NamedText{"once", "1"}};
  names.define(once, {.expected = {{"once", 0}}});
  EXPECT_EQ(error_of([&] { names.define(once, {.expected = {{"once", 0}}}); }).code(), Code::conflict);
  remove(names, {"once"});
  EXPECT_EQ(error_of([&] { names.define(once, {.expected = {{"once", 1}}}); }).code(), Code::conflict);
  EXPECT_EQ(names.define(once, {.expected = {{"once", 0}}}).size(), 1u);
}

TEST(Names, RememberTheirLastRevisions) {
  Names names;
  for (int i = 1; i <= 40; ++i) {
    const std::array definitions = {NamedText{"k", std::to_string(i)}};
    names.define(definitions, {.who = i % 2 ? "odd" : "even", .time_us = 1000 * i});
    if (i == 1) define(names, {{"twice", "2*k"}});
  }
  const std::vector<Revision> history = names.history("K");
  ASSERT_EQ(history.size(), kRevisionsKept);
  EXPECT_EQ(history.back().text, "40");
  EXPECT_EQ(history.front().text, "25");
  EXPECT_EQ(history.front().who, "odd");
  EXPECT_EQ(history.front().time_us, 25000);
  EXPECT_EQ(history.front().version, 26);
  EXPECT_EQ(names.history("twice").size(), 1u);  // it was changed by nobody
  remove(names, {"twice"});
  EXPECT_EQ(names.history("twice").back().kind, Revision::Kind::removed);
  EXPECT_EQ(error_of([&] { names.history("thrice"); }).code(), Code::unknown_name);
}

TEST(Names, AreReplacedAsAWhole) {
  Names names = spring();
  const std::vector<NamedText> before = names.definitions("");
  define(names, {{"ball.mass", "3"}, {"ball.drag", "0.1"}, {"late", "drag.all"}, {"drag.all", "2"}});
  remove(names, {"ball.weight"});
  const auto replace = [&](const std::vector<NamedText>& definitions, const char* prefix) {
    return names_of(names.replace(definitions, prefix));
  };
  EXPECT_THAT(replace(before, ""),
              ElementsAre("ball.drag", "ball.mass", "ball.weight", "drag.all", "late", "spring.k"));
  EXPECT_EQ(names.definitions("").size(), 3u);
  EXPECT_EQ(number(names, "ball.mass"), 2);
  EXPECT_TRUE(replace(before, "").empty());

  define(names, {{"needs", "ball.mass"}});
  const Error needed = error_of([&] { replace({}, "ball"); });
  EXPECT_EQ(needed.code(), Code::conflict);
  EXPECT_THAT(needed.message(), HasSubstr("needs"));
  EXPECT_EQ(error_of([&] { replace({{"other", "1"}}, "ball"); }).code(), Code::bad_params);
  EXPECT_EQ(error_of([&] { replace({{"ball.mass", "nothing"}}, "ball"); }).code(), Code::unknown_name);
  EXPECT_EQ(number(names, "needs"), 2);
}

TEST(Names, APrefixMayBeWrittenWithAStar) {
  for (const char* written : {"ball", "Ball.", "ball.*"})
    EXPECT_EQ(folded_prefix(written), "ball") << written;
  for (const char* all : {"", "*"}) EXPECT_EQ(folded_prefix(all), "") << all;
  for (const char* wrong : {"ba*", "ball*", "*.mass", "ball.*.x"})
    EXPECT_EQ(error_of([&] { folded_prefix(wrong); }).code(), Code::bad_params) << wrong;
}

// A change takes a time that depends on what it touches: were each of these to look at all names, the test
// would take an hour.
TEST(Names, AHundredThousandAreNoBurden) {
  constexpr int kCount = 100'000;
  Names names;
  std::vector<NamedText> all;
  for (int i = 0; i < kCount; ++i) all.push_back({fmt::format("body{}.mass", i), std::to_string(i)});
  EXPECT_EQ(names.define(all).size(), static_cast<size_t>(kCount));
  for (int i = 0; i < kCount; ++i) {
    define(names, {{fmt::format("body{}.mass", i), "1"}});
    ASSERT_EQ(names.changes(names.version() - 1).size(), 1u);
  }
  EXPECT_EQ(names.rows("body77").size(), 1u);
  EXPECT_THAT(error_of([&] { names.row("body5.mas"); }).remedy(), HasSubstr("`body5.mass`"));
  EXPECT_EQ(number(names, "body99999.mass"), 1);
}

TEST(Names, FunctionsAreDefinedAsTheyAreCalled) {
  Names names;
  const std::array<NamedText, 2> both = {{{"f(x)", "x^2 + 1"}, {"four", "f(3) - 6"}}};
  names.define(both);
  const Names::Numbers none = [](const std::string&) { return std::span<const double>(); };
  EXPECT_EQ(names.value("four", none).v[0], 4);
  EXPECT_EQ(names.row("f").text, "(x) = x^2 + 1");
  EXPECT_THROW(names.value("f", none), Error);
  const std::array<NamedText, 1> other = {{{"f(y)", "2*y"}}};
  EXPECT_EQ(names.define(other).size(), 2u);  // what calls it changes with it
  EXPECT_EQ(names.value("four", none).v[0], 0);
  const std::array<NamedText, 1> itself = {{{"f(x)", "f(x - 1)"}}};
  EXPECT_THROW(names.define(itself), Error);
  const std::array<NamedText, 1> arity = {{{"f(x, y)", "x + y"}}};
  EXPECT_THROW(names.define(arity), Error);  // four calls it with one value
}

}  // namespace
}  // namespace animado::interexpserv
