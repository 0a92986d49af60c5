// Sets of texture tiles: square pictures that fit together wherever their colours do, each pixel with its place in the
// picture that they are made of.
//
// D. = Lagae, Tile-Based Methods in Computer Graphics, 2007, section 5.3; Cohen, Shade, Hiller, Deussen, Wang Tiles for
// Image and Texture Generation, 2003; Ng, Wen, Tan, Zhang, Kim, Generating an omega-Tile Set for Texture Synthesis,
// 2005. Rows of pixels go from north to south.
#pragma once

#include "base/images/png_file.hpp"
#include "base/images/raw_picture.hpp"
#include "base/word_table.hpp"
#include "tiles/tilings/tile_set.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace poissonlab {

enum class TextureKind
{
    corner, ///< all tiles by the colours of their corners
    wang,   ///< by the colours of their edges, all or a compact set
    omega,  ///< some tiles by the colours of their corners, laid in scanlines (Ng)
};
inline constexpr WordTable<TextureKind, 3> texture_kinds{
    {{{TextureKind::corner, "corner"}, {TextureKind::wang, "wang"}, {TextureKind::omega, "omega"}}}};

/// A pixel's column and row in the exemplar.
struct SourcePixel
{
    std::uint16_t x = 0;
    std::uint16_t y = 0;

    bool operator==(const SourcePixel&) const = default;
};

/// The colours of a tile, and which of several tiles with the same ones it is.
struct TextureTile
{
    TileIndex index = 0;
    std::uint32_t variant = 0;

    bool operator==(const TextureTile&) const = default;
};

/// A picture that lies over the exemplar, pixel on pixel, such as normals, heights or the exemplar itself with more
/// than 8 bits: tiles show it at the same sources. See companion_maps.hpp.
struct CompanionMap
{
    std::string picture_file, atlas_file; ///< in the set's folder
    bool is_original = false;             ///< it is the exemplar as its file has it
    std::string hash;                     ///< of the picture's samples
    RawPicture picture;                   ///< empty in a set that was read
};

/// A set of T x T tiles.
struct TextureSet
{
    TextureKind kind = TextureKind::corner;
    WangColors colors;
    int size = 64;            ///< T, even
    int ring = 4;             ///< w: so many pixels at its sides depend on the shared colours alone
    int classes = 1;          ///< of corners: 2, unmarked and marked ones, see marked_tiles.hpp
    int marked_column = 0;    ///< of two classes: where the exemplar of marked corners begins; 0: not known
    bool is_smoothed = false; ///< whether pixels inside of the ring differ from their sources
    bool is_blended = false;  ///< whether all pixels may, those of the ring in all tiles alike
    bool is_levelled = false; ///< the same for smooth fields that make tiles equally light
    PngPixels exemplar;       ///< of one or three channels
    std::vector<TextureTile> tiles;
    std::vector<SourcePixel> sources;              ///< T^2 a tile, tile after tile
    std::vector<std::uint8_t> values;              ///< T^2 pixels a tile, the exemplar's channels side by side
    std::map<std::string, std::string> parameters; ///< how it was made, for people
    std::vector<CompanionMap> companions;

    bool has_corners() const { return kind != TextureKind::wang; }
    bool is_changed() const { return is_blended || is_levelled; }
    std::size_t pixels_a_tile() const { return static_cast<std::size_t>(size) * static_cast<std::size_t>(size); }
    std::span<const SourcePixel> sources_of(std::size_t tile) const
    {
        return std::span(sources).subspan(tile * pixels_a_tile(), pixels_a_tile());
    }
    std::span<const std::uint8_t> values_of(std::size_t tile) const
    {
        const std::size_t bytes = pixels_a_tile() * static_cast<std::size_t>(exemplar.channels);
        return std::span(values).subspan(tile * bytes, bytes);
    }

    /// The tile indices that occur, each once.
    TileSet index_set() const;
    /// True if all tiles that the colours allow are there, each once: a direct tiling can be made of them.
    bool is_complete() const;
};

/// The place of a tile in the atlas, in tiles from the north-west: complete sets are closed packings of C^2 x C^2
/// tiles, others lie row by row in a square that is as small as can be.
struct AtlasLayout
{
    int columns = 1;
    int rows = 1;
    std::vector<std::pair<int, int>> places; ///< column and row of each tile
};
AtlasLayout atlas_layout(const TextureSet& set);

/// True for complete sets of corner tiles, and of Wang tiles with the same number of colours along both axes: places in
/// the packing follow from colours, and colours from the hash of runtime/texture_tiles.h.
bool has_places(const TextureSet& set);

/// The pixels of all tiles in their places; black where there is none.
PngPixels atlas_of(const TextureSet& set);

/// The largest side of a tile and of an exemplar; the most bytes of an atlas.
inline constexpr int least_tile_pixels = 16, most_tile_pixels = 512;
inline constexpr int most_exemplar_pixels = 16'384;
inline constexpr std::size_t most_atlas_pixels = std::size_t{1} << 28;

/// Writes atlas.png, sources.png (16 bits: column, row, 0), exemplar.png, two files of each companion, and texture.json
/// into a folder that is made where it is not there; texture.json comes last. Throws StorageError.
void write_texture_set(const std::filesystem::path& folder, const TextureSet& set);

/// Writes the files of write_texture_set(), each to the path that `place` returns for its name.
void write_texture_files(const std::function<std::filesystem::path(const std::string& name)>& place,
                         const TextureSet& set);

/// Reads them again. Throws InputError where a file is missing, damaged or does not fit to the others.
TextureSet read_texture_set(const std::filesystem::path& folder);

}
