// 100 million points from a tile set, compared with filling the same buffer with a constant; and 16,384
// points by the header for engines, with the file's reading.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 5.2.1, measures points a second; memory sets
// the limit.
#include "host/tile_points/tile_points.hpp"
#include "tests/bench/ratio_reporter.hpp"
#include "tests/support/random_tile_set.hpp"
#include "tests/support/temporary_folder.hpp"

#include <fstream>
#include <iterator>
#include <vector>

namespace {

using namespace poissonlab;

constexpr std::uint32_t points_per_tile = 64;
constexpr TileBlock block{{}, {1250, 1250, 1}};
constexpr std::int64_t point_count = 1250 * 1250 * points_per_tile;

constexpr auto fill_source = R"(
    kernel void fill(uint count, global float16* values)
    {
        const uint id = get_global_id(0);
        if (id < count) values[id] = (float16)(0.25f);
    }
)";

/// The buffer that both benchmarks write to. Memory that was never written to is slow; it is written to here.
struct Target
{
    Device device = Device::open();
    Buffer<float> points = device.buffer<float>(2 * point_count);
    Kernel fill_kernel = device.kernel_from_text(fill_source, "bench_tile_points", "fill");

    Target() { fill(); }

    void fill()
    {
        const auto vectors = static_cast<std::uint32_t>(points.size() / 16);
        fill_kernel.run(vectors, 256, vectors, points);
        device.finish();
    }
};

Target& target()
{
    static Target shared;
    return shared;
}

void fill(benchmark::State& state)
{
    for (auto _ : state) target().fill();
    state.SetItemsProcessed(point_count * state.iterations());
}

void tile_points(benchmark::State& state, std::uint32_t colors)
{
    const PoissonTileSet tiles = random_tile_set(PoissonTileKind::corner, 2, colors, points_per_tile);
    TilePointGenerator generator(target().device, tiles);
    const auto generate = [&] {
        generator.place({1, 0}, block, {0, static_cast<std::uint32_t>(block.tiles())}, target().points);
        target().device.finish();
    };
    generate();
    for (auto _ : state) generate();
    state.SetItemsProcessed(point_count * state.iterations());
}

/// An engine would read the file, then take 16 x 16 tiles.
void load_and_place_16384(benchmark::State& state)
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "tiles.ptiles";
    write_tile_set_file(path, random_tile_set(PoissonTileKind::corner, 2, 8, points_per_tile));
    std::vector<ptiles_point> points(16 * 16 * points_per_tile);
    for (auto _ : state) {
        std::ifstream file(path, std::ios::binary);
        std::vector<char> bytes(std::filesystem::file_size(path));
        file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        ptiles_tiling tiling{{}, 1, 0};
        if (const char* problem = ptiles_open(&tiling.set, bytes.data(), bytes.size())) state.SkipWithError(problem);
        const double low[] = {0, 0};
        const double high[] = {16, 16};
        benchmark::DoNotOptimize(ptiles_in_window(&tiling, low, high, points.data(), points.size(), 1));
    }
}

/// Points that are up to 0.15 tiles below and 0.04 above their squares: what was measured for 3 to 8 colours.
PoissonTileSet chain_set()
{
    PoissonTileSet set = random_chain_set(4, points_per_tile);
    for (std::uint16_t& stored : set.points)
        stored = static_cast<std::uint16_t>((0.5 - 0.15 + 1.19 * stored / 65536) * 32768);
    return set;
}

PoissonTileSet strip_set() { return random_tile_set(PoissonTileKind::corner, 2, 4, points_per_tile); }

PoissonTileSet ranked_set() { return with_random_ranks(strip_set()); }

/// 16 x 16 tiles, which chains make two rows and columns more.
void window(benchmark::State& state, PoissonTileSet (*make)(), double density = 1)
{
    const PoissonTileSet tiles = make();
    const ptiles_tiling tiling = runtime_tiling(tiles, {});
    std::vector<ptiles_point> points(17 * 17 * points_per_tile);
    double low[] = {0, 0};
    for (auto _ : state) {
        low[0] += 0.618;
        const double high[] = {low[0] + 16, low[1] + 16};
        benchmark::DoNotOptimize(ptiles_in_window(&tiling, low, high, points.data(), points.size(), density));
    }
}

void nearest_point(benchmark::State& state, PoissonTileSet (*make)())
{
    const PoissonTileSet tiles = make();
    const ptiles_tiling tiling = runtime_tiling(tiles, {});
    double position[] = {0, 0};
    for (auto _ : state) {
        position[0] += 0.618;
        position[1] += 0.755;
        ptiles_point nearest;
        benchmark::DoNotOptimize(ptiles_nearest(&tiling, position, &nearest));
    }
}

BENCHMARK(fill)->Repetitions(15)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(tile_points, colors_4, 4)->Repetitions(15)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(tile_points, colors_8, 8)->Repetitions(15)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(load_and_place_16384)->Repetitions(5)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(window, strips, strip_set, 1)->Repetitions(9)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(window, chains, chain_set, 1)->Repetitions(9)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(window, half, ranked_set, 0.5)->Repetitions(9)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(window, nearly_all, ranked_set, 0.99)->Repetitions(9)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(nearest_point, strips, strip_set)->Repetitions(9);
BENCHMARK_CAPTURE(nearest_point, chains, chain_set)->Repetitions(9);

}

int main(int argc, char** argv)
{
    return poissonlab::bench::run_benchmarks(
        argc, argv,
        {{"speed over that of filling, 4 colours", "fill/", "tile_points/colors_4/", 0.8},
         {"speed over that of filling, 8 colours", "fill/", "tile_points/colors_8/", 0},
         {"window of 16 x 16 tiles: time with strips / with chains", "window/strips/", "window/chains/", 0.8},
         {"window of half of the ranks: time with all / with half", "window/strips/", "window/half/", 0.7},
         {"window of all but a hundredth of the ranks", "window/strips/", "window/nearly_all/", 0.7},
         {"nearest point: time with strips / with chains", "nearest_point/strips/", "nearest_point/chains/", 0.67}});
}
