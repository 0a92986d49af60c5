// The command line of poissonlab: subcommands, help, exit statuses.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace poissonlab {

/// Builds a report, as write_report of reports/report.hpp does. Handed in, because experiments do not know
/// reports.
using ReportWriter = std::function<void(const std::vector<std::filesystem::path>& result_folders,
                                        const std::filesystem::path& out,
                                        const std::function<void(const std::string&)>& progress)>;

/// Does what the arguments say and returns the exit status: 0 all is there; 2 the input or the arguments are
/// wrong; 3 OpenCL failed; 1 anything else. Errors are one line on standard error, "poissonlab: error: ...".
int run_command_line(int argc, const char* const* argv, const ReportWriter& write_report);

}
