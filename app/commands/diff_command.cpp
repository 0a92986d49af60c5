// poissonlab diff: which numbers of two results changed beyond their error.
#include "app/commands/commands.hpp"
#include "reports/diff/compare_runs.hpp"

#include <fmt/format.h>

namespace poissonlab {

bool diff_command(const DiffOptions& options)
{
    const auto [changed, text] = compare_runs(options.before, options.after, options.out,
                                              options.json  ? "json"
                                              : options.all ? "all"
                                                            : "table");
    fmt::print("{}", text);
    if (!options.out.empty() && !options.json) fmt::print("{}\n", (options.out / "diff.html").string());
    return changed;
}

}
