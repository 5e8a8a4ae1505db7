#include "visao/draw.hpp"

#include <algorithm>

#include "visao/shade.hpp"
#include "visao/smooth_light.hpp"
#include "visao/threads.hpp"

namespace animado::visao {

namespace {

// A bundle of rays covers one pixel with sixteen of them, or 2 x 2 pixels with four each.
struct Blocks {
  int side_px, rays_a_pixel;

  explicit Blocks(Quality quality)
      : side_px(quality == Quality::still ? 1 : 2), rays_a_pixel(static_cast<int>(quality)) {}
  int x_of(int ray) const { return ray / rays_a_pixel % side_px; }
  int y_of(int ray) const { return ray / rays_a_pixel / side_px; }
  uint32_t sample_of(int ray) const { return static_cast<uint32_t>(ray % rays_a_pixel); }
};

struct Area {  // of a picture, px: left and top belong to it, right and bottom do not
  int left, top, right, bottom;
};

// Where bodies are seen. Elsewhere is the background, for which no ray is needed; but a floor is everywhere.
Area busy_area(const Stage& stage, std::span<const Pose> poses, const Camera& camera, Size size) {
  const Area whole{0, 0, size.width_px, size.height_px};
  if (!stage.planes.empty()) return whole;
  Eigen::AlignedBox2d seen;
  for (const StagedBody& body : stage.bodies) {
    const Vec3 center = camera.axes.transpose() * (poses[body.index].position_m - camera.eye_m);
    const double r = body.radius_m, near_m = -center.z() - r, far_m = -center.z() + r;
    if (near_m <= 0) return whole;
    for (const double depth_m : {near_m, far_m}) {
      for (const double aside_m : {-r, r}) {
        seen.extend(Eigen::Vector2d((center.x() + aside_m) / (depth_m * camera.half_width),
                                    (center.y() + aside_m) / (depth_m * camera.half_height)));
      }
    }
  }
  if (seen.isEmpty()) return {0, 0, 0, 0};
  // Even numbers: a bundle of a film begins at one.
  const auto pixel = [](double position, int pixels, int beyond) {
    const double at = std::clamp(position, 0.0, 1.0) * pixels;
    return std::clamp((static_cast<int>(at) + beyond) & ~1, 0, pixels);
  };
  return {
      pixel((seen.min().x() + 1) / 2, size.width_px, -1), pixel((1 - seen.max().y()) / 2, size.height_px, -1),
      pixel((seen.max().x() + 1) / 2, size.width_px, 3), pixel((1 - seen.min().y()) / 2, size.height_px, 3)};
}

class Painter {
 public:
  Painter(const Stage& stage, const Solids& solids, const Camera& camera, Size size, Quality quality)
      : shader_(stage, solids, camera),
        size_(size),
        blocks_(quality),
        corner_(camera.direction(-1, 1).cast<float>()),
        step_right_(((camera.direction(1, 1) - camera.direction(-1, 1)) / size.width_px).cast<float>()),
        step_down_(((camera.direction(-1, -1) - camera.direction(-1, 1)) / size.height_px).cast<float>()) {
    for (uint32_t k = 0; k < kRays; ++k) in_pixel_[k] = sequence_point(k);
  }

  void paint(const Area& area, Canvas& canvas) const {
    const int side_px = blocks_.side_px;
    for_each_row((area.bottom - area.top + side_px - 1) / side_px, [&](int row) {
      for (int x = area.left; x < area.right; x += side_px) {
        paint_block(x, area.top + row * side_px, canvas);
      }
    });
  }

 private:
  void paint_block(int left, int top, Canvas& canvas) const {
    Bundle directions;
    SampleIndices samples;
    const auto a_pixel = static_cast<uint32_t>(blocks_.rays_a_pixel);
    for (int ray = 0; ray < kRays; ++ray) {
      const int x = left + blocks_.x_of(ray), y = top + blocks_.y_of(ray);
      const uint32_t sample = blocks_.sample_of(ray), block = block_of_pixel(x, y);
      const auto i = static_cast<size_t>(ray);
      const SquarePoint& in_pixel = in_pixel_[sample];
      const float across_px = static_cast<float>(x) + in_pixel.x,
                  down_px = static_cast<float>(y) + in_pixel.y;
      directions[i] = (corner_ + across_px * step_right_ + down_px * step_down_).normalized();
      // Within its block a pixel takes the points in an order of its own: where in the pixel a ray starts
      // tells nothing of where it looks for light.
      samples[i] = block * a_pixel + ((5 * sample + 3 * block) & (a_pixel - 1));
    }
    const auto seen = shader_.see(directions, samples);
    for (int first = 0; first < kRays; first += blocks_.rays_a_pixel) {
      const int x = left + blocks_.x_of(first), y = top + blocks_.y_of(first);
      if (x < size_.width_px && y < size_.height_px) {
        canvas.at(x, y) = texel_of(std::span(seen).subspan(static_cast<size_t>(first), a_pixel));
      }
    }
  }

  Shader shader_;
  Size size_;
  Blocks blocks_;
  Vec3f corner_, step_right_, step_down_;  // directions: to the picture's corner, and on by a pixel
  std::array<SquarePoint, kRays> in_pixel_;
};

}  // namespace

Picture draw(const Stage& stage, std::span<const Pose> poses, const Camera& camera, Size size,
             Quality quality) {
  const Solids solids(stage, poses);
  const Painter painter(stage, solids, camera, size, quality);
  Canvas canvas(size);
  painter.paint(busy_area(stage, poses, camera, size), canvas);
  Picture picture(size, {});
  for_each_row(size.height_px, [&](int y) {
    for (int x = 0; x < size.width_px; ++x) picture.at(x, y) = srgb8_of(smooth_color(canvas, x, y));
  });
  return picture;
}

}  // namespace animado::visao
