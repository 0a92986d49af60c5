// poissonlab tiling: the tile indices of a window of a stochastic tiling.
#include "app/commands/commands.hpp"
#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "host/config/nearest_key.hpp"
#include "host/config/tiling_request.hpp"

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
        throw InputError(fmt::format("tiling: {} \"{}\": unknown{} (known: {})", what, name, did_you_mean(name, known),
                                     fmt::join(known, ", ")));
    return static_cast<std::size_t>(found - known.begin());
}

/// The options, checked.
struct Request
{
    TilingRequest tiling;
    CubeWindow window;
};

CubeWindow checked_window(const std::vector<std::int64_t>& numbers, std::size_t axes)
{
    if (numbers.size() != 2 * axes)
        throw InputError(fmt::format("tiling: --window {}: must be {}", fmt::join(numbers, " "),
                                     axes == 3 ? "X Y Z W H D" : "X Y W H"));
    for (std::size_t axis = 0; axis < axes; ++axis)
        if (numbers[axes + axis] < 1)
            throw InputError(fmt::format("tiling: --window {}: sizes must be at least 1", fmt::join(numbers, " ")));
    const auto size = [&](std::size_t axis) { return static_cast<std::uint64_t>(numbers[axes + axis]); };
    return {numbers[0], numbers[1], axes == 3 ? numbers[2] : 0, size(0), size(1), axes == 3 ? size(2) : 1};
}

Request checked(const TilingOptions& options)
{
    TilingRequest tiling;
    choice("kind", options.kind, tile_kinds.all());
    tiling.kind = *tile_kinds.find(options.kind);
    tiling.colors = options.colors;
    tiling.seed = options.seed;
    const auto& algorithms = tiling_algorithms(tiling.kind);
    tiling.algorithm = options.algorithm.empty() ? algorithms.front() : options.algorithm;
    choice("--algorithm", tiling.algorithm, algorithms);
    if (!options.hash.empty()) tiling.hash = static_cast<HashKind>(choice("--hash", options.hash, hash_names()));
    const std::size_t axes = tiling.kind == TileKind::cube ? 3 : 2;
    const CubeWindow window = checked_window(options.window, axes);
    if (options.period.size() > axes)
        throw InputError(fmt::format("tiling: --period {}: there are {} axes", fmt::join(options.period, " "), axes));
    for (std::size_t i = 0; i < options.period.size(); ++i)
        (i == 0 ? tiling.period.x : i == 1 ? tiling.period.y : tiling.period.z) = options.period[i];
    if (tiling.is_scanline() && (!options.hash.empty() || !options.period.empty()))
        throw InputError("tiling: --algorithm " + tiling.algorithm + ": has no --hash and no --period");
    if (tiling.is_scanline() && (window.x != 0 || window.y != 0))
        throw InputError(fmt::format("tiling: --window {}: with --algorithm {}, X and Y must be 0",
                                     fmt::join(options.window, " "), tiling.algorithm));
    return {tiling, window};
}

/// Prints indices with blanks between them and, after the last of a row, ends the line.
void print_tiles(std::span<const TileIndex> tiles, bool ends_row)
{
    stop_if_interrupted();
    const std::string text = fmt::format("{}{}", fmt::join(tiles, " "), ends_row ? "\n" : " ");
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size())
        throw StorageError("cannot write to standard output");
}

}

void tiling_command(const TilingOptions& options)
{
    const auto [tiling, window] = checked(options);
    const std::int64_t end = stepped(window.x, window.width);
    std::int64_t layer = window.z;
    stream_tiles(tiling, window, [&](std::int64_t x, std::int64_t, std::int64_t z, std::span<const TileIndex> tiles) {
        if (z != layer) fmt::print("\n");
        layer = z;
        print_tiles(tiles, stepped(x, tiles.size()) == end);
    });
}

}
