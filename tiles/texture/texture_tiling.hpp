// Which tile of a texture set lies where, and the picture of a window of a tiling.
//
// Complete sets are laid by the hash of place and seed in runtime/texture_tiles.h, anywhere; other sets by scanlines
// from their north-west tile (Cohen and others 2003, section 2; Ng and others 2005, section 4.2).
#pragma once

#include "tiles/texture/texture_set.hpp"
#include "tiles/tilings/tiling.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

namespace poissonlab {

/// A rectangle of tiles by their numbers in the set, rows from north to south.
struct TextureWindow
{
    std::size_t columns = 0;
    std::size_t rows = 0;
    std::vector<std::size_t> tiles;
};

/// The most tiles of a window, and the most pixels along one side of its picture.
inline constexpr std::uint64_t most_window_tiles = std::uint64_t{1} << 24;
inline constexpr std::uint64_t most_window_pixels = 65'500;

/// The tiles of a window. Windows of complete sets with the same seed fit together; others must be at (0, 0). Throws
/// InputError for that, for too many tiles, and for sets whose tiles come to a place where none fits.
TextureWindow texture_window(const TextureSet& set, const TileWindow& window, std::uint64_t seed);

/// True if the lattice point at so many columns and rows from the window's lower left is marked.
using CornerMarks = std::function<bool(std::uint64_t column, std::uint64_t row)>;

/// Marks of a window's lattice points by a picture that covers it: points on its lighter half of all values are marked.
CornerMarks corner_marks(PngPixels picture, std::uint64_t columns, std::uint64_t rows);

/// Lays a window of a set with two classes of corners. Sets of corner tiles must be complete: a corner's class follows
/// from its mark, its colour within the class from the hash. Sets of Wang tiles must have all marks, and are laid by
/// scanlines from (0, 0). Throws InputError for other sets and windows.
TextureWindow marked_texture_window(const TextureSet& set, const TileWindow& window, std::uint64_t seed,
                                    const CornerMarks& is_marked);

/// The window's picture, of a value a channel of each pixel of a tile: `values` are laid out as those of the set.
PngPixels texture_window_pixels(const TextureSet& set, const TextureWindow& window,
                                std::span<const std::uint8_t> values, int channels);

/// Writes the window's picture as PNG. Throws InputError for more than most_window_pixels along a side, StorageError,
/// Interrupted.
void write_texture_window(const std::filesystem::path& file, const TextureSet& set, const TextureWindow& window);

}
