// The memory that Lloyd relaxation needs: the process' peak, with all that OpenCL and the start take.
//
// A benchmark of its own, since a peak does not fall: nothing else may run before it in its process.
#include "host/sampling/lloyd_relaxation.hpp"
#include "tests/bench/ratio_reporter.hpp"
#include "tests/support/point_patterns.hpp"

#include <sys/resource.h>

namespace poissonlab::bench {
namespace {

double peak_mebibytes()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024; // Linux: KiB
}

/// Four million points, from random ones.
void lloyd_in_2d(benchmark::State& state)
{
    std::mt19937_64 random(1);
    const PointSet start = test::random_points(4194304, 2, random);
    LloydRelaxation lloyd(Device::open());
    for (auto _ : state) {
        LloydRequest request;
        request.iterations = 4;
        request.keep_best = true;
        benchmark::DoNotOptimize(lloyd.relax(start, Domain{}, request));
    }
    state.counters["peak_MiB"] = peak_mebibytes();
}

BENCHMARK(lloyd_in_2d)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

}
}

int main(int argc, char** argv)
{
    return poissonlab::bench::run_benchmarks(
        argc, argv, {}, {{"4,194,304 points: the process' peak, MiB", "lloyd_in_2d/", 1024, "peak_MiB"}});
}
