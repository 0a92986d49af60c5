// One Lloyd iteration in 2D: kernels against CGAL.
#include "base/geometry/relative_radius.hpp"
#include "host/sampling/cells/voronoi_cells.hpp"
#include "host/sampling/dart_throwing.hpp"
#include "host/sampling/lloyd_sets.hpp"
#include "tests/bench/cgal_lloyd_2d.hpp"
#include "tests/bench/ratio_reporter.hpp"
#include "tests/support/point_patterns.hpp"

#include <map>

namespace poissonlab::bench {
namespace {

constexpr std::uint32_t threads = 2;

/// Uniformly random points (spread 0), or dart throwing at 0.75 (spread 1).
const PointSet& points_of(benchmark::State& state)
{
    static std::map<std::pair<std::int64_t, std::int64_t>, PointSet> sets;
    const auto n = static_cast<std::size_t>(state.range(0));
    PointSet& set = sets[{state.range(0), state.range(1)}];
    if (set.size() == n) return set;
    if (state.range(1) == 0) {
        std::mt19937_64 random(1);
        return set = test::random_points(n, 2, random);
    }
    DartThrowingRequest request;
    request.min_distance = min_distance_for(0.75, n, 2);
    request.points = n;
    request.stream = stream_key(1, Purpose::dart_throwing, 0);
    return set = DartThrower(Device::open({}, threads)).throw_darts(request);
}

std::vector<CgalPoint> to_cgal(const PointSet& points)
{
    std::vector<CgalPoint> result;
    for (std::size_t i = 0; i < points.size(); ++i) result.emplace_back(points[i][0], points[i][1]);
    return result;
}

void cgal_periodic(benchmark::State& state)
{
    const auto points = to_cgal(points_of(state));
    for (auto _ : state) benchmark::DoNotOptimize(cgal_periodic_centroids(points));
}

void cgal_ghosts(benchmark::State& state)
{
    const auto points = to_cgal(points_of(state));
    for (auto _ : state) benchmark::DoNotOptimize(cgal_ghost_centroids(points));
}

void kernels(benchmark::State& state)
{
    const PointSet& points = points_of(state);
    Device device = Device::open({}, threads);
    PointGrid grid(device, 2, points.size(), VoronoiKernels::cells_per_axis(2, points.size()), 64);
    VoronoiKernels voronoi(device, 2, points.size(), 64);
    grid.load(points);
    for (auto _ : state) {
        grid.sort();
        voronoi.find_cells(grid);
        device.finish();
    }
    state.counters["slow"] = static_cast<double>(voronoi.slow_points());
}

/// Runs the kernels of VoronoiKernels as devices with and without double precision have them (range 2: 1 or 0), see
/// kernels/common/reals.clh.
void kernels_of_devices(benchmark::State& state)
{
    const PointSet& points = points_of(state);
    const std::size_t n = points.size();
    Device device = Device::open({}, threads);
    const std::uint32_t size = VoronoiKernels::cells_per_axis(2, n);
    PointGrid grid(device, 2, n, size, 64);
    grid.load(points);
    grid.sort();
    const KernelProgram program = kernel_program("voronoi_2d.cl", {{"DOUBLES", state.range(2)}});
    Kernel forget = device.kernel(program, "forget_slow");
    Kernel fast = device.kernel(program, "find_centroids_fast");
    Kernel slow = device.kernel(program, "find_centroids");
    Buffer<double> areas = device.buffer<double>(n);
    Buffer<double> displacements = device.buffer<double>(2 * n);
    Buffer<double> energies = device.buffer<double>(n);
    Buffer<double> squared_near = device.buffer<double>(n);
    Buffer<std::uint32_t> list = device.buffer<std::uint32_t>(n);
    Buffer<std::uint32_t> count = device.buffer<std::uint32_t>(1);
    Buffer<std::uint32_t> unknown = device.buffer<std::uint32_t>(1);
    const float width = std::nextafter(static_cast<float>(0x1p32 / size), 0.0f);
    constexpr std::uint32_t run = 64;
    for (auto _ : state) {
        forget.run(1, 1, count, unknown);
        fast.run((grid.cells() + run - 1) / run, 1, grid.positions(), grid.fixed_point(), grid.stride(), grid.starts(),
                 grid.part(), width, run, areas, displacements, energies, squared_near, list, count);
        slow.run(256, 1, grid.positions(), grid.ids(), grid.starts(), grid.part(), list, count, areas, displacements,
                 energies, squared_near, unknown);
        device.finish();
    }
}

/// The benchmark's arguments are the points of a set, and the number of sets that are relaxed. The counter has the time
/// of an iteration of 16,384 points, in whichever sets they are.
void iterations(benchmark::State& state)
{
    std::mt19937_64 random(1);
    const auto points = static_cast<std::size_t>(state.range(0));
    const std::vector<PointSet> sets(static_cast<std::size_t>(state.range(1)), test::random_points(points, 2, random));
    const LloydRequest request{.iterations = std::max<std::size_t>(64, 65'536 / points)};
    Device device = Device::open({}, threads);
    for (auto _ : state) {
        if (LloydSets::are_faster(device.info(), sets.size(), points))
            benchmark::DoNotOptimize(LloydSets(device).relax(sets, request.iterations));
        else
            for (const PointSet& set : sets) benchmark::DoNotOptimize(LloydRelaxation(device).relax(set, {}, request));
    }
    state.counters["share"] =
        benchmark::Counter(static_cast<double>(sets.size() * points * request.iterations) / 16'384,
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void sets(benchmark::internal::Benchmark* benchmark)
{
    for (const std::int64_t n : {16384, 262144}) {
        for (const std::int64_t spread : {0, 1}) benchmark->Args({n, spread});
    }
    benchmark->Unit(benchmark::kMillisecond)->UseRealTime()->Repetitions(5);
}

BENCHMARK(cgal_periodic)->Apply(sets);
BENCHMARK(cgal_ghosts)->Apply(sets);
BENCHMARK(kernels)->Apply(sets);
BENCHMARK(iterations)
    ->Args({256, 10})
    ->Args({1024, 10})
    ->Args({4096, 10})
    ->Args({16384, 1})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Repetitions(5);
BENCHMARK(kernels_of_devices)
    ->Args({16384, 1, 0})
    ->Args({16384, 1, 1})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Repetitions(5);

}
}

int main(int argc, char** argv)
{
    return poissonlab::bench::run_benchmarks(
        argc, argv,
        {{"16,384 well-spread points: CGAL periodic / kernels", "cgal_periodic/16384/1", "kernels/16384/1", 40},
         {"16,384 well-spread points: CGAL with ghosts / kernels", "cgal_ghosts/16384/1", "kernels/16384/1", 8},
         {"16,384 well-spread points: without double precision, time of integers / doubles",
          "kernels_of_devices/16384/1/0", "kernels_of_devices/16384/1/1", 0},
         {"262,144 well-spread points: CGAL periodic / kernels", "cgal_periodic/262144/1", "kernels/262144/1", 40},
         {"262,144 well-spread points: CGAL with ghosts / kernels", "cgal_ghosts/262144/1", "kernels/262144/1", 6},
         {"Lloyd iterations of ten sets of 256 points: part of the speed, by points, of 16,384", "iterations/16384/1",
          "iterations/256/10", 0.7, "share"},
         {"Lloyd iterations of ten sets of 1,024 points: part of the speed, by points, of 16,384", "iterations/16384/1",
          "iterations/1024/10", 0.7, "share"},
         {"Lloyd iterations of ten sets of 4,096 points: part of the speed, by points, of 16,384", "iterations/16384/1",
          "iterations/4096/10", 0.7, "share"},
         {"16,384 random points: CGAL periodic / kernels", "cgal_periodic/16384/0", "kernels/16384/0", 20},
         {"16,384 random points: CGAL with ghosts / kernels", "cgal_ghosts/16384/0", "kernels/16384/0", 6},
         {"262,144 random points: CGAL periodic / kernels", "cgal_periodic/262144/0", "kernels/262144/0", 20},
         {"262,144 random points: CGAL with ghosts / kernels", "cgal_ghosts/262144/0", "kernels/262144/0", 3}});
}
