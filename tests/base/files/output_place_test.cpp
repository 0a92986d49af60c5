// Files that are written where their names lead: through links, into devices and pipes.
#include "base/files/output_place.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <future>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

TEST(OutputPlaces, AreBehindLinks)
{
    const TemporaryFolder folder, elsewhere;
    const fs::path file = elsewhere.write("old.txt", "old");
    fs::create_symlink(file, folder.path() / "link.txt");
    fs::create_symlink("link.txt", folder.path() / "second.txt");
    write_whole_file(folder.path() / "second.txt", "new");
    EXPECT_TRUE(fs::is_symlink(folder.path() / "link.txt"));
    EXPECT_TRUE(fs::is_symlink(folder.path() / "second.txt"));
    EXPECT_FALSE(fs::is_symlink(file));
    EXPECT_EQ(read_whole_file(file), "new");
    EXPECT_THAT(elsewhere.names(), UnorderedElementsAre("old.txt"));
}

TEST(OutputPlaces, OfLinksToNothingAreMade)
{
    const TemporaryFolder folder, elsewhere;
    fs::create_symlink(elsewhere.path() / "new.txt", folder.path() / "link.txt");
    write_whole_file(folder.path() / "link.txt", "new");
    EXPECT_TRUE(fs::is_symlink(folder.path() / "link.txt"));
    EXPECT_EQ(read_whole_file(elsewhere.path() / "new.txt"), "new");
    fs::create_symlink(elsewhere.path() / "none/new.txt", folder.path() / "astray.txt");
    EXPECT_THAT(message_of<StorageError>([&] { write_whole_file(folder.path() / "astray.txt", "new"); }),
                HasSubstr("astray.txt: cannot be written"));
}

/// Libraries choose the format by the name that was given, not by that of the file behind the link.
TEST(OutputPlaces, GiveWritersTheEndingOfTheLink)
{
    const TemporaryFolder folder, elsewhere;
    const fs::path file = elsewhere.write("data", "old");
    fs::create_symlink(file, folder.path() / "link.png");
    write_whole_file(folder.path() / "link.png", [&](const fs::path& temporary) {
        EXPECT_EQ(temporary.extension(), ".png");
        EXPECT_EQ(temporary.parent_path(), elsewhere.path());
        write_whole_file(temporary, "picture");
    });
    EXPECT_EQ(read_whole_file(file), "picture");
}

TEST(OutputPlaces, OfLinksInACircleAreRefused)
{
    const TemporaryFolder folder;
    fs::create_symlink("b", folder.path() / "a");
    fs::create_symlink("a", folder.path() / "b");
    EXPECT_THAT(message_of<StorageError>([&] { write_whole_file(folder.path() / "a", "x"); }),
                HasSubstr("/a: cannot be written: its links lead in a circle"));
}

TEST(OutputPlaces, CanBeDevices)
{
    for (const bool is_by_library : {false, true}) {
        if (is_by_library)
            write_whole_file("/dev/null", [](const fs::path& temporary) { write_whole_file(temporary, "x"); });
        else
            write_whole_file("/dev/null", "x");
        EXPECT_TRUE(fs::is_character_file("/dev/null"));
    }
    EXPECT_THAT(message_of<StorageError>([&] { write_whole_file("/dev/full", "x"); }),
                HasSubstr("/dev/full: cannot be written: No space left on device"));
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST(OutputPlaces, CanBePipesWithNames)
{
    const TemporaryFolder folder;
    const fs::path pipe = folder.path() / "pipe.txt", link = folder.path() / "link.txt";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    fs::create_symlink(pipe, link);
    const std::string content(200'000, 'x'); // more than a pipe holds
    for (const fs::path& name : {pipe, link})
        for (const bool is_by_library : {false, true}) {
            auto read = std::async(std::launch::async, [&] { return read_whole_file(pipe); });
            if (is_by_library)
                write_whole_file(name, [&](const fs::path& temporary) { write_whole_file(temporary, content); });
            else
                write_whole_file(name, content);
            EXPECT_EQ(read.get(), content);
            EXPECT_TRUE(fs::is_fifo(pipe));
        }
    EXPECT_THAT(folder.names(), UnorderedElementsAre("pipe.txt", "link.txt"));
}

/// Shells open files so: `{ echo before; poissonlab ... --out /dev/stdout; } > file`.
TEST(OutputPlaces, OfOpenFilesKeepWhatIsInThem)
{
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "file";
    const int open_file = ::open(file.c_str(), O_WRONLY | O_CREAT, 0600);
    ASSERT_GE(open_file, 0);
    ASSERT_EQ(::write(open_file, "before ", 7), 7);
    write_whole_file("/dev/fd/" + std::to_string(open_file), "after");
    write_whole_file("/proc/self/fd/" + std::to_string(open_file),
                     [](const fs::path& temporary) { write_whole_file(temporary, " all"); });
    ::close(open_file);
    EXPECT_EQ(read_whole_file(file), "before after all");
}

TEST(OutputPlaces, KeepPermissions)
{
    const TemporaryFolder folder;
    const fs::path file = folder.write("secret", "old");
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
    write_whole_file(file, "new");
    EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    if (::geteuid() == 0) return; // who may write everywhere
    fs::permissions(file, fs::perms::owner_read);
    EXPECT_THAT(message_of<StorageError>([&] { write_whole_file(file, "newer"); }), HasSubstr("Permission denied"));
    EXPECT_EQ(read_whole_file(file), "new");
}

TEST(OutputPlaces, NameStandardOutput)
{
    for (const char* name : {"-", "-.png"}) EXPECT_TRUE(names_standard_output(name)) << name;
    for (const char* name : {"", "--", "a", "-a.png", "./-", "./-.png", "-.d/a.png", "-/.png"})
        EXPECT_FALSE(names_standard_output(name)) << name;
}

/// A program that has not asked for it, such as Python, has files of this name.
TEST(OutputPlaces, AreFilesUnlessStandardOutputIsKept)
{
    EXPECT_FALSE(output_place("-").is_stream);
    EXPECT_EQ(output_place("-").file, "-");
}

}
}
