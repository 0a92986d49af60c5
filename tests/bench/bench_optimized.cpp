// Methods of the years after the dissertation, 16,384 points: an iteration of Gaussian blue noise against a plain
// sequential program, a set by sample elimination, and a sweep of farthest point optimization.
//
// The floor of an iteration of Gaussian blue noise: a point has 106 neighbours within 5.8 sigma, and blocks of eight
// points meet 220, with 21 instructions each for all eight: 16,384 * 220 / 8 * 21 = 9.5 million vector instructions,
// 0.9 ms for a core that runs four at 2.6 GHz. Neighbours alone would take half of that.
//
// The floor of sample elimination: of the 52 candidates in the cells around one, 18 are within its reach. Each removal
// looks at those once to weigh, once to take its part off, and about twice for heavier ones: 81,920 * 4 * 52 places at
// a nanosecond each, and twice 18 weights at five, are 32 ms of one core, 16 of two. cySampleElim, the author's
// program, takes 0.5 s of one.
#include "host/sampling/optimized/farthest_point.hpp"
#include "host/sampling/optimized/gaussian_blue_noise.hpp"
#include "host/sampling/optimized/sample_elimination.hpp"
#include "tests/bench/plain_gaussian_blue_noise.hpp"
#include "tests/bench/ratio_reporter.hpp"
#include "tests/support/point_patterns.hpp"

#include <random>

namespace {

using namespace poissonlab;

constexpr std::size_t point_count = 16'384;
constexpr std::size_t iterations = 20;

PointSet start(std::size_t points, int dimension = 2)
{
    std::mt19937_64 random(1);
    return test::random_points_32(points, dimension, random);
}

void gaussian_steps(benchmark::State& state)
{
    GaussianBlueNoise method(Device::open());
    const PointSet points = start(point_count);
    for (auto _ : state)
        benchmark::DoNotOptimize(method.descend(points, {.iterations = iterations, .sigma = 1, .step = 0.25}));
}

void gaussian_steps_3d(benchmark::State& state)
{
    GaussianBlueNoise method(Device::open());
    const PointSet points = start(point_count, 3);
    for (auto _ : state)
        benchmark::DoNotOptimize(
            method.descend(points, {.iterations = iterations, .sigma = 1, .step = usual_gaussian_step(1, 3)}));
}

void plain_gaussian_steps(benchmark::State& state)
{
    const PointSet points = start(point_count);
    const float side = 128;
    for (auto _ : state) {
        std::vector<bench::PlainPoint> plain;
        for (std::size_t i = 0; i < points.size(); ++i)
            plain.push_back({static_cast<float>(points[i][0]) * side, static_cast<float>(points[i][1]) * side});
        for (std::size_t i = 0; i < iterations; ++i) bench::plain_gaussian_step(plain, 0.25F);
        benchmark::DoNotOptimize(plain.data());
    }
}

void elimination(benchmark::State& state)
{
    SampleElimination method(Device::open());
    const PointSet points = start(5 * point_count);
    for (auto _ : state)
        benchmark::DoNotOptimize(
            eliminate(points, point_count, [&](const PointSet& set, const EliminationReach& reach, std::size_t count) {
                return method.removal_order(set, reach, count);
            }));
}

void farthest_point_sweeps(benchmark::State& state)
{
    FarthestPointOptimization method(Device::open());
    const PointSet points = start(point_count);
    for (auto _ : state) benchmark::DoNotOptimize(method.optimize(points, {.iterations = 10}));
}

BENCHMARK(gaussian_steps)->Repetitions(7)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(gaussian_steps_3d)->Repetitions(5)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(plain_gaussian_steps)->Iterations(1)->Repetitions(3)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(elimination)->Repetitions(5)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(farthest_point_sweeps)->Iterations(1)->Repetitions(5)->Unit(benchmark::kMillisecond)->UseRealTime();

}

int main(int argc, char** argv)
{
    return poissonlab::bench::run_benchmarks(argc, argv,
                                             {{"20 iterations of Gaussian blue noise: time of plain / kernels",
                                               "plain_gaussian_steps/", "gaussian_steps/", 10}});
}
