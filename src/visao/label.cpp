#include "visao/label.hpp"

#include <cmath>

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_truetype.h>
#pragma GCC diagnostic pop

// The font's file, as it is, in the program's constants.
asm(".section .rodata\n"
    ".global animado_visao_font\n"
    "animado_visao_font: .incbin \"" ANIMADO_FONT
    "\"\n"
    ".previous\n");
extern "C" const unsigned char animado_visao_font[];

namespace animado::visao {

namespace {

const stbtt_fontinfo& font() {
  static const stbtt_fontinfo loaded = [] {
    stbtt_fontinfo info;
    stbtt_InitFont(&info, animado_visao_font, 0);
    return info;
  }();
  return loaded;
}

// The next character, taken off the front. A byte that is no UTF-8 is taken for itself.
int next_character(std::string_view& utf8) {
  const auto first = static_cast<unsigned char>(utf8[0]);
  const size_t length = first < 0xC0 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  if (length == 1 || utf8.size() < length) {
    utf8.remove_prefix(1);
    return first;
  }
  int character = first & (0xFF >> (length + 1));
  for (size_t k = 1; k < length; ++k) character = character << 6 | (utf8[k] & 0x3F);
  utf8.remove_prefix(length);
  return character;
}

// Calls place(glyph, x) with each letter and where it starts, px; returns where the last one ends.
template <class Place>
double set_letters(std::string_view utf8, float scale, const Place& place) {
  double x = 0;
  int before = 0;
  while (!utf8.empty()) {
    const int glyph = stbtt_FindGlyphIndex(&font(), next_character(utf8));
    if (glyph == 0) continue;
    if (before != 0) x += scale * static_cast<float>(stbtt_GetGlyphKernAdvance(&font(), before, glyph));
    place(glyph, x);
    int advance = 0, bearing = 0;
    stbtt_GetGlyphHMetrics(&font(), glyph, &advance, &bearing);
    x += scale * static_cast<float>(advance);
    before = glyph;
  }
  return x;
}

float scale_of(double size_px) {
  return stbtt_ScaleForMappingEmToPixels(&font(), static_cast<float>(size_px));
}

}  // namespace

void write_label(Picture& picture, int x, int y, std::string_view utf8, double size_px, Srgb8 ink) {
  const float scale = scale_of(size_px);
  set_letters(utf8, scale, [&](int glyph, double at_px) {
    const auto whole = static_cast<int>(std::floor(at_px));
    int width = 0, height = 0, left = 0, top = 0;
    unsigned char* const shape = stbtt_GetGlyphBitmapSubpixel(
        &font(), scale, scale, static_cast<float>(at_px - whole), 0, glyph, &width, &height, &left, &top);
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        const float coverage = static_cast<float>(shape[v * width + u]) / 255;
        picture.cover(x + whole + left + u, y + top + v, ink, coverage);
      }
    }
    stbtt_FreeBitmap(shape, nullptr);
  });
}

int label_width_px(std::string_view utf8, double size_px) {
  return static_cast<int>(std::ceil(set_letters(utf8, scale_of(size_px), [](int, double) {})));
}

}  // namespace animado::visao
