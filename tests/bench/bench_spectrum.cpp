// Periodograms at the sizes that experiments use, fast ones against FFTW's own transforms.
#include "analysis/spectra/fast_periodogram.hpp"
#include "analysis/spectra/radial_statistics.hpp"
#include "analysis/spectra/spectrum.hpp"
#include "tests/bench/ratio_reporter.hpp"
#include "tests/support/point_patterns.hpp"

#include <fftw3.h>

#include <array>

namespace poissonlab::bench {
namespace {

/// Arguments of all: dimension, number of points, size of the spectrum.
PointSet points_of(const benchmark::State& state)
{
    std::mt19937_64 random(1);
    return test::random_points(static_cast<std::size_t>(state.range(1)), static_cast<int>(state.range(0)), random);
}

void exact(benchmark::State& state)
{
    const PointSet points = points_of(state);
    for (auto _ : state) benchmark::DoNotOptimize(exact_periodogram(points, static_cast<int>(state.range(2))));
}

void fast(benchmark::State& state)
{
    const PointSet points = points_of(state);
    FastPeriodogram periodogram(points.dimension, static_cast<int>(state.range(2)));
    for (auto _ : state) benchmark::DoNotOptimize(periodogram.compute(points));
}

/// Ten realizations: mean, variance, radial power and anisotropy with errors.
void ten_fast(benchmark::State& state)
{
    const PointSet points = points_of(state);
    for (auto _ : state) {
        SpectrumEstimate estimate(points.dimension, static_cast<int>(state.range(2)));
        for (int i = 0; i < 10; ++i) estimate.add(points);
        benchmark::DoNotOptimize(radial_statistics(estimate.mean()));
        benchmark::DoNotOptimize(estimate.radial_errors());
    }
}

/// FFTW's real-to-complex transform of size^dimension values by a measured plan. Arguments: dimension, threads, size.
void fftw(benchmark::State& state)
{
    const int dimension = static_cast<int>(state.range(0));
    const std::array<int, 3> sizes{static_cast<int>(state.range(2)), static_cast<int>(state.range(2)),
                                   static_cast<int>(state.range(2))};
    std::size_t lines = 1;
    for (int k = 1; k < dimension; ++k) lines *= static_cast<std::size_t>(sizes[0]);
    const auto columns = static_cast<std::size_t>(sizes[0]);
    double* in = fftw_alloc_real(lines * columns);
    fftw_complex* out = fftw_alloc_complex(lines * (columns / 2 + 1));
    fftw_plan_with_nthreads(static_cast<int>(state.range(1)));
    const fftw_plan plan = fftw_plan_dft_r2c(dimension, sizes.data(), in, out, FFTW_MEASURE);
    fftw_plan_with_nthreads(1); // it is a setting of the whole program
    fftw_forget_wisdom();       // so is what was measured: fast periodograms would use it
    for (std::size_t i = 0; i < lines * columns; ++i) in[i] = static_cast<double>(i % 7);
    for (auto _ : state) fftw_execute(plan);
    fftw_destroy_plan(plan);
    fftw_free(in);
    fftw_free(out);
}

/// One of the lines that fast periodograms consist of, by an estimated plan, as theirs are, or by a measured one.
/// Arguments: size, 1 where it is measured.
void fftw_line(benchmark::State& state)
{
    const int size = static_cast<int>(state.range(0));
    fftw_complex* in = fftw_alloc_complex(static_cast<std::size_t>(size));
    fftw_complex* out = fftw_alloc_complex(static_cast<std::size_t>(size));
    fftw_forget_wisdom(); // estimated plans are what was measured before, where something was
    const fftw_plan plan =
        fftw_plan_dft_1d(size, in, out, FFTW_FORWARD, state.range(1) == 1 ? FFTW_MEASURE : FFTW_ESTIMATE);
    fftw_forget_wisdom();
    for (int i = 0; i < size; ++i) in[i][0] = in[i][1] = i % 7;
    for (auto _ : state) fftw_execute(plan);
    fftw_destroy_plan(plan);
    fftw_free(in);
    fftw_free(out);
}

BENCHMARK(exact)->Args({2, 16'384, 1024})->Args({3, 65'536, 128})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(fftw)
    ->Args({2, 1, 2048})
    ->Args({2, 2, 2048})
    ->Args({3, 2, 384})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Repetitions(7);
BENCHMARK(fast)
    ->Args({2, 16'384, 1024})
    ->Args({3, 65'536, 256})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Repetitions(7);
BENCHMARK(fast)
    ->Args({2, 1'000'000, 8192})
    ->Args({2, 10'000'000, 8192})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(1);
BENCHMARK(fftw_line)->ArgsProduct({{384, 1280, 10240}, {1, 0}})->UseRealTime()->Repetitions(7);
BENCHMARK(ten_fast)->Args({2, 16'384, 1024})->Unit(benchmark::kMillisecond)->UseRealTime()->Repetitions(7);

}
}

int main(int argc, char** argv)
{
    fftw_init_threads();
    return poissonlab::bench::run_benchmarks(
        argc, argv,
        {{"16,384 points at 1,024^2: FFTW's 2,048^2 on 1 thread / fast", "fftw/2/1/2048", "fast/2/16384/1024", 1},
         {"16,384 points at 1,024^2: FFTW's 2,048^2 on 2 threads / fast", "fftw/2/2/2048", "fast/2/16384/1024", 1},
         {"ten of them, with radial statistics: FFTW on 1 thread / fast", "fftw/2/1/2048", "ten_fast/2/16384/1024",
          0.2},
         {"ten of them, with radial statistics: FFTW on 2 threads / fast", "fftw/2/2/2048", "ten_fast/2/16384/1024",
          0.2},
         {"65,536 points at 256^3: FFTW's 384^3 on 2 threads / fast", "fftw/3/2/384", "fast/3/65536/256", 1 / 1.5},
         {"a line at 256^3: FFTW's estimated plan / measured", "fftw_line/384/0", "fftw_line/384/1"},
         {"a line at 1,024^2: FFTW's estimated plan / measured", "fftw_line/1280/0", "fftw_line/1280/1"},
         {"a line at 8,192^2: FFTW's estimated plan / measured", "fftw_line/10240/0", "fftw_line/10240/1"}});
}
