#include "host/config/tiling_request.hpp"

#include "base/errors/errors.hpp"
#include "tiles/tilings/scanline_tiling.hpp"

#include <fmt/format.h>

namespace poissonlab {

const std::vector<std::string>& tiling_algorithms(TileKind kind)
{
    static const std::vector<std::string> corner{"direct", "scanline", "scanline-compact"};
    static const std::vector<std::string> wang{"edge-hash", "two-hashes", "one-hash", "scanline", "scanline-compact"};
    static const std::vector<std::string> cube{"direct"};
    return kind == TileKind::corner ? corner : kind == TileKind::wang ? wang : cube;
}

const std::vector<std::string>& tile_set_names(TileKind kind)
{
    static const std::vector<std::string> corner{"complete", "compact"};
    static const std::vector<std::string> wang{"complete", "compact", "one-hash", "corner"};
    static const std::vector<std::string> cube{"complete"};
    return kind == TileKind::corner ? corner : kind == TileKind::wang ? wang : cube;
}

TileSet make_tile_set(TileKind kind, Color colors, const std::string& name)
{
    if (name == "one-hash") return one_hash_wang_set(colors);
    if (name == "corner") return equivalent_wang_set(TileSet::complete(TileKind::corner, colors));
    if (name != "compact") return TileSet::complete(kind, colors);
    return kind == TileKind::corner ? compact_corner_set(colors) : compact_wang_set(colors);
}

TileSet tile_set_of(const TilingRequest& request)
{
    if (request.algorithm == "scanline-compact") return make_tile_set(request.kind, request.colors, "compact");
    if (request.algorithm == "one-hash") return make_tile_set(request.kind, request.colors, "one-hash");
    return TileSet::complete(request.kind, request.colors);
}

Tiling make_direct_tiling(const TilingRequest& request)
{
    DirectAlgorithm algorithm = DirectAlgorithm::corner;
    if (request.algorithm == "two-hashes") algorithm = DirectAlgorithm::wang_two_hashes;
    if (request.algorithm == "one-hash") algorithm = DirectAlgorithm::wang_one_hash;
    if (request.algorithm == "edge-hash") algorithm = DirectAlgorithm::wang_edge_hash;
    return Tiling(algorithm, {request.colors, request.colors}, request.hash, request.seed, request.period);
}

void stream_tiles(const TilingRequest& request, const CubeWindow& window, const CubeSink& sink)
{
    const auto in_plane = [&](std::int64_t x, std::int64_t y, std::span<const TileIndex> tiles) {
        sink(x, y, window.z, tiles);
    };
    if (request.kind == TileKind::cube) {
        CubeTiling(request.colors, request.hash, request.seed, request.period).stream(window, sink);
    } else if (request.is_scanline()) {
        if (window.x != 0 || window.y != 0)
            throw InputError(fmt::format("a window at {} {}: with the algorithm {}, X and Y must be 0", window.x,
                                         window.y, request.algorithm));
        ScanlineTiling(tile_set_of(request), window.width, request.seed).stream(window.height, in_plane);
    } else {
        make_direct_tiling(request).stream({window.x, window.y, window.width, window.height}, in_plane);
    }
}

}
