// poissonlab tiling: the tile indices of a window of a stochastic tiling.
#include "errors/errors.hpp"
#include "experiment/commands/commands.hpp"
#include "experiment/interrupt.hpp"
#include "experiment/nearest_key.hpp"
#include "tiles/cube_tiling.hpp"
#include "tiles/scanline_tiling.hpp"
#include "tiles/tiling.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>

namespace poissonlab {
namespace {

/// The number of a name in a list. Throws InputError for names that are not there.
std::size_t choice(const std::string& what, const std::string& name, const std::vector<std::string>& known)
{
    const auto found = std::ranges::find(known, name);
    if (found == known.end())
        throw InputError(fmt::format("tiling: {} \"{}\": unknown{} (known: {})", what, name,
                                     did_you_mean(name, known), fmt::join(known, ", ")));
    return static_cast<std::size_t>(found - known.begin());
}

/// The algorithms of a kind, the default first.
const std::vector<std::string>& algorithms_of(TileKind kind)
{
    static const std::vector<std::string> corner{"direct", "scanline", "scanline-compact"};
    static const std::vector<std::string> wang{"edge-hash", "two-hashes", "one-hash", "scanline",
                                               "scanline-compact"};
    static const std::vector<std::string> cube{"direct"};
    return kind == TileKind::corner ? corner : kind == TileKind::wang ? wang : cube;
}

/// The options, checked.
struct Request
{
    TileKind kind;
    std::string algorithm;
    HashKind hash;
    Period period;
};

Request checked(const TilingOptions& options)
{
    constexpr TileKind kinds[] = {TileKind::corner, TileKind::wang, TileKind::cube};
    Request request{kinds[choice("kind", options.kind, {"corner", "wang", "cube"})],
                    options.algorithm,
                    HashKind::long_period,
                    {}};
    const std::size_t axes = request.kind == TileKind::cube ? 3 : 2;
    const auto& algorithms = algorithms_of(request.kind);
    if (request.algorithm.empty()) request.algorithm = algorithms.front();
    choice("--algorithm", request.algorithm, algorithms);
    if (!options.hash.empty())
        request.hash = static_cast<HashKind>(choice("--hash", options.hash, hash_names()));
    if (options.window.size() != 2 * axes)
        throw InputError(fmt::format("tiling: --window {}: must be {}", fmt::join(options.window, " "),
                                     axes == 3 ? "X Y Z W H D" : "X Y W H"));
    for (std::size_t axis = 0; axis < axes; ++axis) {
        if (options.window[axes + axis] < 1)
            throw InputError(
                fmt::format("tiling: --window {}: sizes must be at least 1", fmt::join(options.window, " ")));
    }
    if (options.period.size() > axes)
        throw InputError(
            fmt::format("tiling: --period {}: there are {} axes", fmt::join(options.period, " "), axes));
    for (std::size_t i = 0; i < options.period.size(); ++i)
        (i == 0 ? request.period.x : i == 1 ? request.period.y : request.period.z) = options.period[i];
    return request;
}

/// Prints indices with blanks between them and, after the last of a row, ends the line.
void print_tiles(std::span<const TileIndex> tiles, bool ends_row)
{
    stop_if_interrupted();
    const std::string text = fmt::format("{}{}", fmt::join(tiles, " "), ends_row ? "\n" : " ");
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size())
        throw StorageError("cannot write to standard output");
}

void print_scanline(const Request& request, const TilingOptions& options)
{
    if (!options.hash.empty() || !options.period.empty())
        throw InputError("tiling: --algorithm " + request.algorithm + ": has no --hash and no --period");
    if (options.window[0] != 0 || options.window[1] != 0)
        throw InputError(fmt::format("tiling: --window {}: with --algorithm {}, X and Y must be 0",
                                     fmt::join(options.window, " "), request.algorithm));
    const bool is_complete = request.algorithm == "scanline";
    const TileSet set = is_complete                        ? TileSet::complete(request.kind, options.colors)
                        : request.kind == TileKind::corner ? compact_corner_set(options.colors)
                                                           : compact_wang_set(options.colors);
    ScanlineTiling tiling(set, static_cast<std::uint64_t>(options.window[2]), options.seed);
    tiling.stream(static_cast<std::uint64_t>(options.window[3]),
                  [](auto, auto, std::span<const TileIndex> tiles) { print_tiles(tiles, true); });
}

void print_direct(const Request& request, const TilingOptions& options)
{
    DirectAlgorithm algorithm = DirectAlgorithm::corner;
    if (request.algorithm == "two-hashes") algorithm = DirectAlgorithm::wang_two_hashes;
    if (request.algorithm == "one-hash") algorithm = DirectAlgorithm::wang_one_hash;
    if (request.algorithm == "edge-hash") algorithm = DirectAlgorithm::wang_edge_hash;
    const Tiling tiling(algorithm, {options.colors, options.colors}, request.hash, options.seed,
                        request.period);
    const auto& w = options.window;
    const TileWindow window{w[0], w[1], static_cast<std::uint64_t>(w[2]), static_cast<std::uint64_t>(w[3])};
    const std::int64_t end = stepped(window.x, window.width);
    tiling.stream(window, [&](std::int64_t x, std::int64_t, std::span<const TileIndex> tiles) {
        print_tiles(tiles, stepped(x, tiles.size()) == end);
    });
}

void print_cubes(const Request& request, const TilingOptions& options)
{
    const CubeTiling tiling(options.colors, request.hash, options.seed, request.period);
    const auto& w = options.window;
    const CubeWindow window{w[0],
                            w[1],
                            w[2],
                            static_cast<std::uint64_t>(w[3]),
                            static_cast<std::uint64_t>(w[4]),
                            static_cast<std::uint64_t>(w[5])};
    const std::int64_t end = stepped(window.x, window.width);
    std::int64_t layer = window.z;
    tiling.stream(window,
                  [&](std::int64_t x, std::int64_t, std::int64_t z, std::span<const TileIndex> cubes) {
                      if (z != layer) fmt::print("\n");
                      layer = z;
                      print_tiles(cubes, stepped(x, cubes.size()) == end);
                  });
}

}

void tiling_command(const TilingOptions& options)
{
    const Request request = checked(options);
    if (request.kind == TileKind::cube) return print_cubes(request, options);
    if (request.algorithm.starts_with("scanline")) return print_scanline(request, options);
    print_direct(request, options);
}

}
