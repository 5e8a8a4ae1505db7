// Results are written whole or not at all: they grow in the hidden sibling `.NAME.partial-PID`, which becomes
// NAME by one rename. Logs that servers hold open under it keep their files: a rename changes the directory's
// name, not what is in it.
#pragma once

#include <filesystem>

namespace animado::controle {

class ResultsDirectory {
 public:
  // Creates the partial directory with `logs/` in it, parents too, and removes partial directories of NAME
  // whose process is dead. Throws Error(refused) when `final_path` holds something that is not results and
  // would be lost, Error(unavailable) when nothing can be written there.
  explicit ResultsDirectory(const std::filesystem::path& final_path);

  const std::filesystem::path& path() const { return partial_; }  // where to write until commit, absolute
  std::filesystem::path logs() const { return partial_ / "logs"; }
  const std::filesystem::path& final_path() const { return final_; }  // absolute

  // Puts the directory in its place; results that were there are replaced in one step and then deleted. Files
  // must have been closed (OutputFile::close). Without a commit the partial directory stays, to be read after
  // a crash.
  void commit();

 private:
  std::filesystem::path final_, partial_;
};

}  // namespace animado::controle
