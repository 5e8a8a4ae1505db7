#include "visao/film.hpp"

#include <cmath>

#include "visao/draw.hpp"
#include "visao/encoder.hpp"
#include "visao/label.hpp"
#include "visao/marks.hpp"
#include "visao/moments.hpp"

namespace animado::visao {

namespace {

constexpr int kPicturesPerSecond = 30;
constexpr double kMarkLasts_s = 0.15;  // what is shorter nobody sees

}  // namespace

bool film(const controle::RecordedRun& run, const FilmRequest& request) {
  Encoder encoder(request.file, request.size, kPicturesPerSecond);
  const Stage stage = staged(run);
  const Size size = request.size;
  const Camera camera = camera_of(request.view, stage, static_cast<double>(size.width_px) / size.height_px);
  const double text_px = size.height_px / 32.0;
  // A run of 2 s has 61 pictures: its first moment and its last are both there.
  const auto all =
      1 + std::llround(std::floor((request.end_s - request.begin_s) * kPicturesPerSecond + 1e-6));
  for (int64_t k = 0; k < all; ++k) {
    if (request.stop()) return false;
    const double time_s = request.begin_s + static_cast<double>(k) / kPicturesPerSecond;
    Picture picture = draw(stage, poses_at(run, time_s), camera, size, Quality::film);
    mark(picture, camera, impact_points(run, time_s - kMarkLasts_s, time_s));
    write_label(picture, static_cast<int>(text_px), size.height_px - static_cast<int>(text_px),
                fmt::format("t = {:.2f} s", time_s), text_px, kInk);
    encoder.add(picture);
    request.on_picture(k + 1, all);
  }
  if (request.stop()) return false;
  encoder.finish();
  return true;
}

}  // namespace animado::visao
