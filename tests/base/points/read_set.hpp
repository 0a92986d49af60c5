// A set that is read from a file of that content, and what was said of it.
#pragma once

#include "base/points/point_file.hpp"
#include "tests/support/temporary_folder.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace poissonlab {

struct ReadSet
{
    PointSet set;
    std::vector<std::string> told; ///< without the folder
};

inline ReadSet read_set(const std::filesystem::path& file, PointReading how = {})
{
    ReadSet read;
    const std::string folder = file.parent_path().string() + "/";
    how.told = [&](const std::string& sentence) {
        read.told.push_back(sentence.starts_with(folder) ? sentence.substr(folder.size()) : sentence);
    };
    read.set = read_points(file, how).at(0);
    return read;
}

inline ReadSet read_set(const std::string& name, std::string_view content, const PointReading& how = {})
{
    const TemporaryFolder folder;
    return read_set(folder.write(name, content), how);
}

}
