// What a user may ask of visao.
#pragma once

#include <filesystem>
#include <string>

namespace animado::visao {

struct Options {
  std::filesystem::path directory, output;
  std::string camera = "three-quarter", look_at, size, frames;
  bool mp4 = false, quiet = false;
};

// Makes what is asked for; the exit code. Throws Error.
int render(const Options& options);

}  // namespace animado::visao
