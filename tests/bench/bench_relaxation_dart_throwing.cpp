// Relaxation dart throwing: kernels against the sequential reference.
#include "host/sampling/relaxation_dart_throwing.hpp"
#include "tests/bench/ratio_reporter.hpp"

namespace poissonlab::bench {
namespace {

constexpr std::uint32_t threads = 2;

/// Factor 1 - 10^-digits after 10^(digits + 1) failures: the three settings of the dissertation.
RelaxationDartThrowingRequest request_for(std::int64_t digits, std::uint32_t realization)
{
    RelaxationDartThrowingRequest request;
    request.points = 16384;
    request.factor = digits == 1 ? 0.9 : digits == 2 ? 0.99 : 0.999;
    request.attempts = digits == 1 ? 100 : digits == 2 ? 1'000 : 10'000;
    request.stream = stream_key(1, Purpose::relaxation_dart_throwing, realization);
    return request;
}

void sequential_reference(benchmark::State& state)
{
    std::uint32_t realization = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(reference::throw_relaxation_darts(request_for(state.range(0), ++realization)));
    }
}

void kernel(benchmark::State& state)
{
    RelaxationDartThrower thrower(Device::open({}, threads));
    std::uint32_t realization = 0;
    thrower.throw_darts(request_for(1, realization)); // builds the kernels
    for (auto _ : state) benchmark::DoNotOptimize(thrower.throw_darts(request_for(state.range(0), ++realization)));
}

/// Kernel and reference take turns, so that what else the machine does slows both.
void in_turns(int digits, int repetitions)
{
    const auto add = [&](const char* name, void (*function)(benchmark::State&)) {
        benchmark::RegisterBenchmark(name, caught(function))
            ->Arg(digits)
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime()
            ->Repetitions(repetitions);
    };
    add("sequential_reference", sequential_reference);
    add("kernel", kernel);
}

}
}

int main(int argc, char** argv)
{
    using namespace poissonlab::bench;
    in_turns(1, 9);
    in_turns(2, 9);
    in_turns(3, 5);
    return run_benchmarks(
        argc, argv,
        {{"16,384 points, 0.9 after 100: sequential reference / kernel", "sequential_reference/1", "kernel/1", 1.0},
         {"16,384 points, 0.99 after 1,000: sequential reference / kernel", "sequential_reference/2", "kernel/2", 1.0},
         {"16,384 points, 0.999 after 10,000: sequential reference / kernel", "sequential_reference/3", "kernel/3",
          1.8}});
}
