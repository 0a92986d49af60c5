// Painting on pictures of texture tiles, pixel by pixel.
#pragma once

#include "base/images/png_file.hpp"
#include "tiles/texture/texture_set.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace poissonlab::painting {

using Rgb = std::array<std::uint8_t, 3>;

/// Colours that eyes tell apart; the first ones are those of the papers' drawings.
inline constexpr std::array<Rgb, 12> tints{{{220, 50, 47},
                                            {60, 160, 60},
                                            {60, 90, 210},
                                            {230, 180, 30},
                                            {160, 70, 190},
                                            {40, 170, 180},
                                            {235, 120, 40},
                                            {140, 140, 40},
                                            {230, 110, 170},
                                            {120, 90, 60},
                                            {90, 200, 140},
                                            {110, 110, 160}}};

/// The number of times that tiles are shown larger than they are, and the pixels between them before.
inline constexpr int shown_zoom = 2, shown_gap = 16;

/// A white picture.
PngPixels blank(int width, int height);

/// Sets a pixel of three channels, unless it lies outside.
void put(PngPixels& picture, int x, int y, Rgb color);

Rgb color_at(const PngPixels& picture, int x, int y);

/// Puts a picture into another one of three channels, its upper left corner at (left, top).
void put_picture(PngPixels& picture, const PngPixels& other, int left, int top);

/// Gives a picture three channels.
PngPixels colored(const PngPixels& pixels);

/// The mean of a colour and a tint.
Rgb tinted(Rgb color, Rgb tint);

/// Every pixel `factor` times along both axes.
PngPixels enlarged(const PngPixels& pixels, int factor);

/// A tile as it is, by its number in the set.
PngPixels tile_picture(const TextureSet& set, std::size_t tile);

}
