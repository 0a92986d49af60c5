// poissonlab tiling: the tile indices of a window of a stochastic tiling.
#include "app/commands/kind_options.hpp"
#include "app/commands/tilings/tile_rows.hpp"
#include "host/kinds/kinds.hpp"
#include "host/scenes/shown_tiling.hpp"

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
  wang-cube     face-hash; scanline, scanline-compact (with 2 colours 32 cubes)
Names of aperiodic sets are those of `poissonlab aperiodic`; --colors must be theirs.
Scanline tilings start at their north-west tile; the window must be at 0 0.
--hash long-period (repeats after 5,930,659,848 tiles), permutation (256; the fastest), xxh64 (never repeats),
two-tables (256, few of the tiles); with edge-hash, after half as many. --entries sets the sizes of tables.
  poissonlab tiling corner --colors 3 --window -4 -4 8 8)";

void print_tiling(const KindOptions& options)
{
    auto [set, tiling, window, regions, is_drawn] = options.settings().as<ShownTiling>();
    tiling.seed = options.seed();
    const std::int64_t end = stepped(window.x, window.width);
    std::int64_t layer = window.z;
    TileRows rows(options.prints_json(),
                  tiling.kind == TileKind::cube || tiling.kind == TileKind::wang_cube ? "layers" : "");
    stream_tiles(tiling, window, [&](std::int64_t x, std::int64_t, std::int64_t z, std::span<const TileIndex> tiles) {
        if (z != layer) rows.next_block();
        layer = z;
        rows.add(tiles, stepped(x, tiles.size()) == end);
    });
    rows.finish();
}

}

Command tiling_command()
{
    const auto o = std::make_shared<KindOptions>(*find_kind("", "tiling"), "kind");
    return kind_command(o, {}, tiling_notes, print_tiling);
}

}
