// `animado` as a user runs it: its exit code, what it printed, and the run it leaves behind.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "animado/child.hpp"
#include "tests/temporary_directory.hpp"

namespace animado::suite {

struct Outcome {
  int code;
  std::string out, err;
};

using Words = std::vector<std::string>;

inline const std::filesystem::path kSource = ANIMADO_SOURCE_DIR;
inline const std::filesystem::path kAnimado = ANIMADO_BIN_DIR "/animado";

// A command that is going on, in a directory of its own. Ended with this object.
class Command {
 public:
  // Runs in `directory`, where its output goes too (stdout, stderr).
  Command(const TemporaryDirectory& directory, const Words& arguments,
          const std::filesystem::path& program = kAnimado);

  pid_t pid() const { return child_.pid(); }
  bool running() const { return !child_.wait(0); }
  void signal(int number) { child_.signal(number); }
  std::string out() const { return text_of(directory_ / "stdout"); }
  std::string err() const { return text_of(directory_ / "stderr"); }
  Outcome finish();  // waits for its end

 private:
  const TemporaryDirectory& directory_;
  Child child_;
};

// The command from its start to its end.
Outcome animado(const Words& arguments);

// Looks again and again until the condition holds. False when `is_over` holds first: what was waited for
// cannot come any more.
bool wait_until(const std::function<bool()>& condition, const std::function<bool()>& is_over);

}  // namespace animado::suite
