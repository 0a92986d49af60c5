#include "app/commands/commands.hpp"
#include "base/programs/interrupt.hpp"

namespace poissonlab {

void finish_report(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& out,
                   const ReportWriter& write_report, Progress& progress)
{
    write_report(folders, out, [&](const std::string& step) {
        stop_if_interrupted();
        progress.step("report: " + step);
    });
    progress.report((out / "index.html").string());
}

}
