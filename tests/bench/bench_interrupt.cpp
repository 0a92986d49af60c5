// The time that the program takes to end after Ctrl-C, at random moments of its longest pieces of work: a second at
// most, or this benchmark fails.
#include "tests/bench/ratio_reporter.hpp"
#include "tests/support/started_program.hpp"
#include "tests/support/temporary_folder.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <random>
#include <thread>

namespace poissonlab::bench {
namespace {

using Seconds = std::chrono::duration<double>;

/// Work for at least a minute.
struct Work
{
    const char* name;
    const char* config;
};

constexpr Work works[] = {
    {"Lloyd relaxation", "[analysis]\npoints = 65536\nspectrum = \"none\"\n[[method]]\nsampler = \"lloyd\"\n"
                         "iterations = 1000000\nstart = \"random\"\n"},
    {"Lloyd relaxation in 3D", "[analysis]\npoints = 65536\ndimension = 3\nspectrum = \"none\"\n[[method]]\n"
                               "sampler = \"lloyd\"\niterations = 1000000\nstart = \"random\"\n"},
    {"dart throwing", "[analysis]\npoints = 1000000\nrealizations = 1000\nspectrum = \"none\"\n[[method]]\n"
                      "sampler = \"dart-throwing\"\nrelative_radius = 0.7\n"},
    {"a tile set", "[analysis]\npoints = 4096\n[[method]]\nsampler = \"corner-tiles\"\ncolors = 4\n"
                   "points_per_tile = 256\nlloyd_iterations = 100000\n"},
    {"a spectrum", "[analysis]\npoints = 1000000\nrealizations = 10\nspectrum_size = 4096\nspectrum = \"exact\"\n"
                   "[[method]]\nsampler = \"random\"\n"},
};

constexpr double limit = 1;            // second
bool is_late = false, is_deaf = false; ///< any run: reports have aggregates only

void interrupted(benchmark::State& state)
{
    const Work& work = works[state.range(0)];
    state.SetLabel(work.name);
    static std::mt19937 random(20261122);
    for (auto _ : state) {
        const TemporaryFolder folder;
        folder.write("c.toml", work.config);
        StartedProgram program(folder.path(), {"run", "c.toml"});
        std::this_thread::sleep_for(Seconds(std::uniform_real_distribution(0.5, 2.5)(random)));
        const auto begin = std::chrono::steady_clock::now();
        program.send(SIGINT);
        const int status = program.wait();
        const double taken = Seconds(std::chrono::steady_clock::now() - begin).count();
        state.SetIterationTime(taken);
        is_late = is_late || taken > limit;
        is_deaf = is_deaf || !WIFEXITED(status) || WEXITSTATUS(status) != 130;
    }
}
BENCHMARK(interrupted)
    ->DenseRange(0, std::size(works) - 1)
    ->UseManualTime()
    ->Iterations(1)
    ->Repetitions(10)
    ->ComputeStatistics("max", [](const std::vector<double>& v) { return *std::max_element(v.begin(), v.end()); })
    ->ReportAggregatesOnly()
    ->Unit(benchmark::kMillisecond);

}
}

int main(int argc, char** argv)
{
    using namespace poissonlab::bench;
    const int status = run_benchmarks(argc, argv);
    if (is_late) std::printf("\nCtrl-C took longer than a second: MISSED\n");
    if (is_deaf) std::printf("\nWork went on after Ctrl-C, or ended by an error: FAILED\n");
    return is_late || is_deaf ? 1 : status;
}
