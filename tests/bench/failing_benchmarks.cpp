// Benchmarks that end by errors, for the test of what is said of them.
#include "tests/bench/ratio_reporter.hpp"

#include <stdexcept>

namespace {

void thrown(benchmark::State& state)
{
    for (auto _ : state) throw std::runtime_error("no room left");
}

void thrown_before(benchmark::State&, const char* what) { throw std::runtime_error(what); }

template <int N>
void done(benchmark::State& state)
{
    for (auto _ : state) benchmark::DoNotOptimize(N);
}

BENCHMARK(thrown)->Iterations(1)->Repetitions(2);
BENCHMARK_CAPTURE(thrown_before, starting, "no device")->Iterations(1);
BENCHMARK_TEMPLATE(done, 3)->Iterations(1);

}

int main(int argc, char** argv)
{
    return poissonlab::bench::run_benchmarks(argc, argv, {{"itself", "done<3>/", "done<3>/", 0.5}});
}
