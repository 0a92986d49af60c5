#include "tiles/poisson/tile_pieces.hpp"

#include "tiles/tilings/tile_index.hpp"

#include <bit>

namespace poissonlab {
namespace {

/// The corners of a tile as corner_index() and cube_index() order them, most significant first: NE, SE, SW,
/// NW; in 3D those of the top before those of the bottom.
constexpr std::array<unsigned, 8> corner_order_3d{7, 5, 4, 6, 3, 1, 0, 2};
constexpr std::array<unsigned, 4> corner_order_2d{3, 1, 0, 2};

template <std::size_t Digits>
std::array<std::uint32_t, Digits> digits_of(std::uint32_t number, std::uint32_t base)
{
    std::array<std::uint32_t, Digits> digits{};
    for (std::size_t i = Digits; i-- > 0;) {
        digits[i] = number % base;
        number /= base;
    }
    return digits;
}

template <std::size_t Digits>
std::uint32_t number_of(const std::array<std::uint32_t, Digits>& digits, std::uint32_t base)
{
    std::uint32_t number = 0;
    for (const std::uint32_t digit : digits) number = number * base + digit;
    return number;
}

/// All cells of a tile's boundary, by rising dimension.
std::vector<TileCell> boundary_cells(int dimension)
{
    std::vector<TileCell> cells;
    const unsigned all = all_axes(dimension);
    for (int size = 0; size < dimension; ++size) {
        for (unsigned axes = 0; axes < all; ++axes) {
            if (std::popcount(axes) != size) continue;
            for (unsigned upper = 0; upper <= all; ++upper) {
                if ((upper & axes) != 0) continue;
                cells.push_back({static_cast<std::uint8_t>(axes), static_cast<std::uint8_t>(upper)});
            }
        }
    }
    return cells;
}

std::uint32_t corner_based_variant(const TileCell& cell, const std::array<std::uint32_t, 8>& corners,
                                   std::uint32_t colors)
{
    std::array<std::uint32_t, 8> own{};
    const unsigned count = 1u << std::popcount(cell.axes);
    for (unsigned k = 0; k < count; ++k) own[k] = corners[cell.upper | deposit_bits(k, cell.axes)];
    return corner_piece(std::span(own).first(count), colors);
}

std::uint32_t edge_based_variant(const TileCell& cell, const std::array<std::uint32_t, 12>& e, std::uint32_t colors)
{
    constexpr std::size_t north = 0, east = 1, south = 2, west = 3;
    constexpr std::size_t ne_east = 4, ne_north = 5, se_east = 6, se_south = 7, sw_west = 8, sw_south = 9, nw_west = 10,
                          nw_north = 11;
    if (cell.axes == 1) return cell.upper ? e[north] : e[south];
    if (cell.axes == 2) return cell.upper ? e[east] : e[west];
    const auto corner = [&](std::size_t n, std::size_t ea, std::size_t s, std::size_t w) {
        return number_of(std::array<std::uint32_t, 4>{e[n], e[ea], e[s], e[w]}, colors);
    };
    switch (cell.upper) {
    case 0:
        return corner(west, south, sw_south, sw_west);
    case 1:
        return corner(east, se_east, se_south, south);
    case 2:
        return corner(nw_north, north, west, nw_west);
    default:
        return corner(ne_north, ne_east, east, north);
    }
}

}

unsigned deposit_bits(unsigned packed, unsigned mask)
{
    unsigned result = 0;
    for (unsigned bit = 1; mask != 0; mask &= mask - 1, bit <<= 1) {
        if (packed & bit) result |= mask & -mask;
    }
    return result;
}

std::array<std::int8_t, 3> lattice_point(unsigned bits)
{
    return {static_cast<std::int8_t>(bits & 1), static_cast<std::int8_t>(bits >> 1 & 1),
            static_cast<std::int8_t>(bits >> 2 & 1)};
}

std::uint32_t piece_count(const PoissonTileParameters& p, std::uint8_t axes)
{
    if (axes == all_axes(p.dimension)) return p.tiles;
    if (p.kind == PoissonTileKind::frame) return 1;
    const int digits = p.kind == PoissonTileKind::edge ? (axes == 0 ? 4 : 1) : 1 << std::popcount(axes);
    std::uint32_t count = 1;
    for (int digit = 0; digit < digits; ++digit) count *= p.colors;
    return count;
}

std::array<std::uint32_t, 8> corner_colors_of(std::uint32_t tile, int dimension, std::uint32_t colors)
{
    std::array<std::uint32_t, 8> corners{};
    if (dimension == 2) {
        const auto digits = digits_of<4>(tile, colors);
        for (std::size_t i = 0; i < 4; ++i) corners[corner_order_2d[i]] = digits[i];
    } else {
        const auto digits = digits_of<8>(tile, colors);
        for (std::size_t i = 0; i < 8; ++i) corners[corner_order_3d[i]] = digits[i];
    }
    return corners;
}

std::uint32_t corner_tile_of(const std::array<std::uint32_t, 8>& corners, int dimension, std::uint32_t colors)
{
    std::uint32_t tile = 0;
    for (std::size_t i = 0; i < (dimension == 2 ? 4u : 8u); ++i) {
        tile = tile * colors + corners[dimension == 2 ? corner_order_2d[i] : corner_order_3d[i]];
    }
    return tile;
}

std::array<std::uint32_t, 12> edge_colors_of(std::uint32_t tile, std::uint32_t colors)
{
    return digits_of<12>(tile, colors);
}

std::uint32_t edge_tile_of(const std::array<std::uint32_t, 12>& edges, std::uint32_t colors)
{
    return number_of(edges, colors);
}

std::uint32_t corner_piece(std::span<const std::uint32_t> colors_of_corners, std::uint32_t colors)
{
    std::uint32_t variant = 0;
    for (std::size_t k = colors_of_corners.size(); k-- > 0;) variant = variant * colors + colors_of_corners[k];
    return variant;
}

std::vector<PlacedPiece> pieces_around(const PoissonTileParameters& p, std::uint32_t tile)
{
    std::array<std::uint32_t, 8> corners{};
    std::array<std::uint32_t, 12> edges{};
    if (p.kind == PoissonTileKind::corner) corners = corner_colors_of(tile, p.dimension, p.colors);
    if (p.kind == PoissonTileKind::edge) edges = edge_colors_of(tile, p.colors);
    std::vector<PlacedPiece> pieces;
    for (const TileCell& cell : boundary_cells(p.dimension)) {
        std::uint32_t variant = 0;
        if (p.kind == PoissonTileKind::corner) variant = corner_based_variant(cell, corners, p.colors);
        if (p.kind == PoissonTileKind::edge) variant = edge_based_variant(cell, edges, p.colors);
        pieces.push_back({cell.axes, lattice_point(cell.upper), variant});
    }
    return pieces;
}

}
