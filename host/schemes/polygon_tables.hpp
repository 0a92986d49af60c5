// These tables and names are common to the results of all tilings by polygons: they say how tiles meet.
#pragma once

#include "host/schemes/scheme_settings.hpp"
#include "results/pictures/distribution_result.hpp"
#include "tiles/prototiles/patch_survey.hpp"
#include "tiles/prototiles/substitution.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// The most tiles of a picture.
inline constexpr std::size_t most_polygon_tiles = 50'000;

/// Returns the title of a tiling and its source; words that the tiling lacks are left out.
std::vector<std::string> names_of(const PolygonTiling& tiling);

/// Numbers of edges and vertices, and whether tiles fit.
void add_survey(DistributionResult& result, const PatchSurvey& survey);

/// The tiles around vertices, and how often.
DistributionTable figure_table(const PatchSurvey& survey);

/// The middle of a window: a place, the address of the tile there, and the scale of all tiles.
struct WindowMiddle
{
    RingPlace place;
    TileAddress address;
    double scale = 1;
};

/// Finds the middle of a window, or returns nothing if no tile lies at the place. Throws InputError for an address that
/// does not lead to a tile.
std::optional<WindowMiddle> window_middle(const PolygonTiling& tiling, const Substitution& substitution,
                                          const SubstitutionSettings& settings);

/// The number of a start by its name; the first one for an empty name. Throws InputError for a name that is none.
std::size_t start_of(const PolygonTiling& tiling, const std::string& name);

}
