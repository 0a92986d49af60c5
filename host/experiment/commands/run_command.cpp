// poissonlab run: a config's experiment, or a collection of them, and the report.
#include "experiment/commands/commands.hpp"
#include "experiment/config_run.hpp"
#include "experiment/runner.hpp"
#include "experiment/thread_limit.hpp"

namespace poissonlab {

void run_command(const RunOptions& options, const ReportWriter& write_report)
{
    const ThreadLimit limit(options.threads);
    if (const auto collection = read_collection(options.config, options.overrides))
        return run_collection(*collection, options, write_report);
    const Config config = read_config(options.config, options.overrides);
    const auto stem = std::filesystem::path(options.config).stem();
    const auto out = options.out.empty() ? "out" / stem : options.out;

    Experiment experiment = make_experiment(config, options.device.empty() ? config.device : options.device,
                                            static_cast<unsigned>(options.threads));
    experiment.command = options.command;
    Progress progress(Progress::detect(options.quiet));
    run_experiment(experiment, out, progress);
    finish_report({out}, out, write_report, progress);
}

}
