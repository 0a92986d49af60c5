// poissonlab tiling: the tile indices of a window of a stochastic tiling.
#include "app/commands/command.hpp"
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

constexpr auto tiling_notes =
    R"(Prints tile indices, a row of tiles a line, north first; cubes: layer after layer from the bottom, with an empty
line between them. A tile's coordinates are those of its lower left corner; they may be negative, of 64 bits.
An index is the number whose digits are the colours: N E S W (wang), NE SE SW NW (corner); the same at the top and
then at the bottom (cube); N E S W top bottom (wang-cube); E W (domino).
  corner  direct; scanline, scanline-compact; culik-diagonal and the like
  wang    edge-hash, two-hashes, one-hash (a compact set); scanline, scanline-compact; culik, kari, ammann
  cube, domino  direct
  wang-cube     face-hash
Names of aperiodic sets are those of `poissonlab aperiodic`; --colors must be theirs.
Scanline tilings start at their north-west tile; the window must be at 0 0.
--hash long-period (repeats after 5,930,659,848 tiles), permutation (256; the fastest), xxh64 (never repeats);
with edge-hash, after half as many.
  poissonlab tiling corner --colors 3 --window -4 -4 8 8)";

struct TilingOptions
{
    std::string kind; ///< a word of tile_kinds
    std::uint32_t colors = 0;
    std::uint32_t vertical_colors = 0; ///< 0: as many as `colors`
    std::string algorithm;             ///< empty: the kind's first
    std::string hash;                  ///< empty: long-period
    std::uint64_t seed = 1;
    std::vector<std::int64_t> window; ///< X Y W H; cubes: X Y Z W H D; dominoes: X W
    std::vector<std::int64_t> period; ///< of x, y, z; those that are missing are 0: none
};

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
                                     axes == 1   ? "X W"
                                     : axes == 2 ? "X Y W H"
                                                 : "X Y Z W H D"));
    for (std::size_t axis = 0; axis < axes; ++axis)
        if (numbers[axes + axis] < 1)
            throw InputError(fmt::format("tiling: --window {}: sizes must be at least 1", fmt::join(numbers, " ")));
    const auto first = [&](std::size_t axis) { return axis < axes ? numbers[axis] : 0; };
    const auto size = [&](std::size_t axis) {
        return axis < axes ? static_cast<std::uint64_t>(numbers[axes + axis]) : 1;
    };
    return {first(0), first(1), first(2), size(0), size(1), size(2)};
}

Request checked(const TilingOptions& options)
{
    TilingRequest tiling;
    choice("kind", options.kind, tile_kinds.all());
    tiling.kind = *tile_kinds.find(options.kind);
    tiling.colors = options.colors;
    if (options.vertical_colors > 0 && tiling.kind != TileKind::wang)
        throw InputError("tiling: --vertical-colors: is for wang tiles only");
    tiling.vertical_colors = options.vertical_colors;
    tiling.seed = options.seed;
    const auto& algorithms = tiling_algorithms(tiling.kind);
    tiling.algorithm = options.algorithm.empty() ? algorithms.front() : options.algorithm;
    choice("--algorithm", tiling.algorithm, algorithms);
    if (!options.hash.empty()) tiling.hash = static_cast<HashKind>(choice("--hash", options.hash, hash_names()));
    const std::size_t axes = axes_of(tiling.kind);
    const CubeWindow window = checked_window(options.window, axes);
    if (options.period.size() > axes)
        throw InputError(fmt::format("tiling: --period {}: there {}", fmt::join(options.period, " "),
                                     axes == 1 ? "is 1 axis" : fmt::format("are {} axes", axes)));
    for (std::size_t i = 0; i < options.period.size(); ++i)
        (i == 0 ? tiling.period.x : i == 1 ? tiling.period.y : tiling.period.z) = options.period[i];
    if (!tiling.is_direct() && (!options.hash.empty() || !options.period.empty()))
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

void print_tiling(const TilingOptions& options)
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

Command tiling_command()
{
    const auto o = std::make_shared<TilingOptions>();
    return {
        "tiling",
        "Print the tile indices of a stochastic tiling",
        {{"KIND", &o->kind, "corner, wang, cube, wang-cube or domino"},
         allowing({"--colors", &o->colors, "Number of colours", "C", required}, integers(2, max_colors)),
         allowing({"--vertical-colors", &o->vertical_colors, "Of the vertical edges of Wang tiles; default: C", "CV"},
                  integers(2, max_colors)),
         {"--algorithm", &o->algorithm, "How tiles are chosen, see below; default: the first", "NAME"},
         {"--hash", &o->hash, "What gives lattice points their colours; default: long-period", "NAME"},
         {"--seed", &o->seed, "Everything random follows from it; default: 1", "S"},
         {"--window", &o->window, "The tiles to print: lower left one, width and height",
          "X Y W H (cubes: X Y Z W H D; dominoes: X W)", required, 6},
         {"--period", &o->period, "The tiling closes after so many tiles; 0: it does not", "MX [MY [MZ]]", optional,
          3}},
        tiling_notes,
        action_on(o, print_tiling)};
}

}
