// kind = "substitution": a tiling by substitution, its rules, and how its tiles meet.
//
// Kaplan, Introductory Tiling Theory for Computer Graphics, 2009 (SIGGRAPH 2008 class notes, II), section 8.
#include "host/schemes/polygon_painter.hpp"
#include "host/schemes/polygon_tables.hpp"
#include "host/schemes/scheme_run.hpp"
#include "tiles/prototiles/substitution.hpp"

#include "base/files/whole_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

constexpr double margin = 0.25; // around tiles, in units of the picture

/// Parts of tiles that are made larger, with the outline of the whole.
MarkPicture rules_picture(const PolygonTiling& tiling, const PolygonStyle& style)
{
    constexpr double gap = 0.8;
    const double unit = picture_unit(tiling, scale_of(tiling.ring, tiling.parts[0][0].motion));
    MarkCanvas nowhere(1, 1, 1);
    std::vector<std::array<MarkPoint, 2>> boxes;
    double width = 0, height = 0;
    const auto enlarged = [&](const PolygonPainter& painter, std::size_t i) {
        std::vector<MarkPoint> outline;
        for (const RingPlace& corner : tiling.prototiles[i].corners)
            outline.push_back(painter.at(mapped(tiling.ring, tiling.magnification, corner)));
        return outline;
    };
    for (std::size_t i = 0; i < tiling.parts.size(); ++i) {
        const PolygonPainter painter(nowhere, tiling, style, {{}, {}, unit});
        boxes.push_back(box_around(painter, tiling.parts[i]));
        if (tiling.parts[i].empty()) continue;
        for (const MarkPoint& p : enlarged(painter, i)) boxes[i] = box_with(boxes[i], p);
        width += boxes[i][1][0] - boxes[i][0][0] + gap;
        height = std::max(height, boxes[i][1][1] - boxes[i][0][1]);
    }
    MarkCanvas canvas(width, height + gap, pixels_a_unit(width));
    double x = gap / 2;
    for (std::size_t i = 0; i < tiling.parts.size(); ++i) {
        if (tiling.parts[i].empty()) continue;
        PolygonPainter painter(canvas, tiling, style, {{}, {x - boxes[i][0][0], gap / 2 - boxes[i][0][1]}, unit});
        painter.paint(tiling.parts[i]);
        canvas.outline("#b03a2e", enlarged(painter, i), 0.08);
        x += boxes[i][1][0] - boxes[i][0][0] + gap;
    }
    return canvas.picture();
}

MarkPicture patch_picture(const PolygonTiling& tiling, const PolygonStyle& style, const std::vector<PlacedTile>& tiles)
{
    const PolygonView view{tiles[0].motion.at, {}, picture_unit(tiling, scale_of(tiling.ring, tiles[0].motion))};
    MarkCanvas nowhere(1, 1, 1);
    const auto [low, high] = box_around(PolygonPainter(nowhere, tiling, style, view), tiles);
    const double width = high[0] - low[0] + 2 * margin;
    MarkCanvas canvas(width, high[1] - low[1] + 2 * margin, pixels_a_unit(width));
    PolygonPainter(canvas, tiling, style, {view.middle, {margin - low[0], margin - low[1]}, view.unit}).paint(tiles);
    return canvas.picture();
}

MarkPicture window_picture(const PolygonTiling& tiling, const PolygonStyle& style, const std::vector<PlacedTile>& tiles,
                           const std::array<double, 2>& window, const RingPlace& middle, double unit)
{
    MarkCanvas canvas(window[0], window[1], pixels_a_unit(window[0]));
    PolygonPainter(canvas, tiling, style, {middle, {window[0] / 2, window[1] / 2}, unit}).paint(tiles);
    return canvas.picture();
}

/// True if the border of the tiles comes into a window around a place.
bool is_border_in_window(const PolygonTiling& tiling, const PatchSurvey& survey, const std::array<double, 2>& window,
                         const RingPlace& middle, double unit)
{
    return std::ranges::any_of(survey.border, [&](const RingPlace& place) {
        const auto away = point_of(tiling, place - middle);
        return std::abs(away[0]) < window[0] / 2 * unit && std::abs(away[1]) < window[1] / 2 * unit;
    });
}

/// Exact places and turns by the powers of the ring's unit vector, and rounded ones.
std::string tiles_csv(const PolygonTiling& tiling, const std::vector<AddressedTile>& tiles)
{
    std::string text = "address,tile,mirrored,x,y,degrees,at0,at1,at2,at3,turn0,turn1,turn2,turn3\n";
    for (const auto& [tile, address] : tiles) {
        const TileMotion& m = tile.motion;
        const auto at = point_of(tiling, m.at), turn = tiling.ring.value(m.turn);
        const double scale = scale_of(tiling.ring, m);
        const double degrees = std::atan2(turn[1], turn[0]) * 180 / std::numbers::pi;
        text += fmt::format("{},{},{},{:.9g},{:.9g},{:.9g},{},{}\n", fmt::join(address, "."),
                            tiling.prototiles[tile.prototile].name, m.is_mirrored ? 1 : 0, at[0] / scale, at[1] / scale,
                            degrees, fmt::join(m.at.c, ","), fmt::join(m.turn.c, ","));
    }
    return text;
}

/// The parts of all tiles that each prototile has after ever more divisions: the substitution matrix's eigenvector.
std::vector<double> limit_shares(const PolygonTiling& tiling)
{
    constexpr int steps = 400;
    std::vector<double> shares(tiling.parts.size(), 1);
    for (int step = 0; step < steps; ++step) {
        std::vector<double> next(shares.size());
        for (std::size_t i = 0; i < shares.size(); ++i)
            for (const PlacedTile& part : tiling.parts[i]) next[part.prototile] += shares[i];
        double sum = 0;
        for (const double share : next) sum += share;
        // The mean of two steps: a matrix that goes round and round has a limit as well.
        for (std::size_t i = 0; i < shares.size(); ++i) shares[i] = (shares[i] + next[i] / sum) / 2;
    }
    double sum = 0;
    for (const double share : shares) sum += share;
    for (double& share : shares) share /= sum;
    return shares;
}

DistributionTable tile_table(const PolygonTiling& tiling, const std::vector<AddressedTile>& tiles)
{
    DistributionTable table{"Tiles", {"tile", "tiles", "part", "part in the limit"}, {}};
    const std::vector<double> limit = limit_shares(tiling);
    for (std::size_t i = 0; i < tiling.prototiles.size(); ++i) {
        const auto count = std::ranges::count(tiles, i, [](const AddressedTile& t) { return t.tile.prototile; });
        table.rows.push_back({tiling.prototiles[i].name, fmt::format("{}", count),
                              fmt::format("{:.6f}", static_cast<double>(count) / static_cast<double>(tiles.size())),
                              fmt::format("{:.6f}", limit[i])});
    }
    return table;
}

}

DistributionResult make_substitution(const SubstitutionSettings& settings, DistributionFiles& files)
{
    const PolygonTiling tiling = tiling_of(settings.tiling);
    const Substitution substitution(tiling, start_of(tiling, settings.start));
    const WindowMiddle middle = window_middle(tiling, substitution, settings).value();
    const double unit = picture_unit(tiling, middle.scale);
    const double radius = settings.window ? std::hypot((*settings.window)[0], (*settings.window)[1]) / 2 : 0;
    const std::vector<AddressedTile> found =
        settings.window ? substitution.tiles_near(settings.depth, middle.place, radius * picture_unit(tiling, 1),
                                                  most_polygon_tiles)
                        : substitution.tiles(settings.depth, most_polygon_tiles);
    std::vector<PlacedTile> tiles;
    for (const AddressedTile& tile : found) tiles.push_back(tile.tile);
    DistributionResult result;
    result.facts = names_of(tiling);
    result.numbers = {
        {"tiles", "Tiles", static_cast<double>(tiles.size()), "", {}, true},
        {"inflation", "Inflation factor", substitution.inflation(), "how much longer a tile is than its parts"}};
    const PatchSurvey survey = survey_patch(tiling, tiles);
    add_survey(result, survey);
    if (settings.window && is_border_in_window(tiling, survey, *settings.window, middle.place, unit))
        result.facts.emplace_back("the window reaches beyond the tiles: other addresses are farther inside");
    result.tables.push_back(tile_table(tiling, found));
    result.tables.push_back(figure_table(survey));
    files.add_marks("rules.json", rules_picture(tiling, settings.style),
                    is_multiplication(tiling.ring, tiling.magnification)
                        ? "The parts of each tile; the red line is the tile itself, enlarged."
                        : "The parts of each tile; the red line is the tile itself after the linear map that enlarges "
                          "places, which bends it.",
                    result);
    if (settings.window)
        files.add_marks(
            "tiling.json", window_picture(tiling, settings.style, tiles, *settings.window, middle.place, unit),
            fmt::format("{} x {} sides of a square as large as the first tile, around the tile of address {}.",
                        (*settings.window)[0], (*settings.window)[1], fmt::join(middle.address, ".")),
            result);
    else
        files.add_marks("tiling.json", patch_picture(tiling, settings.style, tiles),
                        fmt::format("{} tiles after {} divisions.", tiles.size(), settings.depth), result);
    write_whole_file(files.add("tiles.csv", result), tiles_csv(tiling, found));
    return result;
}

}
