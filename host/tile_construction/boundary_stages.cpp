#include "host/tile_construction/boundary_stages.hpp"

#include <bit>

namespace poissonlab {
namespace {

/// Tori that are filled for each piece, or pair of colours. Corners and edges are chosen among the candidates
/// that these give: 8 octagons, 10 edges, in 3D 16 corners, 8 edges and 4 faces. (In 3D tori are expensive.)
constexpr int corner_tori = 2;
constexpr int edge_tori_2d = 5;
constexpr int edge_tori_3d = 2;
constexpr int face_tori = 2;

/// The colours of the corners of a piece of a corner-based set, see corner_piece().
std::vector<std::uint32_t> colors_of(std::uint32_t variant, std::uint8_t axes, std::uint32_t colors)
{
    std::vector<std::uint32_t> corners(std::size_t{1} << std::popcount(axes));
    for (std::uint32_t& corner : corners) {
        corner = variant % colors;
        variant /= colors;
    }
    return corners;
}

/// Every cell of a torus, all with the same variant.
std::vector<PlacedPiece> everywhere(std::uint8_t axes, std::uint32_t variant, int dimension)
{
    std::vector<PlacedPiece> pieces;
    for (unsigned base = 0; base < 1u << dimension; ++base) pieces.push_back({axes, lattice_point(base), variant});
    return pieces;
}

void repeat(std::vector<BoundaryTorus>& tori, const BoundaryTorus& torus, int times)
{
    for (int i = 0; i < times; ++i) tori.push_back(torus);
}

// Corner-based tiles.

BoundaryStage corner_stage(const PoissonTileParameters& p)
{
    BoundaryStage stage{0, "corners", {}, false};
    for (std::uint32_t color = 0; color < p.colors; ++color)
        repeat(stage.tori, {{}, everywhere(0, color, p.dimension)}, corner_tori);
    return stage;
}

/// All edges between corners of two colours, a at even places.
BoundaryTorus edge_torus(const PoissonTileParameters& p, std::uint32_t a, std::uint32_t b)
{
    BoundaryTorus torus;
    for (unsigned base = 0; base < 1u << p.dimension; ++base) {
        const bool is_odd = std::popcount(base) & 1;
        const std::array<std::uint32_t, 2> ends{is_odd ? b : a, is_odd ? a : b};
        torus.held.push_back({0, lattice_point(base), ends[0]});
        for (int axis = 0; axis < p.dimension; ++axis)
            torus.made.push_back(
                {static_cast<std::uint8_t>(1 << axis), lattice_point(base), corner_piece(ends, p.colors)});
    }
    return torus;
}

BoundaryStage edge_stage(const PoissonTileParameters& p)
{
    BoundaryStage stage{1, "edges", {}, p.dimension == 2};
    for (std::uint32_t a = 0; a < p.colors; ++a) {
        for (std::uint32_t b = a; b < p.colors; ++b)
            repeat(stage.tori, edge_torus(p, a, b), p.dimension == 2 ? edge_tori_2d : edge_tori_3d);
    }
    return stage;
}

/// A face twice, in both layers of the torus, between the corners and edges around it.
BoundaryTorus face_torus(const PoissonTileParameters& p, std::uint8_t axes, std::uint32_t variant)
{
    const unsigned across = all_axes(3) & ~axes;
    BoundaryTorus torus;
    for (const unsigned layer : {0u, across}) {
        for (PlacedPiece piece : earlier_neighbours(p, axes, variant)) {
            for (std::size_t k = 0; k < 3; ++k)
                piece.base[k] = static_cast<std::int8_t>(piece.base[k] + lattice_point(layer)[k]);
            torus.held.push_back(piece);
        }
        torus.made.push_back({axes, lattice_point(layer), variant});
    }
    return torus;
}

BoundaryStage face_stage(const PoissonTileParameters& p, int across)
{
    const auto axes = static_cast<std::uint8_t>(all_axes(3) & ~(1 << across));
    BoundaryStage stage{static_cast<std::uint32_t>(2 + across), "faces", {}, true};
    for (std::uint32_t variant = 0; variant < piece_count(p, axes); ++variant)
        repeat(stage.tori, face_torus(p, axes, variant), face_tori);
    return stage;
}

// Edge-based tiles.

BoundaryStage free_edge_stage(const PoissonTileParameters& p)
{
    BoundaryStage stage{1, "edges", {}, false};
    for (std::uint32_t color = 0; color < p.colors; ++color) {
        BoundaryTorus torus;
        for (const std::uint8_t axes : std::array<std::uint8_t, 2>{1, 2}) {
            for (const PlacedPiece& piece : everywhere(axes, color, 2)) torus.made.push_back(piece);
        }
        repeat(stage.tori, torus, corner_tori);
    }
    return stage;
}

/// The corner between four edges, at (0, 0) and at (1, 1); at the other two lattice points the same edges
/// meet with east and west, north and south exchanged in part.
BoundaryTorus edge_corner_torus(const PoissonTileParameters& p, std::uint32_t variant)
{
    const std::uint32_t west = variant % p.colors;
    const std::uint32_t south = variant / p.colors % p.colors;
    const std::uint32_t east = variant / p.colors / p.colors % p.colors;
    const std::uint32_t north = variant / p.colors / p.colors / p.colors;
    BoundaryTorus torus;
    torus.held = {{1, {0, 0, 0}, east},  {1, {1, 0, 0}, west},  {1, {1, 1, 0}, east},  {1, {0, 1, 0}, west},
                  {2, {0, 0, 0}, north}, {2, {0, 1, 0}, south}, {2, {1, 1, 0}, north}, {2, {1, 0, 0}, south}};
    torus.made = {{0, {0, 0, 0}, variant}, {0, {1, 1, 0}, variant}};
    return torus;
}

BoundaryStage edge_corner_stage(const PoissonTileParameters& p)
{
    BoundaryStage stage{0, "corners", {}, true};
    for (std::uint32_t variant = 0; variant < piece_count(p, 0); ++variant)
        repeat(stage.tori, edge_corner_torus(p, variant), edge_tori_2d);
    return stage;
}

}

std::vector<BoundaryStage> boundary_stages(const PoissonTileParameters& p)
{
    if (p.kind == PoissonTileKind::edge) return {free_edge_stage(p), edge_corner_stage(p)};
    std::vector<BoundaryStage> stages{corner_stage(p), edge_stage(p)};
    if (p.dimension == 3) {
        for (int across = 0; across < 3; ++across) stages.push_back(face_stage(p, across));
    }
    return stages;
}

std::vector<PlacedPiece> earlier_neighbours(const PoissonTileParameters& p, std::uint8_t axes, std::uint32_t variant)
{
    if (p.kind == PoissonTileKind::edge) {
        if (axes != 0) return {};
        const BoundaryTorus torus = edge_corner_torus(p, variant);
        return {{1, {0, 0, 0}, torus.held[0].variant},
                {1, {-1, 0, 0}, torus.held[1].variant},
                {2, {0, 0, 0}, torus.held[4].variant},
                {2, {0, -1, 0}, torus.held[5].variant}};
    }
    // The corners, edges and faces of the piece's cell.
    const std::vector<std::uint32_t> corners = colors_of(variant, axes, p.colors);
    std::vector<PlacedPiece> pieces;
    for (unsigned own = 0; own < axes; ++own) {
        if ((own & axes) != own) continue;
        const unsigned others = axes & ~own;
        for (unsigned place = 0; place < 1u << std::popcount(others); ++place) {
            const unsigned upper = deposit_bits(place, others);
            std::vector<std::uint32_t> own_corners;
            for (unsigned corner = 0; corner < corners.size(); ++corner) {
                if ((deposit_bits(corner, axes) & others) == upper) own_corners.push_back(corners[corner]);
            }
            pieces.push_back(
                {static_cast<std::uint8_t>(own), lattice_point(upper), corner_piece(own_corners, p.colors)});
        }
    }
    return pieces;
}

}
