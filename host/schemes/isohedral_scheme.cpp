// kind = "isohedral": a tiling of a type with its parameters, its curves and a colouring.
//
// Kaplan, Introductory Tiling Theory for Computer Graphics, 2009 (SIGGRAPH 2008 class notes, II, section 7).
#include "host/schemes/isohedral_picture.hpp"
#include "host/schemes/scheme_run.hpp"

namespace poissonlab {
namespace {

/// Tiles that a path divides: of light and dark parts.
MarkPicture split_picture(const IsohedralTile& tile, const IsohedralSettings& settings, DistributionResult& result)
{
    const SplitTile split = split_tile(tile, *settings.split);
    const double whole = area_of(tile.outline());
    result.numbers.push_back({"edges_alike", "Edges between tiles of one shape", static_cast<double>(split.alike),
                              "of all aspects, from both sides; 0: a Heaven and Hell pattern"});
    result.numbers.push_back({"light_share", "Share of light tiles", area_of(split.parts[0]) / whole, "of the plane"});
    result.facts.emplace_back(split.alike == 0
                                  ? "a Heaven and Hell pattern: only tiles of different shapes have edges in common"
                                  : "some tiles of one shape have an edge in common");
    const TileParts parts{{split.parts[0], "#f6efdc"}, {split.parts[1], "#2f4a6d"}};
    return tiling_picture(tile, window_of(settings), [&](const TilePlace&) { return parts; });
}

}

DistributionResult make_isohedral(const IsohedralSettings& settings, std::uint64_t seed, DistributionFiles& files)
{
    if (!settings.goal.empty()) return make_goal_tiling(settings, files);
    const IsohedralType& type = type_of(settings);
    const IsohedralTile tile = tile_of(settings, seed);
    const TileColoring coloring = settings.coloring ? *settings.coloring : proper_coloring(tile);
    DistributionResult result;
    describe(type, tile, result);
    if (!settings.split) { // parts have colours of their own
        result.facts.emplace_back(is_proper(tile, coloring) ? "neighbours differ in colour"
                                                            : "some neighbours have the same colour");
        result.facts.emplace_back(is_perfect(tile, coloring) ? "a perfect colouring: symmetries permute colours"
                                                             : "not a perfect colouring");
    }
    result.numbers.insert(result.numbers.begin(), {"colors", "Colours", settings.split ? 2.0 : coloring.colors, ""});
    const MarkPicture picture = settings.split ? split_picture(tile, settings, result)
                                               : tiling_picture(tile, window_of(settings), [&](const TilePlace& place) {
                                                     return TileParts{{tile.outline(), tile_color(coloring.of(place))}};
                                                 });
    files.add_marks("tiling.json", picture, window_of(settings).caption(), result);
    return result;
}

}
