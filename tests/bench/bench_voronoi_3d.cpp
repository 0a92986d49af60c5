// Voronoi cells in 3D: one Lloyd step's cells by the kernels, against voro++ on one thread.
#include "host/sampling/cells/voronoi_cells.hpp"
#include "tests/bench/ratio_reporter.hpp"

#ifdef POISSONLAB_VOROPP
#include <voro++/voro++.hh>
#endif

#include <algorithm>
#include <cmath>
#include <random>

namespace poissonlab::bench {
namespace {

constexpr std::size_t points = 65536;
constexpr std::uint32_t threads = 2;
constexpr std::size_t work_group_size = 64;
constexpr int lloyd_steps = 20;

enum Distribution
{
    random_points = 0,
    well_spread_points = 1
};

PointSet moved_to_centroids(const PointSet& set, const VoronoiCells& cells)
{
    PointSet moved = set;
    for (std::size_t i = 0; i < moved.coordinates.size(); ++i) {
        double& c = moved.coordinates[i];
        c += cells.displacements[i];
        c -= std::floor(c);
        if (c >= 1) c = 0;
    }
    return moved;
}

PointSet points_of(std::int64_t distribution)
{
    PointSet set{3, {}};
    std::mt19937_64 engine(1);
    for (std::size_t i = 0; i < 3 * points; ++i) {
        set.coordinates.push_back(static_cast<double>(engine() >> 11) * 0x1p-53);
    }
    if (distribution == random_points) return set;
    for (int step = 0; step < lloyd_steps; ++step) {
        set = moved_to_centroids(set, voronoi_cells(Device::open({}, threads), set));
    }
    return set;
}

void kernel(benchmark::State& state)
{
    const PointSet set = points_of(state.range(0));
    Device device = Device::open({}, threads);
    PointGrid grid(device, 3, points, VoronoiKernels::cells_per_axis(3, points), work_group_size);
    VoronoiKernels kernels(device, 3, points, work_group_size);
    grid.load(set);
    grid.sort();
    kernels.find_cells(grid);
    device.finish();
    for (auto _ : state) {
        grid.sort();
        kernels.find_cells(grid);
        device.finish();
    }
    state.counters["slow"] = static_cast<double>(kernels.slow_points());
}
BENCHMARK(kernel)
    ->Arg(random_points)
    ->Arg(well_spread_points)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Repetitions(9);

#ifdef POISSONLAB_VOROPP
void voropp(benchmark::State& state)
{
    const PointSet set = points_of(state.range(0));
    const int blocks = static_cast<int>(std::cbrt(static_cast<double>(points) / 6));
    for (auto _ : state) {
        voro::container container(0, 1, 0, 1, 0, 1, blocks, blocks, blocks, true, true, true, 8);
        for (std::size_t i = 0; i < points; ++i) {
            container.put(static_cast<int>(i), set[i][0], set[i][1], set[i][2]);
        }
        voro::voronoicell cell;
        voro::c_loop_all loop(container);
        double total = 0;
        double x = 0, y = 0, z = 0;
        if (loop.start()) {
            do {
                if (!container.compute_cell(cell, loop)) continue;
                total += cell.volume();
                cell.centroid(x, y, z);
                benchmark::DoNotOptimize(x);
            } while (loop.inc());
        }
        if (std::abs(total - 1) > 1e-9) state.SkipWithError("volumes do not sum to 1");
    }
}
BENCHMARK(voropp)
    ->Arg(random_points)
    ->Arg(well_spread_points)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(1)
    ->Repetitions(5);
#endif

}
}

int main(int argc, char** argv)
{
    return poissonlab::bench::run_benchmarks(
        argc, argv,
        {{"65,536 random points: voro++ on 1 thread / kernels on 2", "voropp/0", "kernel/0", 3.0},
         {"65,536 well-spread points: voro++ on 1 thread / kernels on 2", "voropp/1", "kernel/1", 3.0}});
}
