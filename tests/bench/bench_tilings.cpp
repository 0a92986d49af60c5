// Tiles a second of the direct tiling algorithms on one core, as streamed rows and at places anywhere.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 3.3, calls corner tiles the cheapest: four
// hash evaluations and no sums. Wang tiles by one hash function add sums to these, by two hash functions
// double them. A hash function at the edges is evaluated four times too, but neighbours share fewer of them.
#include "tests/bench/ratio_reporter.hpp"
#include "tiles/tilings/cube_tiling.hpp"
#include "tiles/tilings/direct_tiling.hpp"
#include "tiles/tilings/scanline_tiling.hpp"
#include "tiles/tilings/tiling.hpp"

#include <string>
#include <vector>

namespace {

using namespace poissonlab;

constexpr Color colors = 4;

/// Tiles of a square of so many tiles.
void count_tiles(benchmark::State& state, std::uint64_t side)
{
    state.SetItemsProcessed(static_cast<std::int64_t>(side * side) * state.iterations());
}

void stream_rows(benchmark::State& state, DirectAlgorithm algorithm, HashKind hash)
{
    constexpr std::uint64_t side = 1024;
    const Tiling tiling(algorithm, {colors, colors}, hash, 1);
    for (auto _ : state) {
        TileIndex seen = 0;
        tiling.stream({-300, -300, side, side}, [&](std::int64_t, std::int64_t, std::span<const TileIndex> tiles) {
            benchmark::DoNotOptimize(tiles.data());
            seen ^= tiles.back();
        });
        benchmark::DoNotOptimize(seen);
    }
    count_tiles(state, side);
}

/// The sum of what `tile` gives at places that no cache or predictor foresees: Weyl sequences of 64-bit
/// coordinates.
template <class Tile>
void visit_places(benchmark::State& state, const Tile& tile)
{
    constexpr std::uint64_t side = 256;
    for (auto _ : state) {
        TileIndex seen = 0;
        std::uint64_t x = 1;
        std::uint64_t y = 2;
        for (std::uint64_t i = 0; i < side * side; ++i) {
            x += 0x9E3779B97F4A7C15;
            y += 0xD1B54A32D192ED03;
            seen += tile(static_cast<std::int64_t>(x), static_cast<std::int64_t>(y));
        }
        benchmark::DoNotOptimize(seen);
    }
    count_tiles(state, side);
}

void look_up(benchmark::State& state, DirectAlgorithm algorithm, HashKind hash)
{
    const Tiling tiling(algorithm, {colors, colors}, hash, 1);
    visit_places(state, [&](std::int64_t x, std::int64_t y) { return tiling.tile(x, y); });
}

/// Algorithm and hash function known to the compiler.
void look_up_inlined(benchmark::State& state)
{
    const PermutationHash hash(colors, stream_key(1, Purpose::tiling_colors, 0));
    visit_places(state, [&](std::int64_t x, std::int64_t y) {
        return corner_index(direct_corner_tile(hash, Plane{}, x, y), colors);
    });
}

void stream_cubes(benchmark::State& state)
{
    constexpr std::uint64_t side = 256;
    const CubeTiling tiling(2, HashKind::permutation, 1);
    for (auto _ : state) {
        tiling.stream({0, 0, 0, side, side, 1},
                      [](std::int64_t, std::int64_t, std::int64_t, std::span<const TileIndex> cubes) {
                          benchmark::DoNotOptimize(cubes.data());
                      });
    }
    count_tiles(state, side);
}

void scanline(benchmark::State& state, const TileSet& tiles)
{
    constexpr std::uint64_t side = 256;
    for (auto _ : state) {
        ScanlineTiling tiling(tiles, side, 1);
        for (std::uint64_t row = 0; row < side; ++row) benchmark::DoNotOptimize(tiling.next_row().data());
    }
    count_tiles(state, side);
}

#define ONE_HASH(function, algorithm, hash)                                                                            \
    BENCHMARK_CAPTURE(function, algorithm##_##hash, DirectAlgorithm::algorithm, HashKind::hash)->Repetitions(5)
#define EACH_HASH(function, algorithm)                                                                                 \
    ONE_HASH(function, algorithm, permutation);                                                                        \
    ONE_HASH(function, algorithm, long_period);                                                                        \
    ONE_HASH(function, algorithm, xxh64)

EACH_HASH(stream_rows, corner);
EACH_HASH(stream_rows, wang_one_hash);
EACH_HASH(stream_rows, wang_two_hashes);
EACH_HASH(stream_rows, wang_edge_hash);
EACH_HASH(look_up, corner);
EACH_HASH(look_up, wang_one_hash);
EACH_HASH(look_up, wang_two_hashes);
EACH_HASH(look_up, wang_edge_hash);
BENCHMARK(look_up_inlined)->Repetitions(5);
BENCHMARK(stream_cubes)->Repetitions(5);
BENCHMARK_CAPTURE(scanline, corner, TileSet::complete(TileKind::corner, colors))->Repetitions(5);
BENCHMARK_CAPTURE(scanline, compact_wang, compact_wang_set(colors))->Repetitions(5);

/// Each other algorithm over corner tiles, for each way to ask for tiles and each hash function.
std::vector<bench::Ratio> ratios()
{
    std::vector<bench::Ratio> result;
    for (const std::string way : {"stream_rows", "look_up"}) {
        for (const std::string hash : {"permutation", "long_period", "xxh64"}) {
            for (const std::string algorithm : {"wang_one_hash", "wang_edge_hash", "wang_two_hashes"}) {
                result.push_back({way + ", " + hash + ": " + algorithm + " / corner",
                                  way + "/" + algorithm + "_" + hash + "/", way + "/corner_" + hash + "/", 1});
            }
        }
    }
    return result;
}

}

int main(int argc, char** argv) { return poissonlab::bench::run_benchmarks(argc, argv, ratios()); }
