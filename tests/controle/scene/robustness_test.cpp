// Whatever bytes are given as a scene, it is read or refused with a place: never a crash, never another
// exception.
#include <gtest/gtest.h>

#include <random>

#include "base/error.hpp"
#include "controle/scene/scene.hpp"

namespace animado::controle {
namespace {

// True when it was refused or read as it should be.
void read_or_refuse(const std::string& text) {
  try {
    parse_scene(text, "s");
  } catch (const Error& error) {
    EXPECT_TRUE(error.where().starts_with("s:")) << error.what();
    EXPECT_FALSE(error.remedy().empty()) << error.what();
  }
}

std::string paper() {
  return read_scene(ANIMADO_SOURCE_DIR "/scenes/colisao.animado").text;
}
std::string spring() {
  return read_scene(ANIMADO_SOURCE_DIR "/scenes/spring.animado").text;
}

TEST(Robustness, TruncatedScenes) {
  for (const std::string& text : {paper(), spring()}) {
    for (size_t length = 0; length < text.size(); ++length) read_or_refuse(text.substr(0, length));
  }
}

TEST(Robustness, ScenesWithAByteChanged) {
  std::mt19937 random(1);
  const std::string text = spring();
  for (int k = 0; k < 3000; ++k) {
    std::string changed = text;
    changed[random() % changed.size()] = static_cast<char>(random() % 256);
    read_or_refuse(changed);
  }
}

TEST(Robustness, ScenesWithWordsMixedUp) {
  const std::vector<std::string> words = {"object",
                                          "ball",
                                          "mass",
                                          "1",
                                          "(",
                                          ")",
                                          ",",
                                          "=",
                                          ".",
                                          "#####",
                                          "\n",
                                          "\"",
                                          "shape",
                                          "sphere",
                                          "force",
                                          "t",
                                          "-",
                                          ":",
                                          "OBJETOS ENVOLVIDOS:",
                                          "e",
                                          "world",
                                          "time",
                                          "a.b",
                                          "position",
                                          "motion",
                                          "path",
                                          "ç",
                                          "hull"};
  std::mt19937 random(2);
  for (int k = 0; k < 3000; ++k) {
    std::string text;
    for (size_t n = random() % 40; n > 0; --n)
      text += words[random() % words.size()] + (random() % 2 ? " " : "");
    read_or_refuse(text);
  }
}

TEST(Robustness, BinaryFiles) {
  std::mt19937 random(3);
  for (int k = 0; k < 300; ++k) {
    std::string text(random() % 300, '\0');
    for (char& c : text) c = static_cast<char>(random() % 256);
    read_or_refuse(text);
  }
}

TEST(Robustness, DeepNestingAndLongLines) {
  const auto many = [](char c) { return std::string(100'000, c); };
  read_or_refuse(fmt::format("object ball\nmass {}", many('(')));
  read_or_refuse(fmt::format("object ball\nmass {}", many('1')));
  read_or_refuse(fmt::format("object ball\nshape {}", many('(')));
  read_or_refuse(fmt::format("object {}\nmass 1\n", many('a')));
  std::string chain;
  for (int k = 0; k < 1000; ++k) chain += fmt::format("n.a{} = n.a{}\n", k, k + 1);
  read_or_refuse(chain + "n.a1000 = 1\nobject ball\nmass n.a0\ntime\nend 1\nstep 1\n");
}

}  // namespace
}  // namespace animado::controle
