#include "app/commands/core/finish_report.hpp"

#include "base/programs/interrupt.hpp"
#include "reports/site/report.hpp"

namespace poissonlab {

void finish_report(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& out,
                   Progress& progress, PrintPictures print, Gallery gallery)
{
    const auto say = [&](const std::string& step) {
        stop_if_interrupted();
        progress.step("report: " + step);
    };
    write_report(folders, out, say, print, gallery);
    progress.report((out / "index.html").string());
}

}
