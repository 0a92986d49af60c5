// The first command of the README compiles the core: docs/architecture.md promises how large it is.
#include "base/files/whole_file.hpp"
#include "tests/architecture/source_files.hpp"
#include "tests/support/places.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace poissonlab {
namespace {

using test::SourceFile;

constexpr std::ptrdiff_t most_lines_of_core = 50'000;

std::map<std::string, const SourceFile*> files_by_path()
{
    std::map<std::string, const SourceFile*> files;
    for (const SourceFile& file : test::source_files()) files[file.path] = &file;
    return files;
}

/// The files that a file includes by their paths from the root; headers of kernels are found below kernels/ as well.
std::vector<std::string> includes_of(const SourceFile& file)
{
    std::vector<std::string> paths;
    std::istringstream lines(file.text);
    const std::string sign = "#include \"";
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with(sign)) paths.push_back(line.substr(sign.size(), line.rfind('"') - sign.size()));
    return paths;
}

/// The source files of the core's libraries, as CMake knows them, and all headers that they include.
std::set<std::string> files_of_core()
{
    const auto files = files_by_path();
    std::set<std::string> core;
    std::vector<std::string> open;
    std::istringstream listed(read_whole_file(core_sources_list()));
    for (std::string path; std::getline(listed, path);)
        if (!path.empty()) open.push_back(path);
    while (!open.empty()) {
        const std::string path = open.back();
        open.pop_back();
        const auto file = files.contains(path) ? files.find(path) : files.find("kernels/" + path);
        if (file == files.end() || !core.insert(file->first).second) continue;
        std::ranges::move(includes_of(*file->second), std::back_inserter(open));
    }
    return core;
}

TEST(Core, IsAsSmallAsPromised)
{
    const auto files = files_by_path();
    std::ptrdiff_t lines = 0;
    for (const std::string& path : files_of_core()) lines += std::ranges::count(files.at(path)->text, '\n');
    EXPECT_LE(lines, most_lines_of_core);
    EXPECT_GE(lines, most_lines_of_core / 2) << "the list is not whole";
}

TEST(Core, HasWhatTheFirstCommandNeedsAndNoModules)
{
    const std::set<std::string> core = files_of_core();
    for (const char* path : {"app/main.cpp", "host/sampling/dart_throwing.cpp", "host/modules/core.cpp",
                             "host/modules/without_space.cpp", "reports/site/report.cpp"})
        EXPECT_TRUE(core.contains(path)) << path;
    for (const std::string& path : core) {
        if (!path.ends_with(".cpp")) continue;
        for (const char* folder :
             {"host/tile_construction/", "host/texture/", "host/distribution/", "host/schemes/",
              "host/sampling/optimized/", "host/sampling/reference/", "analysis/regions/", "analysis/zone_plate/",
              "base/densities/", "reports/diff/", "tiles/", "base/surfaces/"})
            EXPECT_FALSE(path.starts_with(folder)) << path;
    }
}

}
}
