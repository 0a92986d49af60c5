// poissonlab analyze: point sets made elsewhere, through the same analysis and report.
#include "app/commands/commands.hpp"
#include "base/errors/errors.hpp"
#include "host/crew/thread_limit.hpp"
#include "host/run/runner.hpp"
#include "host/series/imported_points.hpp"

namespace poissonlab {

void analyze_command(const AnalyzeOptions& options)
{
    const ThreadLimit limit(options.threads);
    std::optional<CoordinateRange> domain;
    if (!options.domain.empty()) {
        domain = parse_range(options.domain);
        if (!domain)
            throw InputError("--domain " + options.domain +
                             ": must be LOW:HIGH, two numbers, the first smaller; or HIGH");
    }
    Experiment experiment = import_points(options.files, options.label, domain);
    experiment.overrides = options.overrides;
    experiment.analysis = overridden_analysis(options.overrides, experiment.dimension);
    experiment.command = options.command;
    const auto out = options.out.empty() ? std::filesystem::path("out") / experiment.series.front().name : options.out;
    Progress progress(Progress::detect(options.quiet));
    run_experiment(experiment, out, progress);
    finish_report({out}, out, progress);
}

}
