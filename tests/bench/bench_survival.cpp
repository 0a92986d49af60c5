// The cost of storing every unit of work, and the gain of a second process.
//
// Plain: the same 1,000 sets of 4,096 points, made, written and analysed by a loop without units, schedule and
// checksums. Ranks: a sweep of 16 series on one rank and on two, of one thread each; times are those of the work
// without start and report, as the program's own events tell them.
#include "base/points/point_file.hpp"
#include "experiment/measuring/series_analysis.hpp"
#include "experiment/run/make_experiment.hpp"
#include "experiment/run/runner.hpp"
#include "tests/bench/ratio_reporter.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <tbb/parallel_invoke.h>

#include <cstdlib>
#include <fstream>

namespace poissonlab::bench {
namespace {

constexpr const char* many_units = "[analysis]\npoints = 4096\nrealizations = 1000\ntiming_runs = 1\n[[method]]\n"
                                   "sampler = \"dart-throwing\"\nrelative_radius = 0.7\n";

Experiment experiment_of_many_units() { return make_experiment(parse_config(many_units, "many.toml"), "", 0); }

void plain(benchmark::State& state)
{
    for (auto _ : state) {
        const TemporaryFolder folder;
        const Experiment experiment = experiment_of_many_units();
        const SeriesTask& task = experiment.series.front();
        const auto sampler = task.create();
        SeriesAnalysis analysis(task.label, false, experiment.analysis);
        for (std::uint32_t k = 0; k < task.realizations; ++k) {
            const PointSet points = sampler->sample(k);
            tbb::parallel_invoke([&] { analysis.add(points); },
                                 [&] { write_points(folder.path() / fmt::format("{}.dat", k), points, "plain"); });
        }
        analysis.measure_spectrum(analysis.mean_spectrum());
        analysis.measure_first();
        benchmark::DoNotOptimize(analysis.result());
        // Folders go when the process ends: removing files costs those that make new ones soon after.
        std::filesystem::rename(folder.path(), folder.path().string() + "-done");
    }
}

void stored(benchmark::State& state)
{
    for (auto _ : state) {
        const TemporaryFolder folder;
        Progress progress(Progress::Style::quiet);
        run_experiment(experiment_of_many_units(), folder.path() / "out", progress);
        std::filesystem::rename(folder.path(), folder.path().string() + "-done");
    }
}

void ranks(benchmark::State& state)
{
    if (mpiexec_file().empty()) return state.SkipWithError("there is no mpirun");
    std::string sweep = "[analysis]\npoints = 4096\nrealizations = 20\ntiming_runs = 1\n[[method]]\n"
                        "sampler = \"dart-throwing\"\nrelative_radius = [";
    for (int i = 60; i < 73; ++i) sweep += fmt::format("0.{}, ", i);
    sweep += "]\n[[method]]\nsampler = \"lloyd\"\niterations = [10, 20, 30]\n";
    for (auto _ : state) {
        const TemporaryFolder folder;
        folder.write("sweep.toml", sweep);
        const std::string command =
            fmt::format("cd {} && {} --allow-run-as-root -n {} {} run sweep.toml --threads 1 --json > events",
                        folder.path().string(), mpiexec_file(), state.range(0), program_file());
        if (std::system(command.c_str()) != 0) state.SkipWithError("mpirun failed");
        std::ifstream events(folder.path() / "events");
        double seconds = 0;
        for (std::string line; std::getline(events, line);) {
            const auto event = nlohmann::json::parse(line, nullptr, false);
            if (event.is_object() && event["event"] == "series") seconds = event["seconds"];
        }
        state.SetIterationTime(seconds);
        std::filesystem::rename(folder.path(), folder.path().string() + "-done");
    }
}
BENCHMARK(ranks)->Arg(1)->Arg(2)->UseManualTime()->Unit(benchmark::kSecond)->Iterations(1)->Repetitions(5);

BENCHMARK(plain)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1)->Repetitions(5);
BENCHMARK(stored)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1)->Repetitions(5);

}
}

int main(int argc, char** argv)
{
    return poissonlab::bench::run_benchmarks(argc, argv,
                                             {{"a plain loop / with every unit stored", "plain/", "stored/", 0.97},
                                              {"one rank / two ranks", "ranks/1", "ranks/2", 1.85}});
}
