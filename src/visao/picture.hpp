// Pixels as a page or a film takes them: rows from the top, eight bits each of red, green and blue, sRGB.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "visao/color.hpp"

namespace animado::visao {

struct Size {
  int width_px, height_px;
};

class Picture {
 public:
  Picture(Size size, Srgb8 fill);

  Size size() const { return size_; }
  Srgb8& at(int x, int y) { return pixels_[index(x, y)]; }
  const Srgb8& at(int x, int y) const { return pixels_[index(x, y)]; }
  bool holds(int x, int y) const { return x >= 0 && y >= 0 && x < size_.width_px && y < size_.height_px; }

  // Colour over what is there; coverage in 0 … 1. What lies outside is left out.
  void cover(int x, int y, Srgb8 color, float coverage);
  void paste(const Picture& other, int left, int top);
  const uint8_t* bytes() const { return &pixels_[0].red; }

 private:
  size_t index(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(size_.width_px) + static_cast<size_t>(x);
  }

  Size size_;
  std::vector<Srgb8> pixels_;
};

// The whole file or none. Throws Error(unavailable).
void write_png(const std::filesystem::path& file, const Picture& picture);
Picture read_png(const std::filesystem::path& file);

}  // namespace animado::visao
