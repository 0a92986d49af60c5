// poissonlab export: plots for papers, and point sets for other programs.
#include "app/commands/command.hpp"
#include "experiment/run/progress.hpp"
#include "reports/site/export.hpp"
#include "results/own_files.hpp"

namespace poissonlab {
namespace {

constexpr auto export_notes =
    R"(Every plot of the report becomes a .csv (curve, x, y, and what it has of low and high ends and dots) and a .tex, a
tikzpicture that \input puts into a paper that uses pgfplots. Every stored point set becomes a .csv and a .usda, a point
instancer of USD. Without --plots and --points, all of this is written.
  poissonlab export out/quick --out for-the-paper --plots)";

struct ExportOptions
{
    std::vector<std::filesystem::path> folders;
    std::filesystem::path out;
    bool plots = false;
    bool points = false;
    bool gallery = false;
    bool claims = false;
    bool quiet = false;
};

void export_files(const ExportOptions& options)
{
    check_output_folder(options.out, "export: ");
    Progress progress(Progress::detect(options.quiet));
    const bool all = !options.plots && !options.points && !options.gallery && !options.claims;
    export_results(options.folders, options.out,
                   {all || options.plots, all || options.points, options.gallery, options.claims},
                   [&](const std::string& step) { progress.step("export: " + step); });
    progress.report(options.out.string());
}

}

Command export_command()
{
    const auto o = std::make_shared<ExportOptions>();
    return {
        "export",
        "Write plots for LaTeX and as CSV, and point sets as CSV and USD",
        {{"DIR", &o->folders, "Folders that `run` or `analyze` wrote"},
         {"--out", &o->out, "Where the files go", "DIR", required},
         {"--plots", &o->plots, "Only plots"},
         {"--points", &o->points, "Only point sets"},
         {"--gallery", &o->gallery, "The tables of a gallery of reference curves instead"},
         {"--claims", &o->claims, "Write the claims of papers and what the results say of them, claims.csv, instead"},
         {"--quiet", &o->quiet, "Print nothing but errors and the path"}},
        export_notes,
        action_on(o, export_files)};
}

}
