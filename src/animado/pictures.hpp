// What a run looks like, put beside its numbers. A picture that fails spoils no run: it is said on stderr,
// with what to do, and that is all.
#pragma once

#include <filesystem>

namespace animado {

struct PictureChoice {
  bool film = false;   // film.mp4 beside sheet.png
  bool quiet = false;  // no progress; failures are still told
};

// results: where the files of the run are now; final_results: where they will be when somebody reads the
// remedy.
void make_pictures(const std::filesystem::path& results, const std::filesystem::path& final_results,
                   const PictureChoice& choice);

}  // namespace animado
