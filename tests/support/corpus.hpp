// Small files by hand below a folder, one for each habit of those who write files, and right.txt, which says of each
// what is right: its name, and numbers. Lines that begin with # are for people.
#pragma once

#include "base/files/text_lines.hpp"
#include "base/files/whole_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace poissonlab::test {

/// Returns the `count` numbers that right.txt has for each file, by its path within the folder.
inline std::map<std::string, std::vector<double>> right_numbers(const std::filesystem::path& folder, std::size_t count)
{
    const std::string text = read_whole_file(folder / "right.txt");
    std::map<std::string, std::vector<double>> right;
    for (LineReader lines(text); lines.next();) {
        if (lines.line().starts_with('#')) continue;
        std::istringstream words{std::string(lines.line())};
        std::string file;
        words >> file;
        std::vector<double>& numbers = right[file];
        for (double number; words >> number;) numbers.push_back(number);
        EXPECT_EQ(numbers.size(), count) << lines.line();
    }
    return right;
}

/// Each file of the folder has its line, and each line its file.
inline void expect_numbers_of_all(const std::filesystem::path& folder,
                                  const std::map<std::string, std::vector<double>>& right)
{
    std::set<std::string> known, found;
    for (const auto& [file, numbers] : right) known.insert(file);
    for (const auto& file : std::filesystem::recursive_directory_iterator(folder))
        if (file.is_regular_file() && file.path().filename() != "right.txt")
            found.insert(std::filesystem::relative(file.path(), folder).string());
    EXPECT_EQ(found, known);
}

}
