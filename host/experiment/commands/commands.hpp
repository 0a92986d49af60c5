// What each subcommand does, once its arguments are known. command_line.cpp says what the arguments are.
#pragma once

#include "experiment/command_line.hpp"
#include "experiment/progress.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

struct RunOptions
{
    std::string config;
    std::filesystem::path out; ///< empty: out/<config's stem>
    std::string device;
    std::vector<std::string> overrides;
    int threads = 0; ///< 0: all
    bool quiet = false;
    std::string command; ///< as it would be typed
};

struct AnalyzeOptions
{
    std::vector<std::filesystem::path> files;
    std::filesystem::path out; ///< empty: out/<label>
    std::string label;
    std::string domain; ///< as for parse_range(); empty: what the files say
    std::vector<std::string> overrides;
    int threads = 0;
    bool quiet = false;
    std::string command;
};

struct ReportOptions
{
    std::vector<std::filesystem::path> folders;
    std::filesystem::path out; ///< empty: the folder, where there is one
    bool quiet = false;
};

void run_command(const RunOptions& options, const ReportWriter& write_report);
void analyze_command(const AnalyzeOptions& options, const ReportWriter& write_report);
void report_command(const ReportOptions& options, const ReportWriter& write_report);

/// Prints what OpenCL offers on this machine. Throws DeviceError when that is nothing.
void devices_command();

/// Prints every sampler and its parameters.
void samplers_command();

/// Writes the report and prints the path of its page, the last line of every command that makes one.
void finish_report(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& out,
                   const ReportWriter& write_report, Progress& progress);

}
