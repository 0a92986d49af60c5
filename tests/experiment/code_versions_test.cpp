// The versions that keys of stored work hold depend on every file that decides what comes out.
#include "io/whole_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;
using testing::Contains;

const fs::path source = POISSONLAB_SOURCE_DIR;

using Files = std::set<std::string>; ///< below the source folder

/// The files behind each version.
std::map<std::string, Files> hashed_files()
{
    std::map<std::string, Files> files;
    std::istringstream list(read_whole_file(POISSONLAB_CODE_FILES));
    for (std::string version, file; list >> version >> file;) files[version].insert(file);
    return files;
}

/// The file of the project that `file` means by #include "name", below the source folder; empty: it is made by the
/// build.
std::string included_file(const fs::path& file, const std::string& name)
{
    for (const fs::path& folder : {file.parent_path(), fs::path("host"), fs::path()}) {
        const fs::path candidate = (folder / name).lexically_normal();
        if (fs::is_regular_file(source / candidate)) return candidate.generic_string();
    }
    return {};
}

std::set<std::string> includes(const std::string& file)
{
    static const std::regex line("#include \"([^\"]+)\"");
    const std::string text = read_whole_file(source / file);
    std::set<std::string> names;
    for (std::sregex_iterator match(text.begin(), text.end(), line), end; match != end; ++match)
        if (const std::string found = included_file(file, (*match)[1]); !found.empty()) names.insert(found);
    return names;
}

/// Whether a file may be left out of a version: how work is stored and dealt out changes no result, and what is
/// measured on points does not change them.
bool may_change(const std::string& version, const std::string& file)
{
    return file.starts_with("host/store/") || file.starts_with("host/experiment/") ||
           (version != "analysis_version" && file.starts_with("analysis/")) ||
           (version == "analysis_version" &&
            (file.starts_with("host/sampling/") || file.starts_with("host/tiles/") ||
             file.starts_with("host/poisson_tiles/") || file.starts_with("host/tile_construction/")));
}

TEST(CodeVersions, CoverWhatTheirFilesInclude)
{
    const auto versions = hashed_files();
    ASSERT_EQ(versions.size(), 4);
    for (const auto& [version, files] : versions)
        for (const std::string& file : files)
            for (const std::string& name : includes(file))
                if (!may_change(version, name)) {
                    EXPECT_THAT(files, Contains(name)) << version << ": " << file;
                }
}

TEST(CodeVersions, CoverWhatDecidesResults)
{
    const auto versions = hashed_files();
    for (const char* version : {"construction_version", "sampling_version", "picture_version"}) {
        EXPECT_THAT(versions.at(version), Contains("kernels/tile_points.cl"));
        EXPECT_THAT(versions.at(version), Contains("runtime/poisson_tiles_gpu.h"));
        EXPECT_THAT(versions.at(version), Contains("host/device/device.cpp"));
    }
    for (const char* version : {"sampling_version", "analysis_version", "picture_version"})
        EXPECT_THAT(versions.at(version), Contains("host/experiment/archives.hpp"));
    EXPECT_THAT(versions.at("sampling_version"), Contains("host/tile_sampling/tile_samplers.cpp"));
    EXPECT_THAT(versions.at("sampling_version"), Contains("host/experiment/command_sampler.cpp"));
    EXPECT_THAT(versions.at("analysis_version"), Contains("analysis/fast_periodogram.cpp"));
    EXPECT_THAT(versions.at("analysis_version"), Contains("host/experiment/series_analysis.cpp"));
}

}
}
