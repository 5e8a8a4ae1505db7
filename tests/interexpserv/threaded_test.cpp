// src/interexpserv/threaded.cpp: one evaluation, beside that of many by lanes.cpp.
#include "interexpserv/threaded.hpp"

#include <gtest/gtest.h>
#include <pthread.h>

#include <bit>
#include <cmath>
#include <random>

#include "interexpserv/program.hpp"

namespace animado::interexpserv {
namespace {

// Expressions of all operations, whose operands are constants, inputs, what was just computed, and what was
// computed before: of a few subexpressions many are the same, and are computed once.
class RandomText {
 public:
  std::string scalar(int depth) {
    if (depth == 0) return pick({"x", "y", "z", "0.5", "2"});
    const std::string a = scalar(depth - 1), b = scalar(depth - 1);
    switch (random_() % 4) {
      case 0:
        return pick({"sin", "cos", "exp", "sqrt", "abs", "-", "tan"}) + "(" + a + ")";
      case 1:
        return "(" + truth(depth - 1) + " ? " + a + " : " + b + ")";
      default:
        return "(" + a + pick({"+", "-", "*", "/", "^"}) + b + ")";
    }
  }

 private:
  std::string truth(int depth) {
    const std::string a = scalar(depth), b = scalar(depth);
    const std::string compared = "(" + a + pick({"<", "<=", ">", "==", "!="}) + b + ")";
    return random_() % 3 == 0 ? "(" + compared + pick({" and ", " or "}) + truth(depth) + ")" : compared;
  }
  std::string pick(std::initializer_list<const char*> choice) {
    return choice.begin()[random_() % choice.size()];
  }
  std::mt19937 random_{1};
};

uint64_t bits_of(double x) {
  return std::bit_cast<uint64_t>(std::isnan(x) ? NAN : x);
}

TEST(Threaded, HasTheBitsOfManyAtOnce) {
  MapScope scope;
  scope.input("x", Type::scalar).input("y", Type::scalar).input("z", Type::scalar);
  const std::map<std::string, double> values = {{"x", 1.25}, {"y", -0.75}, {"z", 3}};
  RandomText random;
  for (int i = 0; i < 2000; ++i) {
    const bool vector = i % 10 == 0;
    const std::string text =
        vector ? "(" + random.scalar(2) + ", " + random.scalar(0) + ", " + random.scalar(3) + ")"
               : random.scalar(i % 5);
    const Program program = compile(text, scope);
    std::vector<double> inputs;
    std::vector<Lanes> lanes;
    for (const Input& input : program.inputs()) inputs.push_back(values.at(input.name));
    for (const double& value : inputs) lanes.push_back({&value, true});
    std::array<double, 3> one{}, many{};
    program.evaluate(inputs.data(), one.data());
    const std::array<double*, 3> out = {&many[0], &many[1], &many[2]};
    program.evaluate_batch(lanes, 1, std::span(out).first(vector ? 3 : 1));
    for (size_t k = 0; k < 3; ++k) ASSERT_EQ(bits_of(one[k]), bits_of(many[k])) << text;
  }
}

// On a stack that has room for the registers (32 KiB), and not for 4,000 frames: steps jump, they do not
// call.
TEST(Threaded, ALongProgramNeedsNoDeepStack) {
  std::string text = "t";
  for (int i = 1; i < 4000; ++i) text += "+t";
  MapScope scope;
  scope.input("t", Type::scalar);
  struct Work {
    Program program;
    double t, value;
  } work = {compile(text, scope), 1, 0};
  const auto evaluate = [](void* of) -> void* {
    Work& w = *static_cast<Work*>(of);
    w.program.evaluate(&w.t, &w.value);
    return nullptr;
  };
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, 80 << 10), 0);
  pthread_t thread;
  ASSERT_EQ(pthread_create(&thread, &attributes, evaluate, &work), 0);
  pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
  EXPECT_EQ(work.value, 4000);
}

}  // namespace
}  // namespace animado::interexpserv
