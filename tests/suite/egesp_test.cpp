// EGESP as its users meet it: the examples of docs/egesp.md, `animado solve`, and handles over a socket.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "blocks.hpp"
#include "command.hpp"
#include "egesp/client.hpp"
#include "services.hpp"

namespace animado::suite {
namespace {

namespace fs = std::filesystem;
using testing::EndsWith;
using testing::HasSubstr;

const fs::path kDocs = ANIMADO_SOURCE_DIR "/docs";

constexpr auto kMatrix = "%%MatrixMarket matrix array real general\n2 2\n2\n1\n1\n3\n";  // (2 1; 1 3)
constexpr auto kSide = "%%MatrixMarket matrix array real general\n2 1\n4\n7\n";          // x = (1, 2)

class Solve : public testing::Test {
 protected:
  std::string file(const std::string& name, const std::string& text) {
    return write_text(directory_ / name, text);
  }
  // Away from whatever suite this machine runs.
  Outcome solve(Words more, const std::string& matrix = kMatrix, const std::string& side = kSide) {
    Words words = {"-c",
                   "ANIMADO_SOCKET_DIR=\"$0\" exec \"$@\"",
                   directory_ / "none",
                   kAnimado,
                   "solve",
                   file("A.mtx", matrix),
                   file("b.mtx", side)};
    words.insert(words.end(), more.begin(), more.end());
    return Command(directory_, words, "/bin/sh").finish();
  }
  TemporaryDirectory directory_;
};

TEST_F(Solve, WithoutASuiteIsDoneInTheCommandItself) {
  const Outcome outcome = solve({});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "1\n2\n");
  EXPECT_EQ(outcome.err, "");
}

TEST_F(Solve, TellsWhatItIsAskedOnStderr) {
  const Outcome outcome = solve({"--refine", "--condition", "--pivoting", "complete"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("backward error "));
  EXPECT_THAT(outcome.err, HasSubstr("reciprocal condition 0.31"));
}

TEST_F(Solve, WritesAFileThatItReads) {
  const std::string x = directory_ / "x.mtx";
  EXPECT_EQ(solve({"--method", "sparse", "-o", x}).code, 2) << "an array file has no coordinates";
  EXPECT_EQ(solve({"-o", x}).out, "");
  EXPECT_EQ(text_of(x), "%%MatrixMarket matrix array real general\n2 1\n1\n2\n");
}

TEST_F(Solve, RefusesWithFileAndLine) {
  Outcome outcome = solve({}, "%%MatrixMarket matrix array real general\n2 2\n2\n1\nx\n");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("A.mtx:5: `x` is no number"));
  outcome = solve({}, kMatrix, "%%MatrixMarket matrix array real general\n1 1\n2\n");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("b.mtx: 1 rows, and 2 in"));
  outcome = solve({}, "%%MatrixMarket matrix array real general\n2 2\n1\n2\n2\n4\n");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("singular"));
  outcome = solve({"--run", "nowhere"});
  EXPECT_EQ(outcome.code, 5);
}

TEST_F(Solve, OfAMatrixThatIsNotSquareNeedsLeastSquares) {
  constexpr auto kWide = "%%MatrixMarket matrix array real general\n2 3\n1\n0\n1\n0\n0\n1\n";
  Outcome outcome = solve({}, kWide);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--least-squares"));
  outcome = solve({"--least-squares", "--minimum-norm"}, kWide);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("rank 2, null space of dimension 1, residual norm"));
}

// Large enough for its numbers to be shared: a tridiagonal system of 30,000 unknowns whose solution is 1, 1,
// …
TEST_F(Solve, SharesLargeArraysWithTheSuiteThatRuns) {
  constexpr int n = 30000;
  std::string a = fmt::format("%%MatrixMarket matrix coordinate real symmetric\n{} {} {}\n", n, n, 2 * n - 1);
  std::string b = fmt::format("%%MatrixMarket matrix array real general\n{} 3\n", n);
  for (int i = 1; i <= n; ++i)
    a += i < n ? fmt::format("{0} {0} 4\n{1} {0} 1\n", i, i + 1) : fmt::format("{0} {0} 4\n", i);
  for (int i = 0; i < 3 * n; ++i) b += i % n == 0 || i % n == n - 1 ? "5\n" : "6\n";
  Services services;
  const std::string x = directory_ / "x.mtx";
  const Outcome outcome = animado({"solve", file("A.mtx", a), file("b.mtx", b), "-o", x, "--residual",
                                   "--socket-dir", services.directory()});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("backward error"));
  EXPECT_THAT(text_of(x), testing::StartsWith("%%MatrixMarket matrix array real general\n30000 3\n"));
  EXPECT_THAT(text_of(x), EndsWith("\n1\n"));
}

// A handle is of the connection that asked for it, and a new connection does not know it.
TEST(Handles, EndWithTheirConnectionOverASocketToo) {
  Services services;
  const auto prepare = [&](rpc::SocketSuite& suite) {
    egesp::SparsePrepare::Request request;
    request.matrix.size = 1;
    request.matrix.rows = request.matrix.columns = rpc::Array::inlined({1}, {0});
    request.matrix.values = rpc::Array::inlined({1}, {2});
    return egesp::Client(suite.channel("egesp")).sparse_prepare(request).handle;
  };
  const auto solve_with = [](rpc::SocketSuite& suite, int64_t handle) {
    egesp::SparseSolvePrepared::Request request;
    request.handle = handle;
    request.right_sides = rpc::Array::inlined({1}, {6});
    return egesp::Client(suite.channel("egesp")).sparse_solve_prepared(request).solutions.values.at(0);
  };
  rpc::SocketSuite other({.directory = services.directory(), .client = "other"});
  const int64_t handle = prepare(services.suite());
  EXPECT_EQ(solve_with(services.suite(), handle), 3);
  EXPECT_THROW(solve_with(other, handle), Error);
  EXPECT_NE(prepare(other), handle);
}

TEST(Handles, PreparedSystemsOutliveTheServer) {
  Services services;
  egesp::Prepare::Request matrices;
  matrices.matrices = rpc::Array::inlined({2, 2}, {2, 0, 0, 4});
  egesp::PreparedSystems systems(services.suite().channel("egesp"), matrices);
  egesp::SolvePrepared::Request request;
  request.right_sides = rpc::Array::inlined({2}, {6, 8});
  EXPECT_THAT(systems.solve(request).solutions.values, testing::ElementsAre(3, 2));
  services.restart("egesp", SIGKILL);
  EXPECT_THAT(systems.solve(request).solutions.values, testing::ElementsAre(3, 2));
}

TEST(EgespPage, ShowsTheShellExampleAndWhatItPrints) {
  const auto shown = blocks(kDocs / "egesp.md", "sh"), printed = blocks(kDocs / "egesp.md", "text");
  ASSERT_EQ(shown.size(), 2u);
  ASSERT_EQ(printed.size(), 1u);
  EXPECT_EQ(shown[0], text_of(kDocs / "examples/solve.sh"));
  const TemporaryDirectory directory;
  const Words words = {"-c", "ANIMADO_SOCKET_DIR=\"$PWD/none\" PATH=\"$0:$PATH\" exec \"$1\"",
                       kAnimado.parent_path(), kDocs / "examples/solve.sh"};
  const Outcome outcome = Command(directory, words, "/bin/sh").finish();
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, printed[0]);
  EXPECT_THAT(outcome.err, HasSubstr("rank 2, null space of dimension 0, residual norm"));
}

TEST(EgespPage, ItsCallAnswers) {
  Services services;
  const TemporaryDirectory directory;
  const Words words = {
      "-c", "PATH=\"$0:$PATH\"; export ANIMADO_SOCKET_DIR=\"$1\"; " + blocks(kDocs / "egesp.md", "sh").at(1),
      kAnimado.parent_path(), services.directory()};
  const Outcome outcome = Command(directory, words, "/bin/sh").finish();
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto reply = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(reply.at("null_space"), 1);
  EXPECT_NEAR(reply.at("solutions").at("data").at(1), 2, 1e-15);
}

TEST(EgespPage, TheExampleInPythonKeepsTheHeat) {
  Services services;
  const TemporaryDirectory directory;
  const Words words = {kDocs / "examples/heat.py", services.socket("interexpserv")};
  const Outcome outcome = Command(directory, words, "/usr/bin/python3").finish();
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "total 1.000000, at the middle 0.091559\n");
}

}  // namespace
}  // namespace animado::suite
