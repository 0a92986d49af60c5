// kind = "direct": the scheme of the direct stochastic tiling algorithms. A hash function gives the points of a lattice
// their colours, and these become the colours of tiles.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 3.3, figures 3.4 to 3.7. Where there are two hash
// functions, the left half of a point is the one for horizontal edges.
#include "host/schemes/mark_canvas.hpp"
#include "host/schemes/scheme_run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace poissonlab {
namespace {

constexpr double lattice_margin = 0.3;
constexpr double point_radius = 0.13;

Color color_of(const ColorHash& hash, std::int64_t x, std::int64_t y)
{
    return std::visit([&](const auto& h) { return h(x, y); }, hash);
}

/// A point with a colour of each of two hash functions.
void draw_halves(MarkCanvas& canvas, const MarkPoint& place, Color left, Color right)
{
    constexpr int steps = 16;
    canvas.disk("#000000", place, point_radius);
    for (const bool is_right : {false, true}) {
        std::vector<MarkPoint> half;
        for (int i = 0; i <= steps; ++i) {
            const double angle = std::numbers::pi * ((is_right ? -0.5 : 0.5) + static_cast<double>(i) / steps);
            half.push_back(
                {place[0] + 0.86 * point_radius * std::cos(angle), place[1] + 0.86 * point_radius * std::sin(angle)});
        }
        canvas.polygon(tile_color(is_right ? right : left), std::move(half));
    }
}

/// The points of the lattice, of the dense one for a hash function at the edges.
void draw_lattice(MarkCanvas& canvas, const DirectTilingSettings& settings, const Tiling& tiling)
{
    const TileWindow& w = settings.window;
    const bool is_dense = tiling.algorithm() == DirectAlgorithm::wang_edge_hash;
    const std::uint64_t scale = is_dense ? 2 : 1;
    for (std::uint64_t j = 0; j <= scale * w.height; ++j)
        for (std::uint64_t i = 0; i <= scale * w.width; ++i) {
            const MarkPoint place{lattice_margin + static_cast<double>(i) / static_cast<double>(scale),
                                  lattice_margin + static_cast<double>(j) / static_cast<double>(scale)};
            const std::int64_t x = stepped(is_dense ? doubled(w.x) : w.x, i);
            const std::int64_t y = stepped(is_dense ? doubled(w.y) : w.y, j);
            if (is_dense && i % 2 == j % 2)
                canvas.disk("#8a8f98", place, 0.3 * point_radius);
            else if (tiling.algorithm() == DirectAlgorithm::wang_two_hashes)
                draw_halves(canvas, place, color_of(tiling.hash(), x, y), color_of(tiling.vertical_hash(), x, y));
            else
                canvas.dot(tile_color(color_of(tiling.hash(), x, y)), place, point_radius);
        }
}

MarkCanvas empty_canvas(const TileWindow& w)
{
    return {static_cast<double>(w.width) + 2 * lattice_margin, static_cast<double>(w.height) + 2 * lattice_margin, 80};
}

/// Calls `use` with the lower left corner of each tile in the picture and its index.
void for_each_tile(const TileWindow& w, const Tiling& tiling, const auto& use)
{
    for (std::uint64_t j = 0; j < w.height; ++j)
        for (std::uint64_t i = 0; i < w.width; ++i)
            use(MarkSquare{{lattice_margin + static_cast<double>(i), lattice_margin + static_cast<double>(j)}},
                tiling.tile(stepped(w.x, i), stepped(w.y, j)));
}

}

DistributionResult make_direct_scheme(const DirectTilingSettings& settings, DistributionFiles& files)
{
    const TilingRequest& request = settings.request;
    const Tiling tiling = make_direct_tiling(request);
    MarkCanvas lattice = empty_canvas(settings.window), tiles = empty_canvas(settings.window);
    for_each_tile(settings.window, tiling, [&](const MarkSquare& square, TileIndex index) {
        lattice.outline("#c8ccd2", square.outline(), 0.02);
        if (request.kind == TileKind::wang)
            tiles.tile(wang_tile(index, request.all_colors()), square);
        else
            tiles.tile(corner_tile(index, request.colors), square);
    });
    draw_lattice(lattice, settings, tiling);
    draw_lattice(tiles, settings, tiling);
    DistributionResult result;
    result.facts = {tile_kind_words(request.kind), fmt::format("{} colours", request.colors),
                    fmt::format("algorithm {}, hash {}", request.algorithm,
                                hash_names().at(static_cast<std::size_t>(request.hash)))};
    const char* how = request.algorithm == "direct" ? "Each corner has the colour of its point."
                      : request.algorithm == "edge-hash"
                          ? "Each edge has the colour of the point in its middle; others "
                            "are left out."
                          : "Each edge has the sum of the colours at its ends, modulo "
                            "their number.";
    files.add_marks("lattice.json", lattice.picture(), "(a) The coloured lattice.", result);
    files.add_marks("tiles.json", tiles.picture(), fmt::format("(b) The tiles. {}", how), result);
    return result;
}

}
