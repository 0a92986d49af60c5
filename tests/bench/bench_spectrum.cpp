// Periodograms at the sizes that experiments use.
#include "analysis/spectrum.hpp"
#include "support/point_patterns.hpp"

#include <benchmark/benchmark.h>

namespace {

/// Arguments: dimension, number of points, size of the spectrum.
void exact_periodogram(benchmark::State& state)
{
    std::mt19937_64 random(1);
    const auto points = poissonlab::test::random_points(static_cast<std::size_t>(state.range(1)),
                                                        static_cast<int>(state.range(0)), random);
    for (auto _ : state) {
        benchmark::DoNotOptimize(poissonlab::exact_periodogram(points, static_cast<int>(state.range(2))));
    }
}

BENCHMARK(exact_periodogram)
    ->Args({2, 16'384, 1024})
    ->Args({2, 262'144, 4096})
    ->Args({3, 65'536, 128})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}
