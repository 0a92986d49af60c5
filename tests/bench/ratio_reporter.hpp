// A benchmark's main function that ends with ratios: machines are noisy, ratios of medians within one run are
// not.
#pragma once

#include <benchmark/benchmark.h>

#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace poissonlab::bench {

/// "slow takes at least `target` times as long as fast", by the names of two benchmarks. 0: only to know.
struct Ratio
{
    std::string what;
    std::string slow;
    std::string fast;
    double target = 0;
};

/// Prints as usual, and remembers the median real time of each benchmark.
class RatioReporter : public benchmark::ConsoleReporter
{
public:
    void ReportRuns(const std::vector<Run>& runs) override
    {
        ConsoleReporter::ReportRuns(runs);
        for (const Run& run : runs) {
            if (run.aggregate_name == "median") medians_[name_of(run)] = run.GetAdjustedRealTime();
        }
    }

    /// Returns whether all targets are reached.
    bool print(const std::vector<Ratio>& ratios) const
    {
        bool are_reached = true;
        std::printf("\nRatios of medians\n");
        for (const Ratio& ratio : ratios) {
            const auto slow = medians_.find(ratio.slow);
            const auto fast = medians_.find(ratio.fast);
            if (slow == medians_.end() || fast == medians_.end()) continue;
            const double found = slow->second / fast->second;
            const bool is_missed = found < ratio.target;
            std::printf("  %-70s %6.2f", ratio.what.c_str(), found);
            if (ratio.target > 0) std::printf("  (target: at least %.2f%s)", ratio.target, is_missed ? ", MISSED" : "");
            std::printf("\n");
            are_reached = are_reached && !is_missed;
        }
        return are_reached;
    }

private:
    /// "function/argument", without what only says how it was measured.
    static std::string name_of(const Run& run) { return run.run_name.function_name + "/" + run.run_name.args; }

    std::map<std::string, double> medians_;
};

/// The body of main. Returns 1 where a target is missed.
inline int run_benchmarks(int argc, char** argv, const std::vector<Ratio>& ratios)
{
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    RatioReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    return reporter.print(ratios) ? 0 : 1;
}

}
