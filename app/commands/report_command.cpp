// poissonlab report: the report again, or one over several result folders.
#include "app/commands/commands.hpp"
#include "base/errors/errors.hpp"

namespace poissonlab {

void report_command(const ReportOptions& options)
{
    if (options.out.empty() && options.folders.size() > 1)
        throw InputError("report: --out is missing: with several folders it must say where the report goes");
    Progress progress(Progress::detect(options.quiet));
    const auto out = options.out.empty() ? options.folders.front() : options.out;
    finish_report(options.folders, out, progress, options.print ? PrintPictures::drawn : PrintPictures::none);
}

}
