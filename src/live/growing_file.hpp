// A file that another process writes: what came to it since the last look, in whole lines.
#pragma once

#include <filesystem>
#include <string>

namespace animado::live {

class GrowingFile {
 public:
  explicit GrowingFile(std::filesystem::path path) : path_(std::move(path)) {}

  const std::filesystem::path& path() const { return path_; }

  // The lines that are new, each with its end; empty when there are none, or no file yet.
  std::string take_lines();

 private:
  std::filesystem::path path_;
  int64_t read_ = 0;  // bytes
};

}  // namespace animado::live
