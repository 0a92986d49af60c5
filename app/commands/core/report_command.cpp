// poissonlab report: the report again, or one over several result folders.
#include "app/commands/command.hpp"
#include "app/commands/core/finish_report.hpp"
#include "base/errors/errors.hpp"
#include "results/own_files.hpp"

namespace poissonlab {
namespace {

struct ReportOptions
{
    std::vector<std::filesystem::path> folders;
    std::filesystem::path out; ///< empty: the folder, where there is one
    bool print = false;        ///< PNG of curves as well
    bool gallery = false;
    bool quiet = false;
};

constexpr auto report_notes =
    R"(Reports are made from stored results alone: no point set is made or measured again.
Several folders make one report, with all of their series in one ranking.
  poissonlab report out/quick
  poissonlab report out/quick out/mine --gallery --out out/both)";

void report(const ReportOptions& options)
{
    if (options.out.empty() && options.folders.size() > 1)
        throw InputError("report: --out is missing: with several folders it must say where the report goes");
    Progress progress(Progress::detect(options.quiet));
    const auto out = options.out.empty() ? options.folders.front() : options.out;
    check_output_folder(out, "report: ");
    finish_report(options.folders, out, progress, options.print ? PrintPictures::drawn : PrintPictures::none,
                  options.gallery ? Gallery::laid_behind : Gallery::offered);
}

}

Command report_command()
{
    const auto o = std::make_shared<ReportOptions>();
    return {"report",
            "Build a report again, or one over several output folders",
            {{"DIR", &o->folders, "Folders that `run` or `analyze` wrote"},
             {"--out", &o->out, "Where the report goes; default: DIR, where there is one", "DIR"},
             {"--print", &o->print, "Draw curves as PNG for print as well; pages need only the SVG"},
             {"--gallery", &o->gallery, "Lay reference curves of the laboratory's methods behind those of the series"},
             {"--quiet", &o->quiet, "Print nothing but errors and the report's path"}},
            report_notes,
            action_on(o, report)};
}

}
