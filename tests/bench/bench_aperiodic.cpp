// Aperiodic sets and isohedral tilings against their targets: the largest table, cylinder search to
// circumference 10, tilings by Beatty sequences on a device, and windows of isohedral tiles.
#include "host/aperiodic_tiling/beatty_generator.hpp"
#include "reports/drawings/tilings/isohedral_image.hpp"
#include "tests/bench/ratio_reporter.hpp"
#include "tiles/aperiodic/aperiodic_sets.hpp"
#include "tiles/aperiodic/corner_constructions.hpp"
#include "tiles/aperiodic/cylinder_search.hpp"

namespace {

using namespace poissonlab;

/// The largest number of table 8.3: 1,213,029 squares of 5 x 5 of Kari's tiles.
void make_largest_table(benchmark::State& state)
{
    for (auto _ : state) benchmark::DoNotOptimize(repeat_construction(kari_tiles(), CornerConstruction::diagonal, 4));
}

void search_ten(benchmark::State& state, WangList (*tiles)())
{
    for (auto _ : state) benchmark::DoNotOptimize(search_periods(tiles(), 10));
}

void stream_beatty_tiles(benchmark::State& state, BeattySet set)
{
    constexpr std::uint64_t side = 8192;
    BeattyGenerator generator(Device::open(), BeattyTiling(set, 1));
    for (auto _ : state) {
        std::uint64_t seen = 0;
        generator.stream({-4096, -4096, side, side}, [&](std::span<const std::uint8_t> tiles) { seen += tiles[0]; });
        benchmark::DoNotOptimize(seen);
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(side * side) * state.iterations());
}

/// Some 1,000 tiles, as SVG text.
void draw_thousand_tiles(benchmark::State& state)
{
    const IsohedralTile tile = random_tile(isohedral_types()[27], 5, 0.3, 0.12);
    for (auto _ : state)
        benchmark::DoNotOptimize(drawing_svg(draw_isohedral_tiling(tile, proper_coloring(tile), 31, 31)));
}

BENCHMARK(make_largest_table)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(search_ten, culik, culik_tiles)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(search_ten, kari, kari_tiles)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(search_ten, ammann, ammann_tiles)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(stream_beatty_tiles, kari, BeattySet::kari)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(stream_beatty_tiles, culik, BeattySet::culik)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(draw_thousand_tiles)->Unit(benchmark::kMillisecond)->UseRealTime();

}

int main(int argc, char** argv)
{
    // Two cores are meant: 8192^2 tiles at 20 million a second take 3,360 ms.
    return poissonlab::bench::run_benchmarks(argc, argv, {},
                                             {{"making table 8.3, ms", "make_largest_table/", 60'000},
                                              {"Culik's tiles, periods up to 10, ms", "search_ten/culik/", 60'000},
                                              {"Kari's tiles, periods up to 10, ms", "search_ten/kari/", 60'000},
                                              {"Ammann's tiles, periods up to 10, ms", "search_ten/ammann/", 60'000},
                                              {"8192^2 of Kari's tiles, ms", "stream_beatty_tiles/kari/", 3360},
                                              {"8192^2 of Culik's tiles, ms", "stream_beatty_tiles/culik/", 3360},
                                              {"1,000 tiles as SVG, ms", "draw_thousand_tiles/", 200}});
}
