// The kinds of [[scheme]] that show how tilings are made, step by step, and what they cost.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, chapters 2 and 3.
#include "host/kinds/kinds.hpp"
#include "host/schemes/scheme_run.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
namespace {

constexpr std::int64_t most_scheme_colors = 5; // those that the papers have names for
constexpr std::int64_t most_scheme_tiles = 16; // along each axis of a picture

void scheme_colors(Keys& keys, Color& colors, std::int64_t most = most_scheme_colors)
{
    keys.integer("colors", colors, 2, most, "the number of colours");
}

void corner_problem_keys(Keys& keys, CornerProblemSettings& s)
{
    constexpr std::int64_t most_compared_colors = 4; // pairs of their tiles are counted one by one
    scheme_colors(keys, s.colors, most_compared_colors);
}

void scanline_keys(Keys& keys, ScanlineStepsSettings& s)
{
    static constexpr WordTable<TileKind, 2> kinds{{{{TileKind::wang, "wang"}, {TileKind::corner, "corner"}}}};
    static constexpr WordTable<bool, 2> sets{{{{true, "compact"}, {false, "complete"}}}};
    keys.word("tiles", s.tiles, kinds, "the kind of tiles");
    scheme_colors(keys, s.colors);
    keys.word("set", s.is_compact, sets, "which tiles there are");
}

std::string scanline_label(const ScanlineStepsSettings& s)
{
    return fmt::format("{} placed by scanlines, {} set over {} colours",
                       s.tiles == TileKind::wang ? "Wang tiles" : "Corner tiles", s.is_compact ? "compact" : "complete",
                       s.colors);
}

void direct_keys(Keys& keys, DirectTilingSettings& s)
{
    TilingRequest& request = s.request;
    keys.word("algorithm", request.algorithm, {"direct", "two-hashes", "one-hash", "edge-hash"},
              "how colours become tiles");
    request.kind = request.algorithm == "direct" ? TileKind::corner : TileKind::wang;
    scheme_colors(keys, request.colors);
    std::string hash = hash_names()[static_cast<std::size_t>(request.hash)];
    keys.word("hash", hash, hash_names(), "what gives lattice points their colours");
    request.hash = static_cast<HashKind>(std::ranges::find(hash_names(), hash) - hash_names().begin());
    std::vector<std::int64_t> w{0, 0, 4, 3};
    keys.whole_numbers("window", w, -any_integer - 1, {"X", "Y", "width", "height"}, "the tiles that are drawn");
    const auto fits = [](std::int64_t size) { return size >= 1 && size <= most_scheme_tiles; };
    if (!fits(w[2]) || !fits(w[3]))
        throw keys.invalid("window", fmt::format("must be of 1 to {} tiles along each axis", most_scheme_tiles));
    s.window = {w[0], w[1], static_cast<std::uint64_t>(w[2]), static_cast<std::uint64_t>(w[3])};
}

std::string direct_label(const DirectTilingSettings& s)
{
    return fmt::format("From a coloured lattice to {}: {}", tile_kind_words(s.request.kind), s.request.algorithm);
}

void noise_keys(Keys& keys, NoiseSettings& s)
{
    keys.integer("pixels", s.pixels, 16, 2048, "the side of the pictures");
    keys.integer("cells", s.cells, 1, 256, "of the lattice, along each side");
}

void cost_keys(Keys& keys, TilingCostSettings& s)
{
    scheme_colors(keys, s.colors, 8);
    keys.integer("tiles", s.tiles, 4096, 1 << 24, "of each measurement");
}

}

Kind corner_problem_kind()
{
    return make_kind<CornerProblemSettings>(
        {"scheme", "corner-problem", "", "The corner problem", "Draw what lies diagonally to a tile, and count it",
         false},
        corner_problem_keys, [](const CornerProblemSettings&) { return std::string("The corner problem"); },
        make_corner_problem);
}

Kind scanline_steps_kind()
{
    return make_kind<ScanlineStepsSettings>(
        {"scheme", "scanline", "", "Scanlines", "Draw the scanline algorithm at work", false}, scanline_keys,
        scanline_label, make_scanline_steps);
}

Kind direct_scheme_kind()
{
    return make_kind<DirectTilingSettings>(
        {"scheme", "direct", "", "Direct tilings", "Draw the colours of a lattice, and the tiles that they become",
         false},
        direct_keys, direct_label, [](const DirectTilingSettings& s, std::uint64_t seed, DistributionFiles& files) {
            DirectTilingSettings own = s;
            own.request.seed = seed;
            return make_direct_scheme(own, files);
        });
}

Kind noise_kind()
{
    return make_kind<NoiseSettings>(
        {"scheme", "noise", "", "Noise", "Draw Perlin's noise with the hash functions of tilings", false}, noise_keys,
        [](const NoiseSettings&) { return std::string("Perlin's noise with two hash functions"); }, make_noise);
}

Kind tiling_cost_kind()
{
    return make_kind<TilingCostSettings>(
        {"scheme", "tiling-costs", "", "Costs of tilings", "Count hash evaluations, and measure times, a tile", false},
        cost_keys, [](const TilingCostSettings& s) { return fmt::format("What tiles cost, {} colours", s.colors); },
        [](const TilingCostSettings& s, std::uint64_t seed, DistributionFiles&) { return make_tiling_costs(s, seed); });
}

}
