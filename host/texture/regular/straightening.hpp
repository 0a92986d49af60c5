// A picture of something regular that was seen at an angle, or whose courses do not fit tiles, becomes one whose
// courses are straight, alike everywhere, and a whole number for each tile.
//
// The slope of the plane is undone; the other numbers of the projective map are chosen so that the regular waves have
// whole numbers of periods over a tile: with one wave by turning and scaling, with two by the linear map that moves
// both.
#pragma once

#include "base/images/raw_picture.hpp"
#include "host/texture/regular/regular_waves.hpp"

#include <array>
#include <string>
#include <vector>

namespace poissonlab {

struct Straightening
{
    int width = 0; ///< of the straightened picture
    int height = 0;
    /// The place in the source, in pixels from the middle of its first one, of the pixel in column x and row y is
    /// (m0 x + m1 y + m2, m3 x + m4 y + m5) / (m6 x + m7 y + m8).
    std::array<double, 9> to_source{};
    std::vector<double> periods; ///< of the regular waves, in pixels of the straightened picture
    double scale = 1;            ///< of lengths in the middle of the picture
};

/// For tiles of T x T pixels. Waves are looked for whose period is six pixels or more. Throws InputError where nothing
/// is regular, or in the picture's middle only, where a period is larger than a tile by half, and where the picture, or
/// what is left of it, is smaller than a tile.
Straightening straightening_for(const PngPixels& exemplar, int size);

/// The pictures, by cubic interpolation (Catmull and Rom) within the range of the sixteen pixels around.
PngPixels straightened(const PngPixels& picture, const Straightening& map);
RawPicture straightened(const RawPicture& picture, const Straightening& map);

/// A line that says what was found and done.
std::string straightening_note(const Straightening& map);

/// A line that says what is regular in a picture and does not fit tiles of T x T pixels, and what would; empty where
/// there is no such thing.
std::string regularity_note(const PngPixels& exemplar, int size);

}
