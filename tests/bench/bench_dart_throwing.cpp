// Dart throwing: kernels against the plain sequential algorithm and against the sequential reference.
#include "bench/plain_dart_throwing.hpp"
#include "bench/ratio_reporter.hpp"
#include "geometry/relative_radius.hpp"
#include "sampling/dart_throwing.hpp"

namespace poissonlab::bench {
namespace {

constexpr std::size_t points = 16384;
constexpr std::uint32_t threads = 2;

DartThrowingRequest to_points(double relative_radius, std::uint32_t realization)
{
    DartThrowingRequest request;
    request.min_distance = min_distance_for(relative_radius, points, 2);
    request.points = points;
    request.stream = stream_key(1, Purpose::dart_throwing, realization);
    return request;
}

DartThrowingRequest to_saturation(std::size_t expected_points, std::uint32_t realization)
{
    DartThrowingRequest request;
    request.min_distance = min_distance_for(saturation_relative_radius(2), expected_points, 2);
    request.stream = stream_key(1, Purpose::dart_throwing, realization);
    return request;
}

void plain(benchmark::State& state)
{
    const double min_distance = min_distance_for(static_cast<double>(state.range(0)) / 100, points, 2);
    std::uint64_t seed = 0;
    for (auto _ : state) benchmark::DoNotOptimize(plain_dart_throwing(points, min_distance, ++seed));
}

void sequential_reference(benchmark::State& state)
{
    std::uint32_t realization = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            reference::throw_darts(to_points(static_cast<double>(state.range(0)) / 100, ++realization)));
    }
}

void kernel(benchmark::State& state)
{
    DartThrower thrower(Device::open({}, threads));
    std::uint32_t realization = 0;
    thrower.throw_darts(to_points(0.7, realization)); // builds the kernels
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            thrower.throw_darts(to_points(static_cast<double>(state.range(0)) / 100, ++realization)));
    }
}

void reference_to_saturation(benchmark::State& state)
{
    std::uint32_t realization = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            reference::throw_darts(to_saturation(static_cast<std::size_t>(state.range(0)), ++realization)));
    }
}

void kernel_to_saturation(benchmark::State& state)
{
    DartThrower thrower(Device::open({}, threads));
    std::uint32_t realization = 0;
    thrower.throw_darts(to_saturation(static_cast<std::size_t>(state.range(0)), realization));
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            thrower.throw_darts(to_saturation(static_cast<std::size_t>(state.range(0)), ++realization)));
    }
}

BENCHMARK(plain)->Arg(70)->Arg(75)->Unit(benchmark::kMillisecond)->UseRealTime()->Repetitions(9);
BENCHMARK(sequential_reference)
    ->Arg(70)
    ->Arg(75)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Repetitions(9);
BENCHMARK(kernel)->Arg(70)->Arg(75)->Unit(benchmark::kMillisecond)->UseRealTime()->Repetitions(9);
BENCHMARK(reference_to_saturation)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(1)
    ->Repetitions(3);
BENCHMARK(kernel_to_saturation)
    ->Arg(16'384)
    ->Arg(131'072)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Repetitions(5);
BENCHMARK(kernel_to_saturation)
    ->Arg(1'000'000)
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
        {{"16,384 points at 0.75: plain sequential / kernel", "plain/75", "kernel/75",
          3.0},
         {"16,384 points at 0.75: sequential reference / kernel", "sequential_reference/75",
          "kernel/75", 1.6},
         {"saturation, 1,000,000 points: sequential reference / kernel",
          "reference_to_saturation/1000000", "kernel_to_saturation/1000000", 3.0},
         {"saturation, time of 1,000,000 / of 16,384 points; N log N is 86.9",
          "kernel_to_saturation/1000000", "kernel_to_saturation/16384", 0.0}});
}
