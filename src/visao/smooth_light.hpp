// Takes the noise out of light: a pixel that shows one surface only is lit by the mean over its neighbours on
// the same surface, 4 x 4 of them, whose samples complete each other (samples.hpp). Edges and patterns stay
// sharp.
#pragma once

#include <span>
#include <vector>

#include "visao/picture.hpp"
#include "visao/shade.hpp"

namespace animado::visao {

struct Texel {
  int surface = Seen::kNothing;  // the only one that its rays met; kNothing when they met several
  Vec3f normal = Vec3f::Zero(), albedo = Vec3f::Zero(), light = Vec3f::Zero(), added = Vec3f::Zero();
  Vec3f color = kBackground;  // as its own rays have it
};

class Canvas {
 public:
  explicit Canvas(Size size)
      : size_(size), texels_(static_cast<size_t>(size.width_px) * static_cast<size_t>(size.height_px)) {}

  Size size() const { return size_; }
  Texel& at(int x, int y) { return texels_[index(x, y)]; }
  const Texel& at(int x, int y) const { return texels_[index(x, y)]; }

 private:
  size_t index(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(size_.width_px) + static_cast<size_t>(x);
  }

  Size size_;
  std::vector<Texel> texels_;
};

Texel texel_of(std::span<const Seen> seen);  // the rays of one pixel
Vec3f smooth_color(const Canvas& canvas, int x, int y);

}  // namespace animado::visao
