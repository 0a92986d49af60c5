// The versions that keys of stored work hold depend on every file that decides what comes out.
#include "base/files/whole_file.hpp"
#include "tests/support/places.hpp"

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

const fs::path source = source_folder();

using SourceFiles = std::set<std::string>; ///< below the source folder

/// The files behind each version.
std::map<std::string, SourceFiles> hashed_files()
{
    std::map<std::string, SourceFiles> files;
    std::istringstream list(read_whole_file(code_files_list()));
    for (std::string version, file; list >> version >> file;) files[version].insert(file);
    return files;
}

/// The files of the project that a file includes: paths from the root, or, of headers for other programs, from the
/// folder of their own.
SourceFiles includes(const std::string& file)
{
    static const std::regex line("#include \"([^\"]+)\"");
    const std::string text = read_whole_file(source / file);
    SourceFiles names;
    for (std::sregex_iterator match(text.begin(), text.end(), line), end; match != end; ++match)
        for (const fs::path& folder : {fs::path(), fs::path(file).parent_path()}) {
            const fs::path candidate = (folder / (*match)[1].str()).lexically_normal();
            if (fs::is_regular_file(source / candidate)) names.insert(candidate.generic_string());
        }
    return names;
}

/// The way in which work is asked for, dealt out and stored changes no result; what is measured on points, and how
/// samplers make them, is a version of its own.
bool may_change(const std::string& version, const std::string& file)
{
    const auto is_in = [&](const char* folder) { return file.starts_with(folder); };
    for (const char* folder : {"experiment/config/", "base/crew/", "experiment/store/", "host/settings/"})
        if (is_in(folder)) return true;
    if (version == "analysis_version") return is_in("experiment/exhibits/") || is_in("host/") || is_in("tiles/");
    if (version == "distribution_version" && is_in("analysis/")) return false; // curves are stored with the points
    if (version == "picture_version" && is_in("host/distribution/")) return true;
    if (version == "construction_version" && is_in("host/distribution/")) return true;
    if (version == "sampling_version" && (is_in("experiment/exhibits/") || is_in("host/kinds/"))) return true;
    return is_in("analysis/") || is_in("experiment/measuring/") || is_in("host/scenes/") || is_in("results/");
}

TEST(CodeVersions, CoverWhatTheirFilesInclude)
{
    const auto versions = hashed_files();
    ASSERT_EQ(versions.size(), 5);
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
    for (const char* version : {"sampling_version", "analysis_version", "picture_version"}) {
        EXPECT_THAT(versions.at(version), Contains("results/records/archive.hpp"));
        EXPECT_THAT(versions.at(version), Contains("base/files/byte_archive.hpp"));
    }
    EXPECT_THAT(versions.at("sampling_version"), Contains("host/tile_sampling/tile_samplers.cpp"));
    EXPECT_THAT(versions.at("sampling_version"), Contains("configs/tilings/hat.toml"));
    EXPECT_THAT(versions.at("sampling_version"), Contains("host/sampling/classics/command_sampler.cpp"));
    EXPECT_THAT(versions.at("sampling_version"), Contains("host/distribution/regions/region_points.cpp"));
    EXPECT_THAT(versions.at("sampling_version"), Contains("analysis/regions/framed_region.cpp"));
    EXPECT_THAT(versions.at("distribution_version"), Contains("host/distribution/even_points.cpp"));
    EXPECT_THAT(versions.at("distribution_version"), Contains("analysis/regions/framed_region.cpp"));
    EXPECT_THAT(versions.at("analysis_version"), Contains("analysis/spectra/fast_periodogram.cpp"));
    EXPECT_THAT(versions.at("analysis_version"), Contains("experiment/measuring/series_analysis.cpp"));
}

/// A measure more throws away no stored point sets, tilings or constructions.
TEST(CodeVersions, OfPointsKnowNoMeasures)
{
    const auto versions = hashed_files();
    for (const char* version : {"construction_version", "sampling_version", "picture_version"})
        for (const std::string& file : versions.at(version))
            EXPECT_FALSE(file.starts_with("analysis/measures/") || file.starts_with("experiment/measuring/") ||
                         fs::path(file).parent_path() == "results")
                << version << ": " << file;
}

}
}
