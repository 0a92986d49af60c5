#include "host/config/tiling_request.hpp"

#include "base/errors/errors.hpp"
#include "host/config/aperiodic/aperiodic_tiles.hpp"
#include "tiles/tilings/scanline_tiling.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

std::vector<std::string> joined(std::vector<std::string> words, const std::vector<std::string>& more)
{
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

}

const std::vector<std::string>& tiling_algorithms(TileKind kind)
{
    static const std::vector<std::string> corner =
        joined({"direct", "scanline", "scanline-compact"}, aperiodic_tiling_words(TileKind::corner));
    static const std::vector<std::string> wang =
        joined({"edge-hash", "two-hashes", "one-hash", "scanline", "scanline-compact"},
               aperiodic_tiling_words(TileKind::wang));
    static const std::vector<std::string> cube{"direct"};
    return kind == TileKind::corner ? corner : kind == TileKind::wang ? wang : cube;
}

const std::vector<std::string>& tile_set_names(TileKind kind)
{
    static const std::vector<std::string> corner =
        joined({"complete", "compact"}, aperiodic_set_words(TileKind::corner));
    static const std::vector<std::string> wang =
        joined({"complete", "compact", "one-hash", "corner"}, aperiodic_set_words(TileKind::wang));
    static const std::vector<std::string> cube{"complete"};
    return kind == TileKind::corner ? corner : kind == TileKind::wang ? wang : cube;
}

bool TilingRequest::is_aperiodic() const { return is_aperiodic_word(kind, algorithm); }

Color own_colors(TileKind kind, const std::string& word)
{
    return is_aperiodic_word(kind, word) ? aperiodic_colors(word) : 0;
}

TileSet make_tile_set(TileKind kind, Color colors, const std::string& name)
{
    if (const Color own = own_colors(kind, name); own > 0) {
        if (colors != own) throw InputError(fmt::format("colors = {}: must be {} with {}", colors, own, name));
        return aperiodic_tile_set(kind, name);
    }
    if (name == "one-hash") return one_hash_wang_set(colors);
    if (name == "corner") return equivalent_wang_set(TileSet::complete(TileKind::corner, colors));
    if (name != "compact") return TileSet::complete(kind, colors);
    return kind == TileKind::corner ? compact_corner_set(colors) : compact_wang_set(colors);
}

TileSet tile_set_of(const TilingRequest& request)
{
    if (request.is_aperiodic()) return make_tile_set(request.kind, request.colors, request.algorithm);
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
    } else if (request.is_aperiodic()) {
        tile_set_of(request); // whose colours are checked
        const std::vector<TileIndex> tiles =
            aperiodic_window(request.algorithm, request.seed, {window.x, window.y, window.width, window.height});
        for (std::uint64_t row = 0; row < window.height; ++row)
            in_plane(window.x, window.y + static_cast<std::int64_t>(window.height - 1 - row),
                     std::span(tiles).subspan(row * window.width, window.width));
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
