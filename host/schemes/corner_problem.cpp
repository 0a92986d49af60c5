// kind = "corner-problem": any two Wang tiles can lie diagonally to each other, corner tiles only where their common
// corner has one colour.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 2.6, figure 2.2. The claim is counted: for all ordered
// pairs of tiles, whether there are two tiles that complete the square. Objects across corners of Wang tiles are
// counted as well.
#include "host/schemes/mark_canvas.hpp"
#include "host/schemes/scheme_run.hpp"
#include "tiles/tilings/tile_set.hpp"
#include "tiles/tilings/tiling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace poissonlab {
namespace {

/// A square of four tiles.
template <class Tile>
struct TileSquare
{
    Tile north_west, north_east, south_west, south_east;
};

template <class Tile>
MarkPicture picture_of(const TileSquare<Tile>& square)
{
    constexpr double margin = 0.15;
    MarkCanvas canvas(2 + 2 * margin, 2 + 2 * margin, 110);
    canvas.tile(square.south_west, {{margin, margin}});
    canvas.tile(square.south_east, {{1 + margin, margin}});
    canvas.tile(square.north_west, {{margin, 1 + margin}});
    canvas.tile(square.north_east, {{1 + margin, 1 + margin}});
    canvas.ring("#000000", {1 + margin, 1 + margin}, 0.45, 0.05);
    return canvas.picture();
}

TileSquare<WangTile> wang_square(const Tiling& tiling)
{
    const WangColors colors = tiling.tile_set().colors();
    const auto tile = [&](std::int64_t x, std::int64_t y) { return wang_tile(tiling.tile(x, y), colors); };
    return {tile(0, 1), tile(1, 1), tile(0, 0), tile(1, 0)};
}

/// Changes all colours of the tile in the south-east, and those of its neighbours that have to match them.
TileSquare<WangTile> with_another_diagonal(TileSquare<WangTile> square, Color colors)
{
    const auto next = [&](Color& color) { color = (color + 1) % colors; };
    for (Color* color :
         {&square.south_east.north, &square.south_east.east, &square.south_east.south, &square.south_east.west})
        next(*color);
    square.north_east.south = square.south_east.north;
    square.south_west.east = square.south_east.west;
    return square;
}

TileSquare<CornerTile> corner_square(const Tiling& tiling)
{
    const Color colors = tiling.tile_set().colors().horizontal;
    const auto tile = [&](std::int64_t x, std::int64_t y) { return corner_tile(tiling.tile(x, y), colors); };
    return {tile(0, 1), tile(1, 1), tile(0, 0), tile(1, 0)};
}

struct DiagonalPairs
{
    std::uint64_t fitting = 0, all = 0;
};

/// The pairs of a tile in the north-west and one in the south-east that two tiles of the set complete to a square.
DiagonalPairs wang_pairs(const TileSet& set)
{
    const WangColors c = set.colors();
    std::vector<WangTile> tiles;
    std::vector<bool> north_east(std::size_t{c.vertical} * c.horizontal), south_west(north_east.size());
    for (std::uint64_t i = 0; i < set.size(); ++i) {
        const WangTile tile = wang_tile(set.index(i), c);
        tiles.push_back(tile);
        north_east[tile.west * c.horizontal + tile.south] = true;
        south_west[tile.east * c.horizontal + tile.north] = true;
    }
    DiagonalPairs pairs;
    for (const WangTile& first : tiles)
        for (const WangTile& second : tiles) {
            ++pairs.all;
            pairs.fitting += north_east[first.east * c.horizontal + second.north] &&
                             south_west[second.west * c.horizontal + first.south];
        }
    return pairs;
}

/// The pairs of corner tiles that two others complete to a square; the complete set has all tiles that a pair asks for.
DiagonalPairs corner_pairs(Color colors)
{
    const TileSet set = TileSet::complete(TileKind::corner, colors);
    DiagonalPairs pairs;
    for (std::uint64_t i = 0; i < set.size(); ++i)
        for (std::uint64_t j = 0; j < set.size(); ++j) {
            ++pairs.all;
            pairs.fitting +=
                corner_tile(set.index(i), colors).south_east == corner_tile(set.index(j), colors).north_west;
        }
    return pairs;
}

/// The least and the most tiles of a set that have to be adapted to an object across a corner of a tile: those with the
/// rest of it across the vertical edge, whose opposite edge has that colour, and those with the rest across the
/// horizontal edge. Over all corners and colours.
///
/// Cohen and others, Wang tiles for image and texture generation, 2003, section 3.4: "in a two colored set of eight
/// tiles six tiles have to be adapted, in a three colored set (18 tiles) twelve tiles".
std::pair<std::size_t, std::size_t> adapted_tiles(const TileSet& set)
{
    std::pair<std::size_t, std::size_t> range{set.size(), 0};
    const WangColors c = set.colors();
    for (const auto vertical : {&WangTile::west, &WangTile::east})
        for (const auto horizontal : {&WangTile::north, &WangTile::south})
            for (Color a = 0; a < c.vertical; ++a)
                for (Color b = 0; b < c.horizontal; ++b) {
                    std::size_t count = 0;
                    for (std::uint64_t i = 0; i < set.size(); ++i) {
                        const WangTile tile = wang_tile(set.index(i), c);
                        count += tile.*vertical == a || tile.*horizontal == b;
                    }
                    range = {std::min(range.first, count), std::max(range.second, count)};
                }
    return range;
}

void add_share(const std::string& key, const std::string& title, const DiagonalPairs& pairs, DistributionResult& result)
{
    result.numbers.push_back({key, title, static_cast<double>(pairs.fitting) / static_cast<double>(pairs.all),
                              fmt::format("{} of {} ordered pairs can lie diagonally", pairs.fitting, pairs.all)});
}

}

DistributionResult make_corner_problem(const CornerProblemSettings& settings, std::uint64_t seed,
                                       DistributionFiles& files)
{
    const Color colors = settings.colors;
    DistributionResult result;
    result.facts = {fmt::format("{} colours", colors)};
    const auto wang = wang_square(Tiling(DirectAlgorithm::wang_edge_hash, {colors, colors}, HashKind::xxh64, seed));
    files.add_marks("wang.json", picture_of(wang), "(a) Wang tiles around a corner.", result);
    files.add_marks("wang-again.json", picture_of(with_another_diagonal(wang, colors)),
                    "The same tile in the north-west; another in the south-east fits as well.", result);
    files.add_marks("corner.json",
                    picture_of(corner_square(Tiling(DirectAlgorithm::corner, {colors, colors}, HashKind::xxh64, seed))),
                    "(b) Corner tiles: all four have the colour of the corner.", result);
    add_share("wang_pairs", "Wang tiles, complete set", wang_pairs(TileSet::complete(TileKind::wang, colors)), result);
    add_share("compact_wang_pairs", "Wang tiles, compact set", wang_pairs(compact_wang_set(colors)), result);
    add_share("corner_pairs", "Corner tiles, complete set", corner_pairs(colors), result);
    const TileSet compact = compact_wang_set(colors);
    const auto [least, most] = adapted_tiles(compact);
    result.numbers.push_back(
        {"adapted_tiles", "Adapted tiles", static_cast<double>(most),
         fmt::format("of {} in the compact set have the rest of an object across a corner, at most; "
                     "{} at least",
                     compact.size(), least)});
    return result;
}

}
