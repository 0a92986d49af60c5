// The sampling test at the size of the dissertation: 262,144 points, 512 x 512 pixels.
#include "analysis/zone_plate/zone_plate_error.hpp"
#include "analysis/zone_plate/zone_plate_reference.hpp"
#include "tests/bench/ratio_reporter.hpp"
#include "tests/support/point_patterns.hpp"

namespace {

using namespace poissonlab;

/// Points in the order in which generators leave them: none.
PointSet one_point_a_pixel(int size)
{
    std::mt19937_64 random(1);
    return test::random_points(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), 2, random);
}

void image(benchmark::State& state)
{
    const auto points = one_point_a_pixel(static_cast<int>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(zone_plate_image(points));
}

void reference(benchmark::State& state)
{
    for (auto _ : state) benchmark::DoNotOptimize(zone_plate_reference(static_cast<int>(state.range(0))));
}

void error(benchmark::State& state)
{
    const auto picture = zone_plate_image(one_point_a_pixel(static_cast<int>(state.range(0))));
    ZonePlateError errors;
    errors.add(picture); // the reference is made once
    for (auto _ : state) benchmark::DoNotOptimize(errors.add(picture));
}

BENCHMARK(image)->Arg(512)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(reference)->Arg(512)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(error)->Arg(512)->Unit(benchmark::kMillisecond)->UseRealTime();

}

int main(int argc, char** argv) { return poissonlab::bench::run_benchmarks(argc, argv); }
