#include "host/texture/texture_build.hpp"

#include "base/errors/errors.hpp"
#include "host/texture/corner_texture.hpp"
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

void smooth(const PngPixels& exemplar, const std::vector<FittedPiece>& pieces, const HarmonicSolver& solve,
            std::vector<PngPixels>& tiles)
{
    GradientDomain domain = gradient_domain(exemplar, tiles, pieces);
    solve(domain);
    add_to_tiles(domain, tiles);
}

}

BuiltTexture build_texture(const TextureRequest& request, const PngPixels& exemplar, const PieceProgress& progress,
                           const HarmonicSolver& solve)
{
    check(request);
    if (exemplar.width < request.size || exemplar.height < request.size)
        throw InputError(fmt::format("size = {}: must be at most the exemplar's, {} x {} pixels", request.size,
                                     exemplar.width, exemplar.height));
    BuiltTexture built;
    TextureSet& set = built.set;
    set.kind = request.kind;
    set.colors = request.colors;
    set.size = request.size;
    set.ring = request.ring_pixels();
    set.is_smoothed = request.smooth;
    set.exemplar = exemplar;
    set.tiles = requested_tiles(request);
    set.parameters = parameters_of(request);

    const auto make = request.has_corners() ? make_corner_texture : make_wang_texture;
    TextureSources made = make(exemplar, request, set.tiles, progress);
    built.cost = made.cost;
    built.windows = std::move(made.windows);
    set.sources = std::move(made.sources);
    std::vector<PngPixels> tiles = tiles_of_sources(exemplar, set);
    if (request.smooth) smooth(exemplar, made.middles, solve, tiles);
    for (const PngPixels& tile : tiles) set.values.insert(set.values.end(), tile.values.begin(), tile.values.end());
    return built;
}

}
