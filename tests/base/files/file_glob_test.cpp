// Files that a config names: paths, globs, and what is said where there are none.
#include "base/files/file_glob.hpp"

#include "base/files/whole_file.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(FileGlob, GivesFilesInOrderAndTakesFoldersLiterally)
{
    const TemporaryFolder root;
    const fs::path folder = root.path() / "a [1]*";
    fs::create_directory(folder);
    for (const char* name : {"b.txt", "a.txt", "c*.txt"}) write_whole_file(folder / name, "x");
    EXPECT_THAT(named_files(folder, "?.txt"), ElementsAre(folder / "a.txt", folder / "b.txt"));
    EXPECT_THAT(named_files(folder, "c*.txt"), ElementsAre(folder / "c*.txt")) << "a file of that name comes first";
    EXPECT_THAT(named_files(folder, "d*"), IsEmpty());
}

TEST(FileGlob, OfNamesThatNoFileCanHaveIsNothing) { EXPECT_THAT(named_files("/", std::string(5000, 'a')), IsEmpty()); }

TEST(FileGlob, SaysWhereItLooked)
{
    EXPECT_EQ(no_such_file("/somewhere/x/..", "a"), "no such file in /somewhere/, the folder of the config");
    EXPECT_EQ(no_such_file("/somewhere", "/elsewhere/a"), "no such file");
    EXPECT_EQ(no_such_file("", "a"), "no such file in " + fs::current_path().string() + ", the folder of the config")
        << "a config that is named without a folder";
}

}
}
