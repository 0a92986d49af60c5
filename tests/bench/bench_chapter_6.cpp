// Methods of chapter 6 that make sets or tiles by themselves: 16,384 points of Dunbar and Humphreys' darts, and
// averaged tiles of 63 points after 30 iterations.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 6.13: 0.137 s, 7.911 s and 7.002 s on an Athlon 64
// 4000+.
#include "host/config/sampler_registry.hpp"
#include "host/tile_sampling/wang_tiles/averaged_tiles.hpp"
#include "tests/bench/ratio_reporter.hpp"

#include <benchmark/benchmark.h>

namespace {

using namespace poissonlab;

void sector_darts(benchmark::State& state, const char* variant)
{
    const SamplerSpec& spec = *find_sampler("sector-darts");
    Parameters parameters(spec.parameters);
    parameters.set("variant", std::string(variant), {});
    const auto sampler = spec.create(parameters, {16'384, 2, 1}, Engine::opencl, {});
    std::uint32_t realization = 0;
    for (auto _ : state) benchmark::DoNotOptimize(sampler->sample(realization++));
}

void averaged_tiles(benchmark::State& state)
{
    for (auto _ : state) {
        WangPoints points = start_averaged_tiles(63, 1);
        for (std::uint32_t i = 0; i < 30; ++i) points = average_once(points, AveragedVariant::exact, i, 1);
        benchmark::DoNotOptimize(points);
    }
}

BENCHMARK_CAPTURE(sector_darts, boundary, "boundary")->Repetitions(9)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sector_darts, linear, "linear")->Iterations(1)->Repetitions(5)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sector_darts, logarithmic, "logarithmic")
    ->Iterations(1)
    ->Repetitions(5)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(averaged_tiles)->Repetitions(5)->Unit(benchmark::kMillisecond)->UseRealTime();

}

int main(int argc, char** argv)
{
    return poissonlab::bench::run_benchmarks(argc, argv,
                                             {{"16,384 sector darts: time of logarithmic / boundary",
                                               "sector_darts/logarithmic/", "sector_darts/boundary/", 3}});
}
