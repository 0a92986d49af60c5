// Files and folders that one can overlook: docs/architecture.md promises how large they are.
#include "tests/architecture/source_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>

namespace poissonlab {
namespace {

using test::SourceFile;
using testing::Ge;
using testing::Le;

constexpr std::ptrdiff_t most_lines = 600, usual_lines = 300;

/// One file in so many may have more than `usual_lines`.
constexpr std::ptrdiff_t files_per_long_file = 25;

constexpr int most_files_in_a_folder = 37, most_files_in_a_folder_of_tests = 64;

std::ptrdiff_t line_count(const SourceFile& file) { return std::ranges::count(file.text, '\n'); }

TEST(Sizes, AreThoseOfAllSourceFiles) { EXPECT_THAT(test::source_files().size(), Ge(2000u)); }

TEST(Sizes, OfFilesAreSmall)
{
    for (const SourceFile& file : test::source_files()) EXPECT_THAT(line_count(file), Le(most_lines)) << file.path;
}

TEST(Sizes, OfMostFilesAreSmaller)
{
    const auto is_long = [](const SourceFile& file) { return line_count(file) > usual_lines; };
    EXPECT_THAT(std::ranges::count_if(test::source_files(), is_long) * files_per_long_file,
                Le(std::ssize(test::source_files())));
}

TEST(Sizes, OfFoldersAreSmall)
{
    std::map<std::string, int> counts;
    for (const SourceFile& file : test::source_files()) ++counts[file.folder()];
    for (const auto& [folder, count] : counts)
        EXPECT_THAT(count, Le(folder.starts_with("tests") ? most_files_in_a_folder_of_tests : most_files_in_a_folder))
            << folder;
}

}
}
