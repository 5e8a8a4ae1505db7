// What README.md and docs/ say is so.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "blocks.hpp"
#include "command.hpp"
#include "services.hpp"

namespace animado::suite {
namespace {

namespace fs = std::filesystem;

TEST(Readme, ShowsTheExampleInPythonAsItIs) {
  const auto shown = blocks(kSource / "README.md", "python");
  ASSERT_EQ(shown.size(), 1u);
  EXPECT_EQ(shown[0], text_of(kSource / "docs/examples/solve.py"));
}

TEST(Readme, TheExampleInPythonSolvesItsEquations) {
  Services services;
  const TemporaryDirectory directory;
  const Words words = {kSource / "docs/examples/solve.py", services.socket("interexpserv")};
  // Debian's own: it has python3-msgpack.
  const Outcome outcome = Command(directory, words, "/usr/bin/python3").finish();
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "x = 0.8, y = 1.4\n");
}

TEST(Readme, TheCallOnTheCommandLineDoesTheSame) {
  Services services;
  const Outcome outcome = animado(
      {"call", "egesp", "solve", "--socket-dir", services.directory(),
       R"({"matrices": {"shape": [2, 2], "data": [2, 1, 1, 3]}, "right_sides": {"shape": [2], "data": [3, 5]}})"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto solutions = nlohmann::json::parse(outcome.out).at("solutions");
  EXPECT_EQ(solutions.at("shape"), (std::vector<int>{2}));
  EXPECT_NEAR(solutions.at("data").at(0), 0.8, 1e-15);
  EXPECT_NEAR(solutions.at("data").at(1), 1.4, 1e-15);
}

TEST(Examples, TheRegistryFromPython) {
  Services services;
  const TemporaryDirectory directory;
  const Words words = {kSource / "docs/examples/registry.py", services.socket("interexpserv")};
  const Outcome outcome = Command(directory, words, "/usr/bin/python3").finish();
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "changed spring.k 6.0 version 1\n"
            "changed spring.k 12.0 version 2\n"
            "conflict: `spring.k` has version 2, last changed by registry.py; 1 was expected (get it, and "
            "decide again)\n");
}

TEST(Examples, TheRegistryFromTheShell) {
  Services services;
  const TemporaryDirectory directory;
  const std::string path = fmt::format("PATH={}:{}", kAnimado.parent_path().string(), getenv("PATH"));
  const Words words = {path, kSource / "docs/examples/registry.sh", "--socket-dir", services.directory()};
  const Outcome outcome = Command(directory, words, "/usr/bin/env").finish();
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::StartsWith("12\nsomebody was faster\n6\n{\"revisions\":["));
}

// The page's commands, in its order, at a suite that runs; top is looked at once.
TEST(Examples, ThePageOfTheRegistry) {
  Services services;
  const auto shown = blocks(kSource / "docs/registry.md", "sh");
  ASSERT_EQ(shown.size(), 2u);
  std::string script = "set -e\nanimado() { command=$1; shift; " + kAnimado.string() +
                       " \"$command\" \"$@\" --socket-dir " + services.directory().string() + "; }\n" +
                       shown[0];
  const auto replace = [&](const std::string& what, const std::string& by) {
    ASSERT_NE(script.find(what), std::string::npos) << what;
    script.replace(script.find(what), what.size(), by);
  };
  replace("animado watch 'ball.*'", "animado watch 'ball.*' --count 1");
  replace("animado top", "animado top --once --every 0.02");
  const TemporaryDirectory directory;
  const Outcome outcome = Command(directory, {"-c", script}, "/bin/sh").finish();
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::StartsWith("78.95683520871486\n"));
}

TEST(Readme, ItsSceneIsOne) {
  const auto scenes = blocks(kSource / "README.md", "animado");
  ASSERT_EQ(scenes.size(), 1u);
  const TemporaryDirectory directory;
  const Outcome outcome = animado({"check", write_text(directory / "scene.animado", scenes[0])});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
}

TEST(Protocol, ThePageIsTheListOfMessages) {
  const Outcome outcome = animado({"protocol"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, text_of(kSource / "docs/protocol.md")) << "animado protocol > docs/protocol.md";
}

TEST(Processos, ListsTheScenesWhenItIsNotTold) {
  const TemporaryDirectory directory;
  const Outcome outcome = Command(directory, {}, kSource / "scripts/processos").finish();
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, testing::HasSubstr("scenes/colisao.animado"));
}

}  // namespace
}  // namespace animado::suite
