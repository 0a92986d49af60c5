// Methods of chapter 6 that make sets or tiles by themselves: 16,384 points of Dunbar and Humphreys' darts, of Jones'
// and of a Penrose tiling, averaged tiles of 63 points after 30 iterations, recursive Wang tiles, and polyominoes with
// their tables.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007: 0.137 s, 7.911 s and 7.002 s (section 6.13), 3.403 s (section
// 6.12, at 0.75) on an Athlon 64 4000+; section 6.14: 1.005 s; section 6.8: 0.192 s. Targets on two cores for recursive
// tiles: built in 10 s, 16,384 points in 15 ms, 20 million points a second of a density; for Penrose tilings: the table
// in 30 s, 16,384 points in 15 ms; for boundary darts: 60 ms a set of ten.
#include "base/densities/density_text.hpp"
#include "base/random/random.hpp"
#include "host/device/device.hpp"
#include "host/settings/sampler_registry.hpp"
#include "host/tile_construction/recursive/recursive_construction.hpp"
#include "host/tile_sampling/penrose/penrose_relaxation.hpp"
#include "host/tile_sampling/penrose/penrose_sampler.hpp"
#include "host/tile_sampling/polyominoes/polyomino_sampler.hpp"
#include "host/tile_sampling/recursive/recursive_sampler.hpp"
#include "host/tile_sampling/wang_tiles/averaged_tiles.hpp"
#include "tests/bench/ratio_reporter.hpp"

namespace {

using namespace poissonlab;

/// Ten realizations are asked for, which are made side by side: a set's share of their time.
void sector_darts(benchmark::State& state, const char* variant)
{
    const SamplerSpec& spec = *find_sampler("sector-darts");
    Parameters parameters(spec.parameters);
    parameters.set("variant", std::string(variant), {});
    parameters.set("min_distance", 0.00724, {}); // 16,384 points along boundaries, fewer otherwise
    Device device = Device::open();
    const auto sampler = spec.create(parameters, {16'384, 2, 1}, Engine::opencl, [&]() -> Device& { return device; });
    std::uint32_t realization = 0;
    sampler->sample(realization++);
    for (auto _ : state) {
        sampler->expect(realization, 10);
        for (int i = 0; i < 10; ++i) benchmark::DoNotOptimize(sampler->sample(realization++));
        state.SetIterationTime(*sampler->traits().shared_seconds);
    }
}

/// 16,384 points by a sampler that is made before, with its tables.
void sets_of(benchmark::State& state, const char* method, const char* key, const ParameterValue& value)
{
    const SamplerSpec& spec = *find_sampler(method);
    Parameters parameters(spec.parameters);
    parameters.set(key, value, {});
    Device device = Device::open();
    const auto sampler = spec.create(parameters, {16'384, 2, 1}, Engine::opencl, [&]() -> Device& { return device; });
    std::uint32_t realization = 0;
    sampler->sample(realization++);
    for (auto _ : state) benchmark::DoNotOptimize(sampler->sample(realization++));
}

/// Makes sets of 16,384 darts at a relative radius of 0.75.
void darts(benchmark::State& state, const char* method) { sets_of(state, method, "relative_radius", 0.75); }

/// Asked: less than 15 ms.
void polyomino_sets(benchmark::State& state, const char* variant)
{
    sets_of(state, "polyominoes", "variant", std::string(variant));
}

/// The table is built; it does not matter for the time which one it is.
void penrose_points(benchmark::State& state)
{
    const PenroseTiling tiling{PenroseTable{}};
    const std::uint64_t importance = importance_for_points(tiling, static_cast<std::size_t>(state.range(0)));
    PenroseGenerator generator(Device::open(), tiling);
    for (auto _ : state) benchmark::DoNotOptimize(generator.points(importance));
}

void penrose_table(benchmark::State& state)
{
    for (auto _ : state) benchmark::DoNotOptimize(relaxed_penrose_table());
}

void averaged_tiles(benchmark::State& state, bool on_device)
{
    AveragedTiles kernels(Device::open());
    kernels.average_once(start_averaged_tiles(63, 1), AveragedVariant::exact, 0, 1);
    for (auto _ : state) {
        WangPoints points = start_averaged_tiles(63, 1);
        for (std::uint32_t i = 0; i < 30; ++i)
            points = on_device ? kernels.average_once(points, AveragedVariant::exact, i, 1)
                               : average_once(points, AveragedVariant::exact, i, 1);
        benchmark::DoNotOptimize(points);
    }
}

void recursive_building(benchmark::State& state)
{
    for (auto _ : state) benchmark::DoNotOptimize(build_recursive_tiles(2048, 1));
}

/// Points of a density are counted: a million of a formula, and 16,384 everywhere alike.
void recursive_points(benchmark::State& state, std::size_t points, const std::optional<Density>& density,
                      bool on_device)
{
    static const RecursiveTileSet tiles = build_recursive_tiles(2048, 1);
    const RecursiveDensity wanted(points, 4, 0, density);
    RecursiveGenerator generator(Device::open(), tiles, wanted);
    generator.torus_points(RecursiveTiling(tiles, 4, {}));
    std::uint32_t realization = 0;
    std::size_t made = 0;
    for (auto _ : state) {
        const StreamKey stream = stream_key(1, Purpose::recursive_tilings, realization++);
        const RecursiveTiling tiling(tiles, 4, stream);
        const PointSet set = on_device ? generator.torus_points(tiling) : tiling.torus_points(wanted);
        made += set.size();
    }
    state.counters["points/s"] = benchmark::Counter(static_cast<double>(made), benchmark::Counter::kIsRate);
}

BENCHMARK(recursive_building)->Iterations(1)->Repetitions(3)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(recursive_points, uniform, 16'384, std::nullopt, true)
    ->Repetitions(9)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(recursive_points, density, 1'000'000, density_of_formula("gauss-and-waves", 1, 1), true)
    ->Repetitions(9)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(recursive_points, density_by_twin, 1'000'000, density_of_formula("gauss-and-waves", 1, 1), false)
    ->Repetitions(9)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// The table is built from nothing. Asked: less than 60 s.
void polyomino_table(benchmark::State& state, Polyomino shape)
{
    for (auto _ : state) benchmark::DoNotOptimize(cached_polyomino_table(shape, {}));
}

BENCHMARK_CAPTURE(polyomino_sets, P, "P")->Repetitions(9)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(polyomino_sets, G, "G")->Repetitions(9)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(polyomino_table, P, Polyomino::P)->Iterations(1)->Unit(benchmark::kSecond)->UseRealTime();
BENCHMARK_CAPTURE(polyomino_table, G, Polyomino::G)->Iterations(1)->Unit(benchmark::kSecond)->UseRealTime();
BENCHMARK_CAPTURE(sector_darts, boundary, "boundary")
    ->Iterations(1)
    ->Repetitions(9)
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();
BENCHMARK_CAPTURE(sector_darts, linear, "linear")
    ->Iterations(1)
    ->Repetitions(3)
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();
BENCHMARK_CAPTURE(sector_darts, logarithmic, "logarithmic")
    ->Iterations(1)
    ->Repetitions(3)
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();
BENCHMARK_CAPTURE(darts, dart_throwing, "dart-throwing")->Repetitions(9)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(darts, voronoi_darts, "voronoi-darts")->Repetitions(9)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(penrose_points)->Arg(16'384)->Arg(262'144)->Repetitions(9)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(penrose_table)->Iterations(1)->Repetitions(3)->Unit(benchmark::kSecond)->UseRealTime();
BENCHMARK_CAPTURE(averaged_tiles, kernel, true)->Repetitions(5)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(averaged_tiles, twin, false)->Repetitions(5)->Unit(benchmark::kMillisecond)->UseRealTime();

}

int main(int argc, char** argv)
{
    return poissonlab::bench::run_benchmarks(argc, argv,
                                             {{"16,384 sector darts: time of logarithmic / boundary",
                                               "sector_darts/logarithmic/", "sector_darts/boundary/", 3},
                                              // Voronoi darts may take six times as long as dart throwing.
                                              {"16,384 darts at 0.75: time of dart throwing / Voronoi darts",
                                               "darts/dart_throwing/", "darts/voronoi_darts/", 1.0 / 6}});
}
