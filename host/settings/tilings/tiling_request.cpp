#include "host/settings/tilings/tiling_request.hpp"

#include "base/errors/errors.hpp"
#include "host/settings/tilings/aperiodic_tiles.hpp"
#include "tiles/packing/tile_packing.hpp"
#include "tiles/tilings/scanline_tiling.hpp"

#include <fmt/format.h>

#include <limits>
#include <numeric>

namespace poissonlab {
namespace {

std::vector<std::string> joined(std::vector<std::string> words, const std::vector<std::string>& more)
{
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

/// The period of two functions together; 0 is none.
std::uint64_t common_period(std::uint64_t a, std::uint64_t b)
{
    if (a == 0 || b == 0) return 0;
    const std::uint64_t factor = b / std::gcd(a, b);
    return factor > std::numeric_limits<std::uint64_t>::max() / a ? 0 : a * factor;
}

void stream_given(const TilingRequest& request, const CubeWindow& window, const CubeSink& sink)
{
    const std::uint64_t width = request.given_width, height = request.given.size() / width;
    const auto is_inside = [](std::int64_t first, std::uint64_t size, std::uint64_t all) {
        return first >= 0 && size <= all && static_cast<std::uint64_t>(first) <= all - size;
    };
    if (!is_inside(window.x, window.width, width) || !is_inside(window.y, window.height, height))
        throw InputError(fmt::format("a window of {} x {} tiles at {} {}: {} x {} are given", window.width,
                                     window.height, window.x, window.y, width, height));
    for (std::uint64_t row = window.height; row-- > 0;) {
        const std::uint64_t y = static_cast<std::uint64_t>(window.y) + row;
        sink(window.x, static_cast<std::int64_t>(y), window.z,
             std::span(request.given)
                 .subspan((height - 1 - y) * width + static_cast<std::uint64_t>(window.x), window.width));
    }
}

}

const std::vector<std::string>& tiling_algorithms(TileKind kind)
{
    static const std::vector<std::string> corner =
        joined({"direct", "scanline", "scanline-compact"}, aperiodic_tiling_words(TileKind::corner));
    static const std::vector<std::string> wang =
        joined({"edge-hash", "two-hashes", "one-hash", "scanline", "scanline-compact"},
               aperiodic_tiling_words(TileKind::wang));
    static const std::vector<std::string> wang_cube{"face-hash", "scanline", "scanline-compact"};
    static const std::vector<std::string> others{"direct"};
    return kind == TileKind::corner      ? corner
           : kind == TileKind::wang      ? wang
           : kind == TileKind::wang_cube ? wang_cube
                                         : others;
}

const std::vector<std::string>& tile_set_names(TileKind kind)
{
    static const std::vector<std::string> corner =
        joined({"complete", "compact"}, aperiodic_set_words(TileKind::corner));
    static const std::vector<std::string> wang =
        joined({"complete", "compact", "one-hash", "corner"}, aperiodic_set_words(TileKind::wang));
    static const std::vector<std::string> wang_cube{"complete", "compact"};
    static const std::vector<std::string> others{"complete"};
    return kind == TileKind::corner      ? corner
           : kind == TileKind::wang      ? wang
           : kind == TileKind::wang_cube ? wang_cube
                                         : others;
}

bool TilingRequest::is_aperiodic() const { return is_aperiodic_word(kind, algorithm); }

Color own_colors(TileKind kind, const std::string& word)
{
    return is_aperiodic_word(kind, word) ? aperiodic_colors(word) : 0;
}

TileSet make_tile_set(TileKind kind, WangColors colors, const std::string& name)
{
    const Color horizontal = colors.horizontal;
    if (name != "complete" && name != "compact" && colors.vertical != horizontal)
        throw invalid_value({}, "vertical_colors", fmt::format("{}", colors.vertical),
                            fmt::format("must be {}, as colors is, with {}", horizontal, name));
    if (const Color own = own_colors(kind, name); own > 0) {
        if (horizontal != own)
            throw invalid_value({}, "colors", fmt::format("{}", horizontal),
                                fmt::format("must be {} with {}", own, name));
        return aperiodic_tile_set(kind, name);
    }
    if (name == "one-hash") return one_hash_wang_set(horizontal);
    if (name == "corner") return equivalent_wang_set(TileSet::complete(TileKind::corner, horizontal));
    if (name != "compact") return TileSet::complete(kind, colors);
    if (kind == TileKind::wang_cube) return compact_wang_cube_set(horizontal);
    return kind == TileKind::corner ? compact_corner_set(horizontal) : compact_wang_set(colors);
}

TileSet tile_set_of(const TilingRequest& request)
{
    std::string name = "complete";
    if (request.is_aperiodic()) name = request.algorithm;
    if (request.algorithm == "scanline-compact") name = "compact";
    if (request.algorithm == "one-hash") name = "one-hash";
    return make_tile_set(request.kind, request.all_colors(), name);
}

void check_given_tiles(const TilingRequest& request)
{
    const WangColors colors = request.all_colors();
    const TileSet set = TileSet::complete(request.kind, colors);
    const auto place = [&](std::size_t tile) {
        return fmt::format("row {}, column {}", tile / request.given_width + 1, tile % request.given_width + 1);
    };
    for (std::size_t i = 0; i < request.given.size(); ++i) {
        if (request.given[i] >= set.size())
            throw InputError(
                fmt::format("indices: {} in {}: must be less than {}", request.given[i], place(i), set.size()));
        if (i % request.given_width > 0 && !fits_east(request.kind, colors, request.given[i - 1], request.given[i]))
            throw InputError(
                fmt::format("indices: {} in {}: does not fit to the tile to the west", request.given[i], place(i)));
        if (i >= request.given_width &&
            !fits_north(request.kind, colors, request.given[i], request.given[i - request.given_width]))
            throw InputError(
                fmt::format("indices: {} in {}: does not fit to the tile to the north", request.given[i], place(i)));
    }
}

HashPeriod hash_period_of(const TilingRequest& request)
{
    if (axes_of(request.kind) != 2)
        return period_of(make_color_hash(request.hash_choice(), request.colors, request.seed));
    const Tiling tiling = make_direct_tiling(request);
    const HashPeriod first = period_of(tiling.hash()), second = period_of(tiling.vertical_hash());
    return {common_period(first.x, second.x), common_period(first.y, second.y)};
}

Tiling make_direct_tiling(const TilingRequest& request)
{
    DirectAlgorithm algorithm = DirectAlgorithm::corner;
    if (request.algorithm == "two-hashes") algorithm = DirectAlgorithm::wang_two_hashes;
    if (request.algorithm == "one-hash") algorithm = DirectAlgorithm::wang_one_hash;
    if (request.algorithm == "edge-hash") algorithm = DirectAlgorithm::wang_edge_hash;
    return Tiling(algorithm, request.all_colors(), request.hash_choice(), request.seed, request.period);
}

void stream_tiles(const TilingRequest& request, const CubeWindow& window, const CubeSink& sink)
{
    const auto in_plane = [&](std::int64_t x, std::int64_t y, std::span<const TileIndex> tiles) {
        sink(x, y, window.z, tiles);
    };
    if (request.is_scanline() && (window.x != 0 || window.y != 0 || window.z != 0))
        throw InputError(fmt::format("a window at {} {}: with the algorithm {}, {} must be 0", window.x, window.y,
                                     request.algorithm, axes_of(request.kind) == 3 ? "X, Y and Z" : "X and Y"));
    if (request.kind == TileKind::wang_cube && request.is_scanline()) {
        const TileSet set = tile_set_of(request); // whose colours are checked
        stream_scanline_cubes(request.colors, !set.is_complete(), request.seed, window.width, window.height,
                              window.depth, sink);
    } else if (axes_of(request.kind) == 3) {
        CubeTiling(request.colors, request.hash_choice(), request.seed, request.period, request.kind)
            .stream(window, sink);
    } else if (request.kind == TileKind::domino && request.is_direct()) {
        DominoTiling(request.colors, request.hash_choice(), request.seed, request.period.x).stream(window, sink);
    } else if (request.is_given()) {
        stream_given(request, window, sink);
    } else if (request.is_aperiodic()) {
        tile_set_of(request); // whose colours are checked
        const std::vector<TileIndex> tiles =
            aperiodic_window(request.algorithm, request.seed, {window.x, window.y, window.width, window.height});
        for (std::uint64_t row = 0; row < window.height; ++row)
            in_plane(window.x, window.y + static_cast<std::int64_t>(window.height - 1 - row),
                     std::span(tiles).subspan(row * window.width, window.width));
    } else if (request.is_scanline()) {
        ScanlineTiling(tile_set_of(request), window.width, request.seed).stream(window.height, in_plane);
    } else {
        make_direct_tiling(request).stream({window.x, window.y, window.width, window.height}, in_plane);
    }
}

}
