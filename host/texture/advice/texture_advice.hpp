// Advice from a picture: which tiles fit it, and whether it is a texture.
//
// A tile should be wider than what the picture shows, or its pieces break it; the picture should have room for several
// tiles, and look alike everywhere, as any part of it may come to lie beside any other one. Limits were chosen by the
// pictures in docs/texture-tiles.md, which says how often they are right.
#pragma once

#include "base/images/png_file.hpp"
#include "host/texture/texture_request.hpp"

#include <filesystem>
#include <optional>
#include <vector>

namespace poissonlab {

/// TextureObstacle names the reason why a picture should not be tiled.
enum class TextureObstacle
{
    none,
    one_color,
    one_object,   ///< in the middle of a plainer ground
    not_alike,    ///< some parts have much more contrast than others
    other_colors, ///< parts differ in lightness
    too_small,    ///< no room for two tiles along each side
};

struct TextureAdvice
{
    int width = 0; ///< of the picture
    int height = 0;
    TextureObstacle obstacle = TextureObstacle::none;
    /// The side of squares whose means have a quarter of the variance, but for slow light, in pixels. Nothing if half
    /// of the picture has more.
    std::optional<double> scale;
    std::vector<double> periods; ///< of what is regular, in pixels
    double slow_power = 0;       ///< the part of the power that is slower than two tiles
    double contrast_spread = 0;  ///< the standard deviation between parts of the picture of their contrast, in octaves
    double part_variance = 0;    ///< the variance between parts of their lightness, in parts of all variance

    int size = 0; ///< T
    Color colors = 3;
    bool is_wide = false; ///< the scale is larger than a fifth of a tile, of all sizes that the picture has room for
    bool is_straightened = false;
    bool is_flattened = false;
    bool is_joint = false; ///< the set is small enough to be chosen together as well

    bool is_texture() const { return obstacle == TextureObstacle::none; }
};

/// Tiles are at least so many times as wide as the scale of the picture.
inline constexpr double least_tile_scales = 5;

/// Gives the advice for a picture and corner tiles. On any number of threads it is the same. Throws InputError if the
/// picture is smaller than the smallest tile.
TextureAdvice advise_texture(const PngPixels& picture);

/// Reads the picture as exemplars are read. Throws InputError with the name of the file.
TextureAdvice advise_file(const std::filesystem::path& picture);

/// The colours of corner tiles of so many pixels.
Color advised_colors(int size);

/// Sets the numbers of a request that are open to those of the advice, colours by the size that is used, and decides
/// what follows from them.
void take_advice(TextureRequest& request, const TextureAdvice& advice, bool is_size_open, bool are_colors_open);

}
