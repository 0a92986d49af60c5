// What each subcommand does, once its arguments are known. command_line.cpp says what the arguments are.
#pragma once

#include "host/config/collection.hpp"
#include "host/run/progress.hpp"
#include "reports/plots/print_pictures.hpp"

#include <cstdint>
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
    int threads = 0;   ///< 0: all
    std::string shard; ///< "i/n"; empty: everything
    bool quiet = false;
    bool json = false;
    std::string command; ///< as it would be typed, without what does not change results
};

struct MergeOptions
{
    std::filesystem::path out;
    std::vector<std::filesystem::path> folders;
    bool quiet = false;
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
    bool print = false;        ///< PNG of curves as well
    bool quiet = false;
};

struct DiffOptions
{
    std::filesystem::path before;
    std::filesystem::path after;
    std::filesystem::path out; ///< empty: no page
    bool json = false;
    bool all = false; ///< list numbers that did not change as well
};

struct TilingOptions
{
    std::string kind; ///< "corner", "wang" or "cube"
    std::uint32_t colors = 0;
    std::string algorithm; ///< empty: the kind's first
    std::string hash;      ///< empty: long-period
    std::uint64_t seed = 1;
    std::vector<std::int64_t> window; ///< X Y W H; cubes: X Y Z W H D
    std::vector<std::int64_t> period; ///< of x, y, z; those that are missing are 0: none
};

struct TilesBuildOptions
{
    std::string kind; ///< "corner", "edge", "template" or "sphere"
    std::uint32_t colors = 0;
    std::uint32_t tiles = 0; ///< of template tiles
    std::uint32_t points = 0;
    double relative_radius = 0.75;
    std::string filling = "relaxation-dart-throwing";
    std::uint32_t lloyd_iterations = 20;
    bool repulsion = false;
    std::uint64_t seed = 1;
    std::filesystem::path out;
    std::string engine = "opencl";
    std::string device;
    bool quiet = false;
};

struct TilesPointsOptions
{
    std::filesystem::path file;       ///< the tile set
    std::vector<std::int64_t> window; ///< X Y W H; 3D: X Y Z W H D
    std::uint32_t seed = 1;
    std::filesystem::path out;
    std::string device;
};

struct TilesVerifyOptions
{
    std::filesystem::path file;
    bool json = false;
};

void run_command(const RunOptions& options);
void analyze_command(const AnalyzeOptions& options);
void report_command(const ReportOptions& options);

/// Prints what changed between two results; true where something did.
bool diff_command(const DiffOptions& options);

/// Prints what OpenCL offers on this machine. Throws DeviceError when that is nothing.
void devices_command();

/// Prints every sampler and its parameters.
void samplers_command();

/// Prints the tile indices of a window of a stochastic tiling, a row of tiles a line.
void tiling_command(const TilingOptions& options);

/// Builds a tile set, proves its minimum distance, and writes it.
void tiles_build_command(const TilesBuildOptions& options);

/// Writes the points of a window of a Poisson disk tiling to a file.
void tiles_points_command(const TilesPointsOptions& options);

/// Prints what a file of a Poisson disk (sphere) tile set holds and what is proven of it. Throws InputError for files
/// that are none, are damaged, or promise more than is proven, the last after printing.
void tiles_verify_command(const TilesVerifyOptions& options);

/// Copies finished work of other output folders into one.
void merge_command(const MergeOptions& options);

/// Writes the report and prints the path of its page, the last line of every command that makes one.
void finish_report(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& out,
                   Progress& progress, PrintPictures print = PrintPictures::none);

}
