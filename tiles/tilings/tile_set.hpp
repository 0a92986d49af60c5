// Sets of tiles: the complete ones, the compact ones, and the Wang tile set that a corner tile set is
// equivalent to.
//
// D. = Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 2.7 to 2.10, 3.2 and 3.3.2.2.
#pragma once

#include "base/word_table.hpp"
#include "tiles/tilings/tile_index.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace poissonlab {

enum class TileKind
{
    domino, ///< 1D
    wang,
    corner,
    cube,     ///< 3D corner tile
    wang_cube ///< 3D Wang tile
};
/// The words of the kinds, the usual ones first.
inline constexpr WordTable<TileKind, 5> tile_kinds{{{{TileKind::corner, "corner"},
                                                     {TileKind::wang, "wang"},
                                                     {TileKind::cube, "cube"},
                                                     {TileKind::wang_cube, "wang-cube"},
                                                     {TileKind::domino, "domino"}}}};

/// "Wang tiles" and so on, for sentences.
constexpr const char* tile_kind_words(TileKind kind)
{
    constexpr WordTable<TileKind, 5> words{{{{TileKind::domino, "dominoes"},
                                             {TileKind::wang, "Wang tiles"},
                                             {TileKind::corner, "corner tiles"},
                                             {TileKind::cube, "corner cubes"},
                                             {TileKind::wang_cube, "Wang cubes"}}}};
    return words[kind];
}

/// The axes along which tiles of a kind have neighbours: 1 to 3.
constexpr std::size_t axes_of(TileKind kind)
{
    return kind == TileKind::domino ? 1 : kind == TileKind::cube || kind == TileKind::wang_cube ? 3 : 2;
}

/// The most colours of a kind of tiles: their complete sets can be counted with a TileIndex.
constexpr Color most_colors_of(TileKind kind)
{
    return kind == TileKind::cube ? max_cube_colors : kind == TileKind::wang_cube ? max_wang_cube_colors : max_colors;
}

/// A set of tiles of one kind. Its tiles have two numbers: the index, which tells the colours, and the
/// position in the set, from 0, in order of the indices. In complete sets these are the same.
class TileSet
{
public:
    /// All tiles with these colours. Kinds other than Wang have one number of colours. Throws InputError for
    /// fewer than 2 colours or more than most_colors_of(kind).
    static TileSet complete(TileKind kind, WangColors colors);
    static TileSet complete(TileKind kind, Color colors) { return complete(kind, {colors, colors}); }

    /// The tiles with these indices, without repetitions, in any order.
    TileSet(TileKind kind, WangColors colors, std::vector<TileIndex> indices);

    TileKind kind() const { return kind_; }
    WangColors colors() const { return colors_; }
    bool is_complete() const { return indices_.empty(); }
    std::uint64_t size() const { return size_; }

    /// The index of the tile at a position below size().
    TileIndex index(std::uint64_t position) const
    {
        return is_complete() ? static_cast<TileIndex>(position) : indices_[position];
    }

    /// The position of the tile in the set, if it is there. Takes logarithmic time, constant in complete sets.
    std::optional<std::uint64_t> position(TileIndex index) const;

private:
    TileSet(TileKind kind, WangColors colors);

    TileKind kind_;
    WangColors colors_;
    std::vector<TileIndex> indices_; ///< ascending; empty: all
    std::uint64_t size_ = 0;
};

/// 2 C^2 tiles with two choices for each pair of north and west colours, and for each pair of south and east
/// colours (D. 3.2.1, figure 3.2): those with (E, S) = (N + k, W + k) mod C, k = 0 and 1. Then all edges of a tiling by
/// scanlines are independent where they meet a tile, and all tiles as frequent. For two colours, these are the tiles 0,
/// 3, 5, 6, 9, 10, 12 and 15 that the SIGGRAPH 2008 class notes (part I) name; for more, D. names none. With
/// two numbers of colours, as in figure 1c of Cohen and others 2003, there are twice their product.
TileSet compact_wang_set(WangColors colors);
inline TileSet compact_wang_set(Color colors) { return compact_wang_set(WangColors{colors, colors}); }

/// The C^3 tiles that the direct algorithm with one hash function makes: N + S = E + W modulo C (D. 3.3.2.2).
/// For two colours, the set above.
TileSet one_hash_wang_set(Color colors);

/// 2 C^3 tiles with two choices for each triple of north-east, south-west and north-west colours (D. 3.2.2).
/// D. leaves open which; these have SE = NE + SW + NW + k mod C, k = 0 and 1, so that all tiles of a tiling
/// by scanlines are as frequent. For two colours, the complete set.
TileSet compact_corner_set(Color colors);

/// The Wang tile with pairs of corner colours as edge colours, over colors^2 colours (D. 2.9). A pair is the
/// western (southern) colour times `colors`, plus the eastern (northern) one.
WangTile equivalent_wang_tile(const CornerTile& tile, Color colors);

/// The Wang tile set equivalent to a set of corner tiles. Throws InputError for more than 16 colours, whose
/// pairs are more than max_colors.
TileSet equivalent_wang_set(const TileSet& corner_tiles);

}
