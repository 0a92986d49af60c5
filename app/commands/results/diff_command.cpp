// poissonlab diff: which numbers of two results changed beyond their error.
#include "app/commands/command.hpp"
#include "reports/diff/comparison_page.hpp"
#include "results/own_files.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

constexpr auto diff_notes =
    R"(OLD and NEW are output folders of the same experiment, or collections of such. Prints the numbers that changed
beyond their error over realizations (Welch's test, corrected for the number of tests: one false alarm in a hundred
comparisons), better or worse where that is known, and series that are new or missing. Numbers without chance are
compared exactly; times only between equal machines, devices and threads.
Exit status 4: something changed.
  poissonlab diff out/before out/after --out difference)";

struct DiffOptions
{
    std::filesystem::path before;
    std::filesystem::path after;
    std::filesystem::path out; ///< empty: no page
    bool json = false;
    bool all = false; ///< list numbers that did not change as well
};

/// Prints what changed between two results. Returns the exit status.
int diff(const DiffOptions& options)
{
    if (!options.out.empty()) check_output_folder(options.out, "diff: ");
    const auto [changed, text] = compare_runs(options.before, options.after, options.out,
                                              options.json  ? "json"
                                              : options.all ? "all"
                                                            : "table");
    fmt::print("{}", text);
    if (!options.out.empty() && !options.json) fmt::print("{}\n", (options.out / "diff.html").string());
    return changed ? exit_changed : 0;
}

}

Command diff_command()
{
    const auto o = std::make_shared<DiffOptions>();
    return {"diff",
            "Say which numbers of two results changed beyond their error",
            {{"OLD", &o->before, "An output folder"},
             {"NEW", &o->after, "Another one of the same experiment"},
             {"--out", &o->out, "Write a page there, diff.html", "DIR"},
             {"--json", &o->json, "Print JSON"},
             {"--all", &o->all, "List numbers that did not change as well"}},
            diff_notes,
            [o] { return diff(*o); }};
}

}
