#include "visao/smooth_light.hpp"

#include <algorithm>

namespace animado::visao {

Texel texel_of(std::span<const Seen> seen) {
  Texel texel;
  texel.surface = seen[0].surface;
  texel.color.setZero();
  for (const Seen& s : seen) {
    if (s.surface != texel.surface) texel.surface = Seen::kNothing;
    texel.normal += s.normal;
    texel.albedo += s.albedo;
    texel.light += s.light;
    texel.added += s.added;
    texel.color += s.color();
  }
  const float part = 1 / static_cast<float>(seen.size());
  for (Vec3f* sum : {&texel.normal, &texel.albedo, &texel.light, &texel.added, &texel.color}) *sum *= part;
  return texel;
}

Vec3f smooth_color(const Canvas& canvas, int x, int y) {
  const Texel& here = canvas.at(x, y);
  if (here.surface == Seen::kNothing) return here.color;
  constexpr float kSameFace = 0.9f;  // cosine: the faces of a box are lit apart
  Vec3f light = Vec3f::Zero();
  float count = 0;
  const int left = std::clamp(x - 2, 0, std::max(0, canvas.size().width_px - kInterleave));
  const int top = std::clamp(y - 2, 0, std::max(0, canvas.size().height_px - kInterleave));
  for (int v = top; v < std::min(top + kInterleave, canvas.size().height_px); ++v) {
    for (int u = left; u < std::min(left + kInterleave, canvas.size().width_px); ++u) {
      const Texel& near = canvas.at(u, v);
      if (near.surface != here.surface || near.normal.dot(here.normal) < kSameFace) continue;
      light += near.light;
      ++count;
    }
  }
  if (count == 0) return here.color;  // a face so curved that even its own mean normal is short
  return here.added + here.albedo.cwiseProduct(light / count);
}

}  // namespace animado::visao
