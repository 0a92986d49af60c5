// Tile sets for tests, made in the plainest way: sequential dart throwing, piece after piece, then tile after
// tile.
#pragma once

#include "tiles/poisson/poisson_tile_set.hpp"
#include "tiles/poisson/tile_pieces.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

namespace poissonlab {

using TestPosition = std::array<std::int64_t, 3>; ///< in units; 2D: z is 0

inline std::int64_t squared_distance(const TestPosition& a, const TestPosition& b)
{
    std::int64_t sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return sum;
}

inline PoissonTileParameters corner_parameters(std::uint32_t colors, std::uint32_t points = 48, double radius = 0.55)
{
    PoissonTileParameters p;
    p.colors = colors;
    p.tiles = tile_count(p.kind, 2, colors);
    p.points_per_tile = points;
    p.relative_radius = radius;
    return p;
}

inline PoissonTileParameters edge_parameters(std::uint32_t colors)
{
    PoissonTileParameters p = corner_parameters(colors);
    p.kind = PoissonTileKind::edge;
    p.tiles = tile_count(p.kind, 2, colors);
    return p;
}

inline PoissonTileParameters template_parameters(std::uint32_t tiles)
{
    PoissonTileParameters p = corner_parameters(1);
    p.kind = PoissonTileKind::frame;
    p.tiles = tiles;
    return p;
}

inline PoissonTileParameters sphere_parameters(std::uint32_t colors)
{
    PoissonTileParameters p = corner_parameters(colors, 64, 0.5);
    p.dimension = 3;
    p.tiles = tile_count(p.kind, 3, colors);
    return p;
}

/// Throws darts for one tile set.
class MadeUpTileSet
{
public:
    MadeUpTileSet(const PoissonTileParameters& parameters, unsigned seed)
        : parameters_(parameters), regions_(regions_of(parameters)), random_(seed),
          squared_distance_(static_cast<std::int64_t>(asked_squared_distance(parameters)))
    {}

    PoissonTileSet make()
    {
        // Corners depend on edges in edge-based sets, and cells on those of lower dimension in the others.
        std::vector<std::uint8_t> order{0, 1, 2};
        if (parameters_.dimension == 3) order = {0, 1, 2, 4, 3, 5, 6};
        if (parameters_.kind == PoissonTileKind::edge) order = {1, 2, 0};
        for (const std::uint8_t axes : order) make_pieces(axes);
        PoissonTileSet set{parameters_, 0, {}};
        for (std::uint32_t tile = 0; tile < parameters_.tiles; ++tile) add_tile(tile, set.points);
        return set;
    }

private:
    using Points = std::vector<TestPosition>;

    void make_pieces(std::uint8_t axes)
    {
        const double expected = parameters_.points_per_tile * regions_.volume(axes);
        for (std::uint32_t variant = 0; variant < piece_count(parameters_, axes); ++variant) {
            const double extra = std::uniform_real_distribution(0.0, 1.0)(random_);
            const Points around =
                parameters_.kind == PoissonTileKind::edge ? edges_of_corner(axes, variant) : border_of(axes, variant);
            pieces_[{axes, variant}] =
                darts(axes, around, static_cast<std::size_t>(std::floor(expected + extra)), 2000);
        }
    }

    /// Edge tiles: the edges that leave a corner, its digits, are all that its points have to suit.
    Points edges_of_corner(std::uint8_t axes, std::uint32_t variant)
    {
        Points points;
        if (axes != 0) return points;
        const std::uint32_t c = parameters_.colors;
        append(points, 2, variant / (c * c * c), {0, 0, 0});
        append(points, 1, variant / (c * c) % c, {0, 0, 0});
        append(points, 2, variant / c % c, {0, -1, 0});
        append(points, 1, variant % c, {-1, 0, 0});
        return points;
    }

    /// Other tiles: the cells on the border of this one, as some tile has them that has it at its lower
    /// corner.
    Points border_of(std::uint8_t axes, std::uint32_t variant)
    {
        for (std::uint32_t tile = 0; tile < parameters_.tiles; ++tile) {
            const std::vector<PlacedPiece> all = pieces_around(parameters_, tile);
            if (std::ranges::find(all, PlacedPiece{axes, {}, variant}) == all.end()) continue;
            Points points;
            for (const PlacedPiece& piece : all) {
                const int upper = piece.base[0] | piece.base[1] << 1 | piece.base[2] << 2;
                const bool is_on_border = (piece.axes & ~axes) == 0 && (upper & ~axes) == 0 && piece.axes != axes;
                if (is_on_border) append(points, piece.axes, piece.variant, piece.base);
            }
            return points;
        }
        throw std::logic_error("no tile has this variant");
    }

    void add_tile(std::uint32_t tile, std::vector<std::uint16_t>& coordinates)
    {
        Points around;
        for (const PlacedPiece& piece : pieces_around(parameters_, tile))
            append(around, piece.axes, piece.variant, piece.base);
        Points own;
        std::ranges::copy_if(around, std::back_inserter(own), [this](const TestPosition& p) {
            for (int k = 0; k < parameters_.dimension; ++k)
                if (p[static_cast<std::size_t>(k)] < 0 || p[static_cast<std::size_t>(k)] >= tile_units) return false;
            return true;
        });
        const std::size_t missing = parameters_.points_per_tile - own.size();
        const Points inside = darts(all_axes(parameters_.dimension), around, missing, 200'000);
        if (inside.size() != missing) throw std::runtime_error("there is no room for so many points");
        own.insert(own.end(), inside.begin(), inside.end());
        for (const TestPosition& p : own)
            for (int k = 0; k < parameters_.dimension; ++k)
                coordinates.push_back(static_cast<std::uint16_t>(p[static_cast<std::size_t>(k)]));
    }

    void append(Points& points, std::uint8_t axes, std::uint32_t variant, const std::array<std::int8_t, 3>& base)
    {
        for (TestPosition p : pieces_.at({axes, variant})) {
            for (std::size_t k = 0; k < 3; ++k) p[k] += base[k] * tile_units;
            points.push_back(p);
        }
    }

    /// Up to `count` points in the region of the cell with these axes at the origin.
    Points darts(std::uint8_t axes, const Points& around, std::size_t count, int attempts)
    {
        Points points;
        for (int failed = 0; points.size() < count && failed < attempts; ++failed) {
            TestPosition p{};
            std::array<std::uint16_t, 3> in_tile{};
            std::uint8_t upper = 0;
            for (unsigned k = 0; k < static_cast<unsigned>(parameters_.dimension); ++k) {
                in_tile[k] = static_cast<std::uint16_t>(random_());
                const bool is_below = !(axes >> k & 1) && in_tile[k] > tile_units / 2;
                p[k] = in_tile[k] - (is_below ? tile_units : 0);
                if (is_below) upper |= static_cast<std::uint8_t>(1 << k);
            }
            const TileCell cell =
                regions_.cell_of(std::span(in_tile).first(static_cast<std::size_t>(regions_.dimension)));
            const auto is_far = [&](const TestPosition& q) { return squared_distance(p, q) >= squared_distance_; };
            if (cell != TileCell{axes, upper} || !std::ranges::all_of(around, is_far) ||
                !std::ranges::all_of(points, is_far))
                continue;
            points.push_back(p);
            failed = 0;
        }
        return points;
    }

    PoissonTileParameters parameters_;
    TileRegions regions_;
    std::mt19937 random_;
    std::int64_t squared_distance_;
    std::map<std::pair<std::uint8_t, std::uint32_t>, Points> pieces_;
};

inline PoissonTileSet made_up(const PoissonTileParameters& parameters, unsigned seed = 1)
{
    return MadeUpTileSet(parameters, seed).make();
}

/// Points somewhere, enough for files.
inline PoissonTileSet random_points(const PoissonTileParameters& parameters, unsigned seed = 1)
{
    PoissonTileSet set{parameters, 0, {}};
    std::mt19937 random(seed);
    set.points.resize(std::size_t{parameters.tiles} * parameters.points_per_tile *
                      static_cast<std::size_t>(parameters.dimension));
    for (std::uint16_t& x : set.points) x = static_cast<std::uint16_t>(random());
    return set;
}

/// All tiles hold the same jittered grid, a Poisson disk pattern on the torus.
inline PoissonTileSet same_grid_everywhere(PoissonTileParameters parameters, std::int32_t jitter, unsigned seed = 1)
{
    constexpr std::int32_t side = 8;
    parameters.points_per_tile = side * side;
    PoissonTileSet set{parameters, 0, {}};
    std::mt19937 random(seed);
    std::uniform_int_distribution offset(-jitter, jitter);
    std::vector<std::uint16_t> grid;
    for (std::int32_t i = 0; i < side * side; ++i) {
        for (const std::int32_t place : {i % side, i / side})
            grid.push_back(static_cast<std::uint16_t>((2 * place + 1) * tile_units / (2 * side) + offset(random)));
    }
    for (std::uint32_t tile = 0; tile < parameters.tiles; ++tile)
        set.points.insert(set.points.end(), grid.begin(), grid.end());
    return set;
}

}
