// One Lloyd iteration in 2D: kernels against CGAL.
#include "base/geometry/relative_radius.hpp"
#include "host/sampling/cells/voronoi_cells.hpp"
#include "host/sampling/dart_throwing.hpp"
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

}
}

int main(int argc, char** argv)
{
    return poissonlab::bench::run_benchmarks(
        argc, argv,
        {{"16,384 well-spread points: CGAL periodic / kernels", "cgal_periodic/16384/1", "kernels/16384/1", 40},
         {"16,384 well-spread points: CGAL with ghosts / kernels", "cgal_ghosts/16384/1", "kernels/16384/1", 8},
         {"262,144 well-spread points: CGAL periodic / kernels", "cgal_periodic/262144/1", "kernels/262144/1", 40},
         {"262,144 well-spread points: CGAL with ghosts / kernels", "cgal_ghosts/262144/1", "kernels/262144/1", 6},
         {"16,384 random points: CGAL periodic / kernels", "cgal_periodic/16384/0", "kernels/16384/0", 20},
         {"16,384 random points: CGAL with ghosts / kernels", "cgal_ghosts/16384/0", "kernels/16384/0", 6},
         {"262,144 random points: CGAL periodic / kernels", "cgal_periodic/262144/0", "kernels/262144/0", 20},
         {"262,144 random points: CGAL with ghosts / kernels", "cgal_ghosts/262144/0", "kernels/262144/0", 3}});
}
