#include "host/texture/texture_build.hpp"

#include "base/errors/errors.hpp"
#include "host/texture/corner_texture.hpp"
#include "host/texture/cross_texture.hpp"
#include "host/texture/wang_texture.hpp"

#include <fmt/format.h>

namespace poissonlab {

namespace {

/// The pixels of each tile by its sources.
std::vector<PngPixels> tiles_of_sources(const PngPixels& exemplar, const TextureSet& set)
{
    std::vector<PngPixels> tiles;
    for (std::size_t i = 0; i < set.tiles.size(); ++i) {
        const auto sources = set.sources_of(i);
        tiles.push_back(canvas_pixels(exemplar, {set.size, {sources.begin(), sources.end()}}));
    }
    return tiles;
}

void smooth(const PngPixels& exemplar, const TextureSources& made, const HarmonicSolver& solve,
            std::vector<PngPixels>& tiles)
{
    GradientDomain domain = made.bow_ties.shown.empty() ? gradient_domain(exemplar, tiles, made.middles)
                                                        : bow_tie_domain(exemplar, tiles[0].width, made.bow_ties);
    solve(domain);
    add_to_tiles(domain, tiles);
}

}

BuiltTexture build_texture(const TextureRequest& request, const PngPixels& exemplar, const PieceProgress& progress,
                           const HarmonicSolver& solve)
{
    check(request);
    const int width = narrowest_columns(exemplar, request.split);
    if (width < request.size || exemplar.height < request.size)
        throw InputError(fmt::format("size = {}: must be at most the exemplar's, {} x {} pixels", request.size, width,
                                     exemplar.height));
    BuiltTexture built;
    TextureSet& set = built.set;
    set.kind = request.kind;
    set.colors = request.set_colors();
    set.size = request.size;
    set.ring = request.ring_pixels();
    set.classes = request.classes();
    set.marked_column = request.split;
    set.is_smoothed = request.smooth;
    if (request.smooth && !request.has_corners()) set.ring = 1; // which is all that smoothing leaves alone there
    set.exemplar = exemplar;
    set.tiles = requested_tiles(request);
    set.parameters = parameters_of(request);

    const auto make = request.joint            ? make_joint_texture
                      : !request.has_corners() ? make_wang_texture
                      : request.stages == 0    ? make_cross_texture
                                               : make_corner_texture;
    TextureSources made = make(exemplar, request, set.tiles, progress);
    built.cost = made.cost;
    built.windows = std::move(made.windows);
    built.patches = made.patches;
    built.notes = std::move(made.notes);
    set.sources = std::move(made.sources);
    std::vector<PngPixels> tiles = tiles_of_sources(exemplar, set);
    if (request.smooth) smooth(exemplar, made, solve, tiles);
    for (const PngPixels& tile : tiles) set.values.insert(set.values.end(), tile.values.begin(), tile.values.end());
    return built;
}

}
