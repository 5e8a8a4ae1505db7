#include "visao/picture.hpp"

#include <png.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/error.hpp"
#include "controle/results/output_file.hpp"

namespace animado::visao {

static_assert(sizeof(Srgb8) == 3, "a row of pixels is a row of bytes");

Picture::Picture(Size size, Srgb8 fill)
    : size_(size), pixels_(static_cast<size_t>(size.width_px) * static_cast<size_t>(size.height_px), fill) {
  assert(size.width_px > 0 && size.height_px > 0);
}

void Picture::cover(int x, int y, Srgb8 color, float coverage) {
  if (!holds(x, y)) return;
  const float part = std::clamp(coverage, 0.0f, 1.0f);
  const auto mix = [&](uint8_t& below, uint8_t above) {
    below = static_cast<uint8_t>(std::lround(static_cast<float>(below) * (1 - part) + above * part));
  };
  Srgb8& pixel = at(x, y);
  mix(pixel.red, color.red);
  mix(pixel.green, color.green);
  mix(pixel.blue, color.blue);
}

void Picture::paste(const Picture& other, int left, int top) {
  assert(holds(left, top) && holds(left + other.size_.width_px - 1, top + other.size_.height_px - 1));
  for (int y = 0; y < other.size_.height_px; ++y) {
    std::copy_n(&other.at(0, y), other.size_.width_px, &at(left, top + y));
  }
}

void write_png(const std::filesystem::path& file, const Picture& picture) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.size().width_px);
  image.height = static_cast<png_uint_32>(picture.size().height_px);
  image.format = PNG_FORMAT_RGB;
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, picture.bytes(), 0, nullptr) == 0) {
    throw Error(Code::internal, std::string("the picture could not be encoded: ") + image.message,
                file.string());
  }
  bytes.resize(size);
  controle::write_whole(file, bytes);
}

Picture read_png(const std::filesystem::path& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  const auto fail = [&] {
    throw Error(Code::unavailable, std::string("the picture cannot be read: ") + image.message,
                file.string());
  };
  if (png_image_begin_read_from_file(&image, file.c_str()) == 0) fail();
  image.format = PNG_FORMAT_RGB;
  Picture picture({static_cast<int>(image.width), static_cast<int>(image.height)}, {});
  if (png_image_finish_read(&image, nullptr, &picture.at(0, 0), 0, nullptr) == 0) fail();
  return picture;
}

}  // namespace animado::visao
