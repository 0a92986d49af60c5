// kind = "periodic": a periodic tiling by polygons, and how many classes of tiles and corners it has.
//
// Kaplan, Introductory Tiling Theory for Computer Graphics, 2009 (SIGGRAPH 2008 class notes, II), sections 5 to 7.
#include "host/schemes/polygon_painter.hpp"
#include "host/schemes/polygon_tables.hpp"
#include "host/schemes/scheme_run.hpp"
#include "tiles/prototiles/periodic_tiling.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace poissonlab {
namespace {

MarkPicture periodic_picture(const PolygonTiling& tiling, const PeriodicSettings& settings,
                             const std::vector<PlacedTile>& tiles)
{
    const auto [width, height] = settings.window;
    MarkCanvas canvas(width, height, pixels_a_unit(width));
    PolygonPainter painter(canvas, tiling, settings.style, {{}, {width / 2, height / 2}, picture_unit(tiling, 1)});
    painter.paint(tiles);
    if (!settings.shows_unit) return canvas.picture();
    const auto& [first, second] = tiling.period;
    const std::array<RingPlace, 4> corners{RingPlace{}, first, first + second, second};
    for (std::size_t i = 0; i < 4; ++i)
        canvas.dashed_line("#b03a2e", painter.at(corners[i]), painter.at(corners[(i + 1) % 4]), 0.08, 0.2);
    return canvas.picture();
}

/// Tiles that are equal but for a shift have one aspect.
std::size_t aspects_of(const PolygonTiling& tiling, std::size_t prototile, bool mirrored)
{
    std::set<std::vector<RingPlace>> aspects;
    for (const PlacedTile& tile : tiling.unit) {
        if (tile.prototile != prototile || tile.motion.is_mirrored != mirrored) continue;
        std::vector<RingPlace> corners = corners_of(tiling, tile);
        std::ranges::sort(corners);
        for (std::size_t i = corners.size(); i-- > 0;) corners[i] = corners[i] - corners[0];
        aspects.insert(corners);
    }
    return aspects.size();
}

DistributionTable unit_table(const PolygonTiling& tiling, const TransitivityClasses& classes)
{
    DistributionTable table{"Tiles of a period", {"tile", "tiles", "aspects", "mirrored aspects", "classes"}, {}};
    for (std::size_t i = 0; i < tiling.prototiles.size(); ++i) {
        std::set<std::size_t> own;
        std::size_t count = 0;
        for (std::size_t t = 0; t < tiling.unit.size(); ++t) {
            if (tiling.unit[t].prototile != i) continue;
            ++count;
            own.insert(classes.tiles[t]);
        }
        table.rows.push_back({tiling.prototiles[i].name, fmt::format("{}", count),
                              fmt::format("{}", aspects_of(tiling, i, false)),
                              fmt::format("{}", aspects_of(tiling, i, true)), fmt::format("{}", own.size())});
    }
    return table;
}

/// Throws InputError where an area has more tiles than a picture may have.
void check_tile_count(const PolygonTiling& tiling, double area)
{
    double unit = 0;
    for (const PlacedTile& tile : tiling.unit) unit += area_of(tiling, tile.prototile);
    if (area / unit * static_cast<double>(tiling.unit.size()) > static_cast<double>(most_polygon_tiles))
        throw InputError(fmt::format("the window has more than {} tiles", most_polygon_tiles));
}

/// The tiles of a few periods, of which at least one has neighbours all around.
PatchSurvey periods_survey(const PolygonTiling& tiling)
{
    constexpr std::int64_t around = 2;
    std::vector<PlacedTile> tiles;
    for (std::int64_t first = -around; first <= around; ++first)
        for (std::int64_t second = -around; second <= around; ++second)
            for (PlacedTile tile : tiling.unit) {
                for (std::size_t i = 0; i < 4; ++i)
                    tile.motion.at.c[i] += first * tiling.period[0].c[i] + second * tiling.period[1].c[i];
                tiles.push_back(tile);
            }
    return survey_patch(tiling, tiles);
}

}

DistributionResult make_periodic(const PeriodicSettings& settings, DistributionFiles& files)
{
    const PolygonTiling tiling = tiling_of(settings.tiling);
    const double unit = picture_unit(tiling, 1);
    check_tile_count(tiling, settings.window[0] * settings.window[1] * unit * unit);
    const std::vector<RepeatedTile> found =
        repeated_tiles(tiling, settings.window[0] / 2 * unit, settings.window[1] / 2 * unit);
    std::vector<PlacedTile> tiles;
    for (const RepeatedTile& tile : found) tiles.push_back(tile.tile);
    const TransitivityClasses classes = transitivity_classes(tiling);
    DistributionResult result;
    result.facts = names_of(tiling);
    result.facts.emplace_back(classes.has_mirrors
                                  ? "reflections or glide reflections are among its symmetries"
                                  : "without reflections: there is a left-handed and a right-handed form");
    const auto number = [](std::size_t count) { return static_cast<double>(count); };
    result.numbers = {
        {"tile_classes", "Transitivity classes of tiles", number(classes.tile_classes), "1: the tiling is isohedral"},
        {"vertex_classes", "Transitivity classes of corners", number(classes.vertex_classes),
         "1, with regular polygons: the tiling is uniform"},
        {"symmetries", "Symmetries", number(classes.symmetries), "up to periods"}};
    const PatchSurvey survey = periods_survey(tiling);
    add_survey(result, survey);
    result.tables.push_back(unit_table(tiling, classes));
    result.tables.push_back(figure_table(survey));
    files.add_marks("tiling.json", periodic_picture(tiling, settings, tiles),
                    fmt::format("{} x {} sides of a square as large as the first tile{}.", settings.window[0],
                                settings.window[1], settings.shows_unit ? "; the dashed line is a period" : ""),
                    result);
    return result;
}

}
