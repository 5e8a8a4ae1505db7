#include "command.hpp"

#include <poll.h>

namespace animado::suite {

namespace {

// The shell keeps stdout and stderr apart, and becomes the command.
Words in_shell(const TemporaryDirectory& directory, const Words& arguments,
               const std::filesystem::path& program) {
  Words words = {"/bin/sh", "-c", "cd \"$0\" && exec \"$@\" > stdout 2> stderr", directory.path(), program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

}  // namespace

Command::Command(const TemporaryDirectory& directory, const Words& arguments,
                 const std::filesystem::path& program)
    : directory_(directory), child_(in_shell(directory, arguments, program), directory / "shell") {}

Outcome Command::finish() {
  child_.wait(-1);
  const int code = child_.reap();
  return {code, out(), err()};
}

Outcome animado(const Words& arguments) {
  const TemporaryDirectory directory;
  return Command(directory, arguments).finish();
}

bool wait_until(const std::function<bool()>& condition, const std::function<bool()>& is_over) {
  while (!condition()) {
    if (is_over()) return condition();
    poll(nullptr, 0, 1);  // leaves the processor to what is waited for
  }
  return true;
}

}  // namespace animado::suite
