// kind = "scanline": the scanline algorithm at work. Four moments of one tiling, with the tiles that fit next.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 3.2, figures 3.1 and 3.3.
#include "host/schemes/mark_canvas.hpp"
#include "host/schemes/scheme_run.hpp"
#include "tiles/tilings/scanline_tiling.hpp"

#include <fmt/format.h>

#include <array>
#include <span>
#include <vector>

namespace poissonlab {
namespace {

constexpr std::size_t steps_side = 4;       // of the tiling that is placed
constexpr std::size_t most_candidates = 16; // that are drawn
constexpr std::size_t candidate_columns = 4;
constexpr double steps_margin = 0.1;

struct Moment
{
    std::size_t column, row; ///< of the tile that is placed next, from the north-west
    const char* key;
    const char* caption;
};

constexpr std::array<Moment, 4> moments{
    {{0, 0, "first", "(a) The first tile: any."},
     {2, 0, "first_row", "(b) The first row: tiles that fit to the one in the west."},
     {0, 2, "row_start", "(c) The first tile of a row: tiles that fit to the one in the north."},
     {2, 2, "inside", "(d) Inside: tiles that fit to both."}}};

/// The tiles of a scanline tiling, rows from the north.
std::vector<TileIndex> placed_tiles(const TileSet& set, std::uint64_t seed)
{
    ScanlineTiling tiling(set, steps_side, seed);
    std::vector<TileIndex> tiles;
    for (std::size_t row = 0; row < steps_side; ++row) {
        const auto next = tiling.next_row();
        tiles.insert(tiles.end(), next.begin(), next.end());
    }
    return tiles;
}

void draw_tile(MarkCanvas& canvas, const TileSet& set, TileIndex tile, double x, double y)
{
    if (set.kind() == TileKind::wang)
        canvas.tile(wang_tile(tile, set.colors()), {{x, y}});
    else
        canvas.tile(corner_tile(tile, set.colors().horizontal), {{x, y}});
}

MarkPicture picture_at(const Moment& moment, const TileSet& set, const std::vector<TileIndex>& tiles,
                       std::span<const TileIndex> choices)
{
    const double gap = 0.2;
    const double width = steps_side + 0.6 + candidate_columns + (candidate_columns - 1) * gap + 2 * steps_margin;
    MarkCanvas canvas(width, steps_side + (steps_side - 1) * gap + 2 * steps_margin, 55);
    const double top = canvas.picture().height - steps_margin;
    const auto place = [&](std::size_t column, std::size_t row) {
        return MarkPoint{steps_margin + static_cast<double>(column), top - static_cast<double>(row + 1)};
    };
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const std::size_t column = i % steps_side, row = i / steps_side;
        const MarkSquare square{place(column, row)};
        const bool is_placed = row < moment.row || (row == moment.row && column < moment.column);
        if (is_placed)
            draw_tile(canvas, set, tiles[i], square.corner[0], square.corner[1]);
        else
            canvas.outline("#c8ccd2", square.outline(), 0.02);
    }
    const MarkSquare next{place(moment.column, moment.row)};
    canvas.polygon("#e4e7eb", next.outline());
    canvas.outline("#000000", next.outline(), 0.06);
    canvas.words(next.at(0.5, 0.5), 0.6, "?");
    for (std::size_t i = 0; i < std::min(choices.size(), most_candidates); ++i)
        draw_tile(canvas, set, choices[i],
                  steps_margin + steps_side + 0.6 + (1 + gap) * static_cast<double>(i % candidate_columns),
                  top - 1 - (1 + gap) * static_cast<double>(i / candidate_columns));
    return canvas.picture();
}

}

DistributionResult make_scanline_steps(const ScanlineStepsSettings& settings, std::uint64_t seed,
                                       DistributionFiles& files)
{
    const Color colors = settings.colors;
    const TileSet set = !settings.is_compact               ? TileSet::complete(settings.tiles, colors)
                        : settings.tiles == TileKind::wang ? compact_wang_set(colors)
                                                           : compact_corner_set(colors);
    const FittingTiles fitting(set);
    const std::vector<TileIndex> tiles = placed_tiles(set, seed);
    DistributionResult result;
    result.facts = {tile_kind_words(settings.tiles), fmt::format("{} colours", colors),
                    fmt::format("{} tiles in the {} set", set.size(), settings.is_compact ? "compact" : "complete")};
    result.numbers.push_back({"tiles", "Tiles in the set", static_cast<double>(set.size()), "counted"});
    for (const Moment& moment : moments) {
        const std::size_t at = moment.row * steps_side + moment.column;
        const auto choices = fitting.choices(moment.row > 0 ? &tiles[at - steps_side] : nullptr,
                                             moment.column > 0 ? &tiles[at - 1] : nullptr);
        files.add_marks(fmt::format("{}.json", moment.key), picture_at(moment, set, tiles, choices),
                        fmt::format("{} {} fit{}.", moment.caption, choices.size(),
                                    choices.size() > most_candidates
                                        ? fmt::format(", of which {} are shown", most_candidates)
                                        : ""),
                        result);
    }
    result.numbers.push_back({"fewest_choices", "Fewest choices", static_cast<double>(fitting.fewest_choices()),
                              "tiles that fit, wherever a tile is to be placed in any tiling"});
    return result;
}

}
