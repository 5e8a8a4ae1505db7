#include "animado/pictures.hpp"

#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <vector>

#include "animado/programs.hpp"
#include "console/terminal.hpp"

namespace animado {

namespace {

namespace fs = std::filesystem;

// Runs a program of ours to its end: what it returned, or 128 + the signal that killed it. Unlike a service
// it hears Ctrl-C: a film is given up, the run's results are not. Throws Error(unavailable).
int run_to_end(std::vector<std::string> words) {
  std::vector<char*> raw;
  for (std::string& word : words) raw.push_back(word.data());
  raw.push_back(nullptr);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none, ours;
  sigemptyset(&none);
  sigemptyset(&ours);
  for (const int signal : {SIGINT, SIGTERM}) sigaddset(&ours, signal);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &ours);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  pid_t process = -1;
  const int error = posix_spawn(&process, raw[0], nullptr, &attributes, raw.data(), environ);
  posix_spawnattr_destroy(&attributes);
  if (error != 0) {
    throw Error(Code::unavailable, "cannot start " + words[0] + ": " + std::strerror(error), "",
                "build it (scripts/build release programs), or run with --no-pictures");
  }
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void make(const std::string& file, std::vector<std::string> words, const fs::path& final_results,
          const std::string& option) try {
  const int status = run_to_end(std::move(words));
  if (status == 0) return;
  print_error(Error(Code::unavailable, fmt::format("no {}: visao ended with status {}", file, status), "",
                    fmt::format("the numbers are whole; for the picture: animado render {}{}",
                                fs::proximate(final_results).string(), option)));
} catch (const Error& error) {
  print_error(error);
}

}  // namespace

void make_pictures(const fs::path& results, const fs::path& final_results, const PictureChoice& choice) {
  make("sheet.png", {program("visao"), results, "--quiet"}, final_results, "");
  if (!choice.film) return;
  std::vector<std::string> words = {program("visao"), results, "--mp4", "--output", results / "film.mp4"};
  if (choice.quiet) words.push_back("--quiet");
  make("film.mp4", words, final_results, " --mp4");
}

}  // namespace animado
