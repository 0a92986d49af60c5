// Isohedral tilings as symbols: how a tile's edges meet those of its neighbours, up to symmetry.
//
// A tile with k edges has 2k chambers, one for each edge and half of it: chamber 2e is the half of edge e at vertex e,
// chamber 2e + 1 the one at vertex e + 1; edges go counterclockwise, edge e from vertex e to vertex e + 1. Three
// involutions tell a tiling: s0 goes to the other half of the edge, s1 to the half at the same vertex of the edge
// beside it, and s2 to the tile across the edge. Chambers that a symmetry of the tiling maps to each other are one
// class (Delaney symbols: Dress and Huson, On tilings of the plane, 1987). The types of isohedral tilings are those of
// Gruenbaum and Shephard, Tilings and Patterns, 1986, section 6.2, whose incidence symbols are read off.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace poissonlab {

/// One of the eleven Laves tilings: how many tiles meet at each vertex of a tile, counterclockwise.
struct LavesTiling
{
    std::string name; ///< "3^6", "3^2.4.3.4"
    std::vector<int> degrees;
};

/// All of them, in the order of Gruenbaum and Shephard's types.
const std::vector<LavesTiling>& laves_tilings();

/// The shapes that an edge may have.
enum class EdgeShape
{
    free,     ///< J: any
    turned,   ///< S: the same after half a turn about its middle
    mirrored, ///< U: the same in a mirror across its middle
    straight  ///< I
};
/// "J", "S", "U", "I".
const char* name_of(EdgeShape shape);

struct TileSymbol
{
    std::vector<int> degrees;          ///< of the tile's vertices
    std::vector<std::size_t> class_of; ///< of each chamber
    std::vector<std::size_t> across;   ///< s2, by class
    std::vector<std::vector<std::size_t>>
        symmetries; ///< of the tile in the tiling: where each chamber goes; first none

    std::size_t edges() const { return degrees.size(); }
    std::size_t classes() const { return across.size(); }

    /// A chamber of a class: the first one.
    std::size_t chamber_of(std::size_t its_class) const;

    /// The chamber of this tile that a neighbour has where the neighbour touches `chamber`; any of those that
    /// symmetries of the tile make equal.
    std::size_t chamber_across(std::size_t chamber) const { return chamber_of(across[class_of[chamber]]); }

    EdgeShape shape(std::size_t edge) const;

    /// The incidence symbol, "a+b+c+;a-b-c-", read from an edge on, counterclockwise or clockwise.
    std::string incidence(std::size_t first_edge, bool is_clockwise) const;

    /// All incidence symbols of the same type.
    std::vector<std::string> incidences() const;
};

/// The other half of the edge, and the edge beside it at the same vertex, of a tile with so many edges.
constexpr std::size_t other_half(std::size_t chamber) { return chamber ^ 1; }
constexpr std::size_t beside_vertex(std::size_t chamber, std::size_t edges)
{
    return chamber % 2 == 1 ? (chamber + 1) % (2 * edges) : (chamber + 2 * edges - 1) % (2 * edges);
}

/// One symbol of each type of isohedral tilings with tiles as those of a Laves tiling: all ways to meet across edges,
/// by all groups of symmetries that the tile can have, without those that are the same up to names.
std::vector<TileSymbol> tile_symbols(const LavesTiling& laves);

/// Numbers the edges of a symbol anew, counterclockwise, so that `incidence`, one of incidences(), is read from edge 0
/// on. Where it is read clockwise, the tile is reflected. Throws std::logic_error for another incidence symbol.
TileSymbol read_from(const TileSymbol& symbol, const std::string& incidence);

/// The symbol of the tiling in a mirror.
TileSymbol mirror_image(const TileSymbol& symbol);

/// True if the tiling in a mirror is one of the same type, up to rotations. Vertices tell this where incidence symbols
/// do not: in a mirror, two corners of IH21 change places, and six tiles meet at one of them, three at the other.
bool is_own_mirror_image(const TileSymbol& symbol);

/// The symbols that more symmetries of the tile would make of a symbol, as far as neighbours allow them.
std::vector<TileSymbol> more_symmetric(const TileSymbol& symbol);

}
