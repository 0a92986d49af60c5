// The rooms of the laboratory and which may look into which: docs/architecture.md. Read from the includes themselves.
#include "tests/architecture/source_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;
using testing::Contains;

using Names = std::set<std::string>;

/// The arrows of docs/architecture.md: a room, and the rooms that it may look into.
const std::map<std::string, Names> rooms{
    {"base", {}},
    {"runtime", {}},
    {"kernels", {}},
    {"tiles", {"base", "runtime"}},
    {"analysis", {"base"}},
    {"results", {"analysis", "tiles", "base"}},
    {"host", {"results", "kernels", "analysis", "tiles", "base"}},
    {"experiment", {"host", "results", "analysis", "tiles", "base"}},
    {"reports", {"results", "analysis", "tiles", "base"}},
    {"python", {"experiment", "host", "reports", "results", "analysis", "tiles", "base"}},
    {"app", {"experiment", "host", "reports", "results", "analysis", "tiles", "base"}},
};

/// Headers that the build writes.
const Names generated{"version.hpp", "code_hashes.hpp"};

std::string room_of(const std::string& file) { return file.substr(0, file.find('/')); }

std::string folder_of(const std::string& file) { return fs::path(file).parent_path().generic_string(); }

/// All C++ files of the rooms, with what each includes in quotes.
std::map<std::string, Names> includes_of_all_files()
{
    static const std::regex line("(?:^|\n)[ \t]*#[ \t]*include[ \t]+\"([^\"]+)\"");
    std::map<std::string, Names> all;
    for (const test::SourceFile& file : test::source_files()) {
        if (!rooms.contains(file.room()) || !file.is_cpp()) continue;
        Names& names = all[file.path];
        for (std::sregex_iterator match(file.text.begin(), file.text.end(), line), end; match != end; ++match)
            names.insert((*match)[1]);
    }
    return all;
}

class Rooms : public testing::Test
{
protected:
    static void SetUpTestSuite() { files_ = includes_of_all_files(); }

    static inline std::map<std::string, Names> files_;
};

TEST_F(Rooms, AreFull) { EXPECT_GT(files_.size(), 300); }

/// Headers for other programs stand alone: they name each other without folders.
TEST_F(Rooms, AreNamedFromTheRoot)
{
    for (const auto& [file, names] : files_)
        for (const std::string& name : names) {
            if (generated.contains(name) || room_of(file) == "runtime") continue;
            EXPECT_TRUE(files_.contains(name)) << file << " includes \"" << name << "\"";
        }
}

TEST_F(Rooms, LookOnlyWhereTheyMay)
{
    for (const auto& [file, names] : files_)
        for (const std::string& name : names) {
            const std::string from = room_of(file), to = room_of(name);
            if (!files_.contains(name) || from == to) continue;
            EXPECT_THAT(rooms.at(from), Contains(to)) << file << " includes \"" << name << "\"";
        }
}

/// Follows the arrows between folders from one of them; `path` are the folders on the way.
bool leads_back(const std::map<std::string, Names>& arrows, const std::string& folder, std::vector<std::string>& path,
                Names& done)
{
    if (std::ranges::find(path, folder) != path.end()) {
        path.push_back(folder);
        return true;
    }
    if (!done.insert(folder).second || !arrows.contains(folder)) return false;
    path.push_back(folder);
    for (const std::string& next : arrows.at(folder))
        if (leads_back(arrows, next, path, done)) return true;
    path.pop_back();
    return false;
}

TEST_F(Rooms, HaveFoldersThatDoNotLookAtEachOther)
{
    std::map<std::string, Names> arrows;
    for (const auto& [file, names] : files_)
        for (const std::string& name : names)
            if (files_.contains(name) && folder_of(name) != folder_of(file))
                arrows[folder_of(file)].insert(folder_of(name));
    Names done;
    std::vector<std::string> path;
    for (const auto& [folder, others] : arrows)
        EXPECT_FALSE(leads_back(arrows, folder, path, done)) << "a circle: " << testing::PrintToString(path);
}

}
}
