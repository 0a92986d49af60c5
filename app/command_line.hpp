// The command line of poissonlab: subcommands, help, exit statuses.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace poissonlab {

/// Builds a report, as write_report of reports/report.hpp does. Handed in, because experiments do not know
/// reports.
using ReportWriter =
    std::function<void(const std::vector<std::filesystem::path>& result_folders, const std::filesystem::path& out,
                       const std::function<void(const std::string&)>& progress)>;

/// Compares two results and says whether something changed, and what, as compare_runs of reports/compare_runs.hpp does.
using RunComparer =
    std::function<std::pair<bool, std::string>(const std::filesystem::path& before, const std::filesystem::path& after,
                                               const std::filesystem::path& out, const std::string& format)>;

/// Does what the arguments say and returns the exit status: 0 all is there; 2 the input or the arguments are wrong;
/// 3 OpenCL failed; 4 results that are compared differ; 130 it was interrupted; 1 anything else. Errors are one line on
/// standard error, "poissonlab: error: ...".
int run_command_line(int argc, const char* const* argv, const ReportWriter& write_report,
                     const RunComparer& compare_runs);

}
