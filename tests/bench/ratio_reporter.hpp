// A benchmark's main function that ends with ratios: machines are noisy, ratios of medians within one run are
// not. Limits of single figures are for what does not depend on the machine, or for a quiet one with two cores. A
// benchmark that ends by an error is named, and makes main fail.
#pragma once

#include "tests/bench/caught_errors.hpp"

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
    std::string counter = {}; ///< is compared instead of times
};

/// "the median time of a benchmark, in its unit, is at most that".
struct Limit
{
    std::string what;
    std::string name;
    double most = 0;
    std::string counter = {}; ///< is compared instead of the time
};

/// Prints as usual, and remembers the median real time of each benchmark, its counters, and which ended by an error.
class RatioReporter : public benchmark::ConsoleReporter
{
public:
    void ReportRuns(const std::vector<Run>& runs) override
    {
        ConsoleReporter::ReportRuns(runs);
        for (const Run& run : runs) {
            if (run.error_occurred) errors_[run.run_name.str()] = run.error_message;
            if (run.error_occurred) continue;
            if (run.aggregate_name != "median" && run.repetitions > 1) continue;
            auto& figures = figures_[name_of(run)];
            figures[""] = run.GetAdjustedRealTime();
            for (const auto& [name, counter] : run.counters) figures[name] = counter;
        }
    }

    /// Returns whether all benchmarks ended well and all targets are reached.
    bool print(const std::vector<Ratio>& ratios, const std::vector<Limit>& limits) const
    {
        bool are_reached = errors_.empty();
        if (!ratios.empty() || !limits.empty()) std::printf("\nRatios of medians\n");
        for (const Ratio& ratio : ratios) {
            const double* slow = figure(ratio.slow, ratio.counter);
            const double* fast = figure(ratio.fast, ratio.counter);
            if (!slow || !fast) continue;
            const double found = *slow / *fast;
            are_reached = tell(ratio.what, found, "at least", ratio.target, found < ratio.target) && are_reached;
        }
        for (const Limit& limit : limits)
            if (const double* found = figure(limit.name, limit.counter))
                are_reached = tell(limit.what, *found, "at most", limit.most, *found > limit.most) && are_reached;
        for (const auto& [benchmark, error] : errors_)
            std::printf("  FAILED: %s: %s\n", benchmark.c_str(), error.c_str());
        return are_reached;
    }

private:
    /// "function/argument", without what only says how it was measured.
    static std::string name_of(const Run& run) { return run.run_name.function_name + "/" + run.run_name.args; }

    /// Null: it was not run.
    const double* figure(const std::string& benchmark, const std::string& counter) const
    {
        const auto found = figures_.find(benchmark);
        return found == figures_.end() ? nullptr : &found->second.at(counter);
    }

    static bool tell(const std::string& what, double found, const char* bound, double target, bool is_missed)
    {
        std::printf("  %-70s %6.2f", what.c_str(), found);
        if (target > 0) std::printf("  (target: %s %.2f%s)", bound, target, is_missed ? ", MISSED" : "");
        std::printf("\n");
        return !is_missed;
    }

    std::map<std::string, std::map<std::string, double>> figures_; ///< by counters; "": the time
    std::map<std::string, std::string> errors_;                    ///< of benchmarks that ended by one
};

/// The body of main. Returns 1 where a benchmark ends by an error or a target is missed.
inline int run_benchmarks(int argc, char** argv, const std::vector<Ratio>& ratios = {},
                          const std::vector<Limit>& limits = {})
{
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    RatioReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    return reporter.print(ratios, limits) ? 0 : 1;
}

}
