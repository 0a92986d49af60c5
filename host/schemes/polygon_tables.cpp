#include "host/schemes/polygon_tables.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace poissonlab {

std::vector<std::string> names_of(const PolygonTiling& tiling)
{
    std::vector<std::string> names{tiling.title, tiling.source};
    std::erase(names, "");
    return names;
}

void add_survey(DistributionResult& result, const PatchSurvey& survey)
{
    const auto number = [](std::size_t count) { return static_cast<double>(count); };
    result.numbers.push_back({"inner_edges", "Edges between two tiles", number(survey.inner_edges), ""});
    result.numbers.push_back({"inner_vertices", "Vertices with tiles all around", number(survey.inner_vertices), ""});
    result.numbers.push_back({"overlaps", "Overlaps", number(survey.crowded_edges + survey.odd_vertices),
                              "edges with two tiles on one side, and vertices with more or less than a whole turn"});
    if (survey.labelled_edges > 0)
        result.numbers.push_back({"mismatches", "Mismatches", number(survey.unfit_edges),
                                  "edges at which two tiles break the matching condition"});
    result.facts.emplace_back(survey.is_edge_to_edge ? "tiles meet edge to edge"
                                                     : "corners of tiles lie within edges of others");
}

DistributionTable figure_table(const PatchSurvey& survey)
{
    constexpr std::size_t most_rows = 40;
    DistributionTable table{fmt::format("Vertices: {} kinds", survey.figures.size()), {"tiles around", "vertices"}, {}};
    for (const VertexFigure& figure : survey.figures) {
        if (table.rows.size() == most_rows) {
            table.title += fmt::format(", the {} most frequent ones", most_rows);
            break;
        }
        table.rows.push_back({figure.tiles, fmt::format("{}", figure.count)});
    }
    return table;
}

std::optional<WindowMiddle> window_middle(const PolygonTiling& tiling, const Substitution& substitution,
                                          const SubstitutionSettings& settings)
{
    constexpr double largest = 0x1p58; // the integers of a place stay below this
    TileAddress address(static_cast<std::size_t>(settings.depth) + 1);
    std::ranges::copy(settings.address, address.begin());
    const TileMotion tile = substitution.tile_at(address).motion;
    const double scale = scale_of(tiling.ring, tile);
    if (!settings.place) return WindowMiddle{tile.at, std::move(address), scale};
    const std::array<double, 2> point{(*settings.place)[0] * scale, (*settings.place)[1] * scale};
    if (std::hypot(point[0], point[1]) > largest) return std::nullopt;
    const RingPlace place = place_near(tiling, point);
    std::optional<AddressedTile> around = substitution.tile_around(settings.depth, place);
    if (!around) return std::nullopt;
    return WindowMiddle{place, std::move(around->address), scale};
}

std::size_t start_of(const PolygonTiling& tiling, const std::string& name)
{
    if (name.empty()) return 0;
    const auto found = std::ranges::find(tiling.starts, name, &StartPatch::name);
    if (found != tiling.starts.end()) return static_cast<std::size_t>(found - tiling.starts.begin());
    std::vector<std::string> names;
    for (const StartPatch& start : tiling.starts) names.push_back(start.name);
    throw InputError(fmt::format("must be one of {}", fmt::join(names, ", ")));
}

}
