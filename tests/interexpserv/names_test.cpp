// src/interexpserv/names.cpp: all or nothing, dependents follow, cycles are listed.
#include "interexpserv/names.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

template <class F>
Error error_of(F&& f) {
  try {
    f();
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "nothing was refused";
  return {Code::internal, ""};
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
  std::vector<NameRow> kept;
  Names names([&](int64_t, std::span<const NameRow> rows) {
    if (full) throw Error(Code::unavailable, "the disk is full");
    kept.assign(rows.begin(), rows.end());
  });
  define(names, {{"a", "1"}, {"b", "a"}});
  EXPECT_THAT(names_of(kept), ElementsAre("a", "b"));
  full = true;
  EXPECT_EQ(error_of([&] { define(names, {{"a", "2"}}); }).code(), Code::unavailable);
  EXPECT_EQ(number(names, "b"), 1);
  EXPECT_EQ(names.version(), 1);
}

TEST(Names, AreTheSameAfterARestart) {
  Names before = spring();
  bind_world(before);
  define(before, {{"height", "ball.position.y"}, {"free", "1"}});
  remove(before, {"free"});
  std::vector<NameRow> rows = before.rows("");
  for (const NameRow& row : before.changes(0)) {
    if (row.kind == NameRow::Kind::removed) rows.push_back(row);
  }
  Names after;
  after.restore(rows, before.version());
  EXPECT_EQ(after.version(), before.version());
  EXPECT_EQ(after.rows(""), before.rows(""));
  EXPECT_EQ(after.changes(0), before.changes(0));
  LiveWorld world;
  EXPECT_EQ(after.value("height", std::ref(world)), Value::scalar(20));
  EXPECT_THAT(define(after, {{"ball.mass", "1"}}), ElementsAre("ball.mass", "ball.weight", "spring.k"));
}

}  // namespace
}  // namespace animado::interexpserv
