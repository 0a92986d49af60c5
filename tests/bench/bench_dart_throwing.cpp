// Dart throwing: kernels against the plain sequential algorithm and against the sequential reference.
#include "base/geometry/relative_radius.hpp"
#include "base/regions/region_text.hpp"
#include "host/sampling/cells/cell_hierarchy.hpp"
#include "host/sampling/dart_throwing.hpp"
#include "host/sampling/regions/region_bricks.hpp"
#include "tests/bench/plain_dart_throwing.hpp"
#include "tests/bench/ratio_reporter.hpp"
#include "tests/support/random_region.hpp"

#include <fmt/format.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace poissonlab::bench {
namespace {

constexpr std::uint32_t threads = 2;

/// The number of points that are thrown where their number is given.
constexpr std::size_t points_in(int dimension) { return dimension == 2 ? 16'384 : 65'536; }

template <int D>
DartThrowingRequest to_points(double relative_radius, std::uint32_t realization)
{
    DartThrowingRequest request;
    request.dimension = D;
    request.min_distance = min_distance_for(relative_radius, points_in(D), D);
    request.points = points_in(D);
    request.stream = stream_key(1, Purpose::dart_throwing, realization);
    return request;
}

template <int D>
DartThrowingRequest to_saturation(std::size_t expected_points, std::uint32_t realization)
{
    DartThrowingRequest request;
    request.dimension = D;
    request.min_distance = min_distance_for(saturation_relative_radius(D), expected_points, D);
    request.stream = stream_key(1, Purpose::dart_throwing, realization);
    return request;
}

/// The benchmark's argument is the relative radius in percent.
double relative_radius(const benchmark::State& state) { return static_cast<double>(state.range(0)) / 100; }

/// The benchmark's argument is about how many points a saturated set has.
std::size_t expected_points(const benchmark::State& state) { return static_cast<std::size_t>(state.range(0)); }

template <int D>
void plain(benchmark::State& state)
{
    const double min_distance = min_distance_for(relative_radius(state), points_in(D), D);
    std::uint64_t seed = 0;
    for (auto _ : state) benchmark::DoNotOptimize(plain_dart_throwing<D>(points_in(D), min_distance, ++seed));
}

template <int D>
void sequential_reference(benchmark::State& state)
{
    std::uint32_t realization = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(reference::throw_darts(to_points<D>(relative_radius(state), ++realization)));
}

template <int D>
void kernel(benchmark::State& state)
{
    DartThrower thrower(Device::open({}, threads));
    std::uint32_t realization = 0;
    thrower.throw_darts(to_points<D>(relative_radius(state), realization)); // builds the kernels
    for (auto _ : state)
        benchmark::DoNotOptimize(thrower.throw_darts(to_points<D>(relative_radius(state), ++realization)));
}

template <int D>
void reference_to_saturation(benchmark::State& state)
{
    std::uint32_t realization = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(reference::throw_darts(to_saturation<D>(expected_points(state), ++realization)));
}

template <int D>
void kernel_to_saturation(benchmark::State& state)
{
    DartThrower thrower(Device::open({}, threads));
    std::uint32_t realization = 0;
    thrower.throw_darts(to_saturation<D>(expected_points(state), realization));
    for (auto _ : state)
        benchmark::DoNotOptimize(thrower.throw_darts(to_saturation<D>(expected_points(state), ++realization)));
}

/// Asks for the same set in a polygon of 10,000 corners with three holes and an island: distances become as much
/// smaller as its area is. The region is made ready once.
void in_polygon(DartThrowingRequest& request)
{
    request.region = std::make_shared<const FixedRegion>(test::star_with_holes(1, 10'000, 1000));
    request.min_distance *= std::sqrt(request.region->area()) / (request.region->unit() * 0x1p32);
    // The region lies in a quarter of the torus, as programs place it: see choose_cells().
    request.block = DartBlock{{}, cell_hierarchy(request.min_distance, 2).cell_of(0x7fffffff) + 1};
}

/// Throws one set an iteration; each has at least so many points.
void throw_sets(benchmark::State& state, DartThrowingRequest& request, std::size_t least_points)
{
    DartThrower thrower(Device::open({}, threads));
    thrower.throw_darts(request); // builds the kernels
    std::uint32_t realization = 0;
    for (auto _ : state) {
        request.stream = stream_key(1, Purpose::dart_throwing, ++realization);
        const std::size_t points = thrower.throw_darts(request).size();
        if (points < least_points) throw std::runtime_error(fmt::format("only {} points have room", points));
    }
}

/// A million points at 0.75.
void million_points(benchmark::State& state)
{
    DartThrowingRequest request;
    request.points = 1'000'000;
    request.min_distance = min_distance_for(0.75, *request.points, 2);
    throw_sets(state, request, *request.points);
}

void plain_million_points(benchmark::State& state)
{
    std::uint64_t seed = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(plain_dart_throwing<2>(1'000'000, min_distance_for(0.75, 1'000'000, 2), ++seed));
}

/// Throws 100,000 points at a relative radius of 0.7, on the torus and in the polygon.
void many_darts(benchmark::State& state)
{
    DartThrowingRequest request;
    request.points = 100'000;
    request.min_distance = min_distance_for(0.7, *request.points, 2);
    if (state.range(0) == 1) in_polygon(request);
    throw_sets(state, request, *request.points);
}

/// The polygon with some million points, between which no further one fits.
void saturated_polygon(benchmark::State& state)
{
    DartThrowingRequest request;
    request.min_distance = min_distance_for(0.77, 1'000'000, 2);
    in_polygon(request);
    throw_sets(state, request, 1'000'000);
}

/// Asks for points at 0.7 in a region, by what programs take for it: bricks of cells where a cube of them around it
/// would be nearly empty.
void in_region(DartThrowingRequest& request, const PlaneRegion& region, std::size_t points, bool has_bricks)
{
    request.points = points;
    request.region = std::make_shared<const FixedRegion>(region);
    request.min_distance =
        min_distance_for(0.7, points, 2) * std::sqrt(request.region->area()) / (request.region->unit() * 0x1p32);
    const CellHierarchy cells = cell_hierarchy(request.min_distance, 2);
    if (has_bricks)
        request.bricks = bricks_of(*request.region, cells, SIZE_MAX);
    else
        request.block = DartBlock{{}, cells.cell_of(0x7fffffff) + 1};
}

/// 100,000 points in a square and, of as large an area, in a corridor that is 10,000 times longer than wide.
void long_corridor(benchmark::State& state)
{
    DartThrowingRequest request;
    const bool is_long = state.range(0) == 1;
    in_region(request, read_region(is_long ? "rectangle 0 0 10000 1" : "rectangle 0 0 100 100"), 100'000, is_long);
    throw_sets(state, request, *request.points);
}

/// A million points in a thousand islands, each a 32-gon, that lie at random in a square 300 times as large. Bricks are
/// found anew for each set, as commands do.
void thousand_islands(benchmark::State& state)
{
    std::mt19937 random(5);
    PlaneRegion islands;
    for (int i = 0; i < 1024; ++i) {
        RegionPolygon& island = islands.polygons.emplace_back();
        const double x = 100.0 * (i % 32) + static_cast<double>(random() % 90);
        const double y = 100.0 * (i / 32) + static_cast<double>(random() % 90);
        for (int corner = 0; corner < 32; ++corner)
            island.outline.push_back({x + 3 * std::cos(corner * M_PI / 16), y + 3 * std::sin(corner * M_PI / 16)});
    }
    DartThrowingRequest request;
    in_region(request, islands, 1'000'000, true);
    DartThrower thrower(Device::open({}, threads));
    thrower.throw_darts(request); // builds the kernels
    std::uint32_t realization = 0;
    for (auto _ : state) {
        in_region(request, islands, 1'000'000, true);
        request.stream = stream_key(1, Purpose::dart_throwing, ++realization);
        if (thrower.throw_darts(request).size() < 1'000'000) throw std::runtime_error("too few points have room");
    }
}

BENCHMARK(long_corridor)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime()->Repetitions(5);
BENCHMARK(thousand_islands)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1)->Repetitions(5);
BENCHMARK(saturated_polygon)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1)->Repetitions(5);
BENCHMARK(many_darts)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime()->Repetitions(5);
BENCHMARK(million_points)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1)->Repetitions(5);
BENCHMARK(plain_million_points)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
BENCHMARK_TEMPLATE(plain, 2)->Arg(70)->Arg(75)->Unit(benchmark::kMillisecond)->UseRealTime()->Repetitions(9);
BENCHMARK_TEMPLATE(sequential_reference, 2)
    ->Arg(70)
    ->Arg(75)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Repetitions(9);
BENCHMARK_TEMPLATE(kernel, 2)->Arg(70)->Arg(75)->Unit(benchmark::kMillisecond)->UseRealTime()->Repetitions(9);
BENCHMARK_TEMPLATE(reference_to_saturation, 2)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(1)
    ->Repetitions(3);
BENCHMARK_TEMPLATE(kernel_to_saturation, 2)
    ->Arg(16'384)
    ->Arg(131'072)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Repetitions(5);
BENCHMARK_TEMPLATE(kernel_to_saturation, 2)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(1)
    ->Repetitions(5);
BENCHMARK_TEMPLATE(plain, 3)->Arg(75)->Unit(benchmark::kMillisecond)->UseRealTime()->Repetitions(9);
BENCHMARK_TEMPLATE(kernel, 3)->Arg(75)->Unit(benchmark::kMillisecond)->UseRealTime()->Repetitions(9);
BENCHMARK_TEMPLATE(reference_to_saturation, 3)
    ->Arg(65'536)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(1)
    ->Repetitions(5);
BENCHMARK_TEMPLATE(kernel_to_saturation, 3)
    ->Arg(65'536)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(1)
    ->Repetitions(5);

}
}

int main(int argc, char** argv)
{
    return poissonlab::bench::run_benchmarks(
        argc, argv,
        {{"16,384 points at 0.75: plain sequential / kernel", "plain<2>/75", "kernel<2>/75", 4.0},
         {"16,384 points at 0.75: sequential reference / kernel", "sequential_reference<2>/75", "kernel<2>/75", 1.6},
         {"saturation, 1,000,000 points: sequential reference / kernel", "reference_to_saturation<2>/1000000",
          "kernel_to_saturation<2>/1000000", 3.0},
         {"saturation, time of 1,000,000 / of 16,384 points; N log N is 86.9", "kernel_to_saturation<2>/1000000",
          "kernel_to_saturation<2>/16384", 0.0},
         {"1,000,000 points at 0.75: plain sequential / kernel", "plain_million_points/", "million_points/", 4.0},
         {"100,000 darts in a polygon of 10,000 corners, part of the torus' speed", "many_darts/0", "many_darts/1",
          1.0 / 3},
         {"100,000 points in a square, part of the time in a corridor as large", "long_corridor/0", "long_corridor/1",
          1.0 / 2},
         {"3D, 65,536 points at 0.75: plain sequential / kernel", "plain<3>/75", "kernel<3>/75", 4.0},
         {"3D, saturation, 65,536 points: sequential reference / kernel", "reference_to_saturation<3>/65536",
          "kernel_to_saturation<3>/65536", 2.5}},
        {{"1,000,000 points at 0.75, ms", "million_points/", 1000},
         {"1,000,000 points to saturation in a polygon of 10,000 corners, ms", "saturated_polygon/", 3000},
         {"1,000,000 points in a thousand islands, ms", "thousand_islands/", 3000}});
}
