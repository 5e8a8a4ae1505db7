// Commands as a user types them.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "tests/temporary_directory.hpp"

namespace animado::visao {

inline const std::string kPrograms = ANIMADO_BIN_DIR "/", kScenes = ANIMADO_SOURCE_DIR "/scenes/";

struct Outcome {
  int code;
  std::string out, err;
};

inline Outcome shell(const std::string& command) {
  const TemporaryDirectory said;
  const std::string out = said / "out", err = said / "err";
  const int status = std::system(("{ " + command + "; } > '" + out + "' 2> '" + err + "'").c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(out), text_of(err)};
}

inline Outcome simulate(const std::string& scene, const std::filesystem::path& results) {
  return shell(kPrograms + "animado run '" + kScenes + scene +
               ".animado' --in-process --no-pictures --quiet --out '" + results.string() + "'");
}

}  // namespace animado::visao
