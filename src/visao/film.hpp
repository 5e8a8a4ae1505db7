// The motion at its own speed, as a film.
#pragma once

#include <filesystem>
#include <functional>

#include "controle/results/recorded_run.hpp"
#include "visao/picture.hpp"
#include "visao/view.hpp"

namespace animado::visao {

struct FilmRequest {
  std::filesystem::path file;
  double begin_s, end_s;  // of the run's time
  View view = {};
  Size size = {1280, 720};
  std::function<void(int64_t done, int64_t all)> on_picture = [](int64_t, int64_t) {};
  std::function<bool()> stop = [] { return false; };
};

// False when it was stopped: then there is no film.
bool film(const controle::RecordedRun& run, const FilmRequest& request);

}  // namespace animado::visao
