// scripts/check-layers: it must see each kind of arrow that points the wrong way. (ctest's `layers` runs it
// on the real tree.)
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tests/temporary_directory.hpp"

namespace {

namespace fs = std::filesystem;
using Row = std::array<std::string, 3>;  // file, what it includes, why that is refused

class CheckLayers : public testing::TestWithParam<Row> {
 protected:
  // The script's exit code for a tree with one file that has one #include.
  int check(const std::string& file, const std::string& include) {
    const fs::path path = root_ / "src" / file;
    fs::create_directories(path.parent_path());
    std::ofstream(path) << "#include " << include << "\n";
    const std::string command = std::string(ANIMADO_SOURCE_DIR "/scripts/check-layers ") +
                                root_.path().string() + " > " + (root_ / "said").string();
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string said() const {
    std::ifstream file(root_ / "said");
    return {std::istreambuf_iterator<char>(file), {}};
  }

  animado::TemporaryDirectory root_;
};

using Offence = CheckLayers;
TEST_P(Offence, IsNamedWithItsLine) {
  const auto& [file, include, reason] = GetParam();
  EXPECT_EQ(check(file, include), 1);
  EXPECT_THAT(said(), testing::StartsWith("src/" + file + ":1: "));
  EXPECT_THAT(said(), testing::HasSubstr(reason));
}
INSTANTIATE_TEST_SUITE_P(
    Each, Offence,
    testing::Values(
        Row{"base/error.cpp", "\"rpc/channel.hpp\"", "base includes nothing"},
        Row{"egesp/gauss_jordan.cpp", "\"rpc/service.hpp\"", "only server.cpp joins"},
        Row{"egesp/gauss_jordan.cpp", "\"egesp/protocol.hpp\"", "do not know their messages"},
        Row{"egesp/gauss_jordan.cpp", "\"colisao/client.hpp\"", "only server.cpp reaches"},
        Row{"colisao/server.cpp", "\"egesp/gauss_jordan.hpp\"", "reached through egesp/client.hpp"},
        Row{"controle/stepper.cpp", "\"fred/tableau.hpp\"", "controle reaches a service through"},
        Row{"console/terminal.cpp", "\"rpc/log.hpp\"", "console includes base only"},
        Row{"visao/stage.cpp", "\"controle/stepper.hpp\"", "visao knows results only"},
        Row{"animado/run_command.cpp", "\"visao/sheet.hpp\"", "animado reaches a service through"},
        Row{"animado/run_command.cpp", "\"fred/tableau.hpp\"", "animado reaches a service through"},
        Row{"report/page.cpp", "\"controle/run.hpp\"", "report reads results"},
        Row{"fred/server.cpp", "\"controle/run.hpp\"", "a service does not know controle"},
        Row{"rpc/daemon.cpp", "\"egesp/protocol.hpp\"", "rpc includes base and console only"},
        Row{"fred/server.cpp", "<sys/socket.h>", "src/rpc's"},
        Row{"egesp/gauss_jordan.cpp", "<sys/mman.h>", "src/rpc's"},
        Row{"egesp/large_blocks.cpp", "<sys/socket.h>", "src/rpc's"},
        Row{"fred/tableau.cpp", "\"tableau.hpp\"", "the name of a room"}));

using Arrow = CheckLayers;
TEST_P(Arrow, IsAllowed) {
  EXPECT_EQ(check(GetParam()[0], GetParam()[1]), 0) << said();
}
INSTANTIATE_TEST_SUITE_P(Each, Arrow,
                         testing::Values(Row{"egesp/gauss_jordan.cpp", "\"base/error.hpp\""},
                                         Row{"egesp/server.cpp", "\"egesp/gauss_jordan.hpp\""},
                                         Row{"egesp/server.cpp", "\"rpc/service.hpp\""},
                                         Row{"colisao/server.cpp", "\"egesp/client.hpp\""},
                                         Row{"fred/expressions.cpp", "\"interexpserv/program.hpp\""},
                                         Row{"controle/scene.cpp", "\"interexpserv/parser.hpp\""},
                                         Row{"controle/stepper.cpp", "\"colisao/client.hpp\""},
                                         Row{"animado/in_process.cpp", "\"egesp/server.hpp\""},
                                         Row{"egesp/large_blocks.cpp", "<sys/mman.h>"},
                                         Row{"rpc/daemon.cpp", "<sys/socket.h>"}));

TEST_F(CheckLayers, RefusesATreeWithoutSources) {
  fs::create_directories(root_ / "src");
  const std::string command =
      std::string(ANIMADO_SOURCE_DIR "/scripts/check-layers ") + root_.path().string() + " > /dev/null";
  EXPECT_NE(std::system(command.c_str()), 0);
}

}  // namespace
