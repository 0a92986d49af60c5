// kind = "construction": how the lattice of corner tiles lies over that of Wang tiles in each of the constructions.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 8.3, figures 8.7 to 8.9 and 8.12: Wang tiles with solid
// lines, corner tiles with dashed ones.
#include "host/schemes/mark_canvas.hpp"
#include "host/schemes/scheme_run.hpp"
#include "host/settings/tilings/aperiodic_tiles.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
namespace {

constexpr double construction_margin = 0.15;

/// The place of the corner tile (0, 0) over the Wang tile (0, 0); see constructed_tilings.hpp.
MarkSquare first_corner_square(CornerConstruction construction)
{
    switch (construction) {
    case CornerConstruction::diagonal:
        return {{0.5, 0.5}};
    case CornerConstruction::horizontal:
        return {{0.5, 0}};
    case CornerConstruction::vertical:
        return {{0, 0.5}};
    case CornerConstruction::rotation:
        return {{0.5, 0}, {0.5, 0.5}, {-0.5, 0.5}};
    case CornerConstruction::subdivision:
        return {{0, 0}, {0.5, 0}, {0, 0.5}};
    }
    return {};
}

MarkSquare shifted(const MarkSquare& square, const MarkPoint& by)
{
    return {{square.corner[0] + by[0], square.corner[1] + by[1]}, square.right, square.up};
}

struct PlacedCornerTile
{
    MarkSquare square;
    CornerTile tile;
};

/// The corner tiles that lie wholly over the Wang tiles of the window.
std::vector<PlacedCornerTile> corner_tiles_over(const ConstructionSettings& settings, std::uint64_t seed)
{
    const std::string word = settings.set + "-" + corner_constructions[settings.construction];
    const MarkSquare first = first_corner_square(settings.construction);
    const auto width = static_cast<std::int64_t>(settings.width), height = static_cast<std::int64_t>(settings.height);
    // Turned and halved lattices reach so many tiles in all directions.
    const std::int64_t reach = 2 * (width + height);
    const TileWindow window{-reach, -reach, static_cast<std::uint64_t>(2 * reach),
                            static_cast<std::uint64_t>(2 * reach)};
    const std::vector<TileIndex> indices = aperiodic_window(word, seed, window);
    const Color colors = aperiodic_colors(word);
    const auto is_over = [&](const MarkPoint& p) {
        return p[0] >= 0 && p[1] >= 0 && p[0] <= static_cast<double>(width) && p[1] <= static_cast<double>(height);
    };
    std::vector<PlacedCornerTile> placed;
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const auto x = static_cast<double>(i % window.width) - static_cast<double>(reach);
        const auto y = static_cast<double>(window.height - 1 - i / window.width) - static_cast<double>(reach);
        const MarkPoint corner = first.at(x, y);
        const MarkSquare square{corner, first.right, first.up};
        if (std::ranges::all_of(square.outline(), is_over)) placed.push_back({square, corner_tile(indices[i], colors)});
    }
    return placed;
}

void draw_wang_tiles(MarkCanvas& canvas, const ConstructionSettings& settings, std::uint64_t seed, bool has_colors)
{
    const std::vector<TileIndex> indices =
        aperiodic_window(settings.set, seed, {0, 0, settings.width, settings.height});
    const Color colors = aperiodic_colors(settings.set);
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const MarkSquare square{{construction_margin + static_cast<double>(i % settings.width),
                                 construction_margin + static_cast<double>(settings.height - 1 - i / settings.width)}};
        if (has_colors)
            canvas.tile(wang_tile(indices[i], {colors, colors}), square);
        else
            canvas.outline("#b4bac2", square.outline(), 0.03);
    }
}

}

DistributionResult make_construction(const ConstructionSettings& settings, std::uint64_t seed, DistributionFiles& files)
{
    const double width = static_cast<double>(settings.width) + 2 * construction_margin;
    const double height = static_cast<double>(settings.height) + 2 * construction_margin;
    MarkCanvas wang(width, height, 100), corners(width, height, 100);
    draw_wang_tiles(wang, settings, seed, true);
    draw_wang_tiles(corners, settings, seed, false);
    const auto placed = corner_tiles_over(settings, seed);
    for (const PlacedCornerTile& entry : placed) {
        const MarkSquare square = shifted(entry.square, {construction_margin, construction_margin});
        const auto outline = square.outline();
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const MarkPoint &from = outline[i], &to = outline[(i + 1) % outline.size()];
            wang.dashed_line("#ffffff", from, to, 0.05, 0.0625);
            wang.dashed_line("#000000", from, to, 0.03, 0.0625);
        }
        corners.tile(entry.tile, square, 0.02);
    }
    DistributionResult result;
    const std::string construction = corner_constructions[settings.construction];
    result.facts = {fmt::format("{}, {}", settings.set, construction), fmt::format("{} corner tiles", placed.size())};
    files.add_marks("lattices.json", wang.picture(),
                    "Wang tiles (solid lines) and the lattice of corner tiles (dashed lines).", result);
    files.add_marks("corners.json", corners.picture(), "The corner tiles; Wang tiles are the grey lines.", result);
    return result;
}

}
