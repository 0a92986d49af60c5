#include "io/whole_file.hpp"

#include "errors/errors.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <csignal>

#include <sys/resource.h>
#include <unistd.h>

namespace poissonlab {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// For as long as it lives, no file can grow beyond `bytes`: what a full disk looks like.
class FileSizeLimit
{
public:
    explicit FileSizeLimit(rlim_t bytes) : old_handler_(std::signal(SIGXFSZ, SIG_IGN))
    {
        ::getrlimit(RLIMIT_FSIZE, &old_);
        const rlimit limit{bytes, old_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit()
    {
        ::setrlimit(RLIMIT_FSIZE, &old_);
        std::signal(SIGXFSZ, old_handler_);
    }

private:
    rlimit old_{};
    void (*old_handler_)(int);
};

std::string storage_error_of(const std::filesystem::path& path, std::string_view content)
{
    try {
        write_whole_file(path, content);
    } catch (const StorageError& error) {
        return error.what();
    }
    ADD_FAILURE() << path << " was written without an error";
    return "";
}

TEST(WholeFile, ReadsBackWhatWasWritten)
{
    const TemporaryFolder folder;
    const std::string content("a\0b\r\n\xff", 6);
    write_whole_file(folder.path() / "file", content);
    EXPECT_EQ(read_whole_file(folder.path() / "file"), content);
}

TEST(WholeFile, ReadsSizesAroundABlock)
{
    const TemporaryFolder folder;
    for (const std::size_t size : {0, 1, 65535, 65536, 65537, 131072}) {
        const std::string content(size, 'x');
        write_whole_file(folder.path() / "file", content);
        EXPECT_EQ(read_whole_file(folder.path() / "file"), content) << size;
    }
}

TEST(WholeFile, ReplacesWhatIsThere)
{
    const TemporaryFolder folder;
    const auto file = folder.write("file", "a long old content");
    write_whole_file(file, "new");
    EXPECT_EQ(read_whole_file(file), "new");
    EXPECT_THAT(folder.names(), ElementsAre("file"));
}

TEST(WholeFile, WritesNothingIntoAFolderThatIsMissing)
{
    const TemporaryFolder folder;
    EXPECT_THAT(storage_error_of(folder.path() / "missing" / "file", "x"),
                HasSubstr("missing/file: cannot be written: No such file or directory"));
    EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(WholeFile, LeavesNothingBehindWhenTheTargetIsAFolder)
{
    const TemporaryFolder folder;
    folder.write("target/inside", "kept");
    EXPECT_THAT(storage_error_of(folder.path() / "target", "x"), HasSubstr("target: cannot be written: "));
    EXPECT_THAT(folder.names(), ElementsAre("target"));
}

TEST(WholeFile, LeavesNothingBehindInAFolderWithoutPermission)
{
    const TemporaryFolder folder;
    std::filesystem::permissions(folder.path(),
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    // Root may write everywhere, so it becomes somebody else ("nobody" on Debian) for the attempt.
    const bool is_root = ::geteuid() == 0;
    if (is_root) {
        ASSERT_EQ(::seteuid(65534), 0);
    }
    const std::string error = storage_error_of(folder.path() / "file", "x");
    if (is_root) {
        ASSERT_EQ(::seteuid(0), 0);
    }
    EXPECT_THAT(error, HasSubstr("Permission denied"));
    EXPECT_THAT(folder.names(), IsEmpty());
    std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
}

TEST(WholeFile, KeepsTheOldFileWhenTheDiskIsFull)
{
    const TemporaryFolder folder;
    const auto file = folder.write("file", "old");
    // Less than a buffer (noticed when the file is closed) and more (noticed earlier).
    for (const std::size_t size : {2000, 2000000}) {
        const FileSizeLimit limit(1000);
        EXPECT_THAT(storage_error_of(file, std::string(size, 'x')),
                    HasSubstr("file: cannot be written: File too large"));
    }
    EXPECT_EQ(read_whole_file(file), "old");
    EXPECT_THAT(folder.names(), ElementsAre("file"));
}

TEST(WholeFile, GivesWritersATemporaryNameBesideTheTarget)
{
    const TemporaryFolder folder;
    const auto target = folder.path() / "image.exr";
    write_whole_file(target, [&](const std::filesystem::path& temporary) {
        EXPECT_EQ(temporary.parent_path(), target.parent_path());
        EXPECT_EQ(temporary.extension(), ".exr");
        EXPECT_NE(temporary, target);
        std::ofstream(temporary) << "pixels";
        EXPECT_FALSE(std::filesystem::exists(target));
    });
    EXPECT_EQ(read_whole_file(target), "pixels");
    EXPECT_THAT(folder.names(), ElementsAre("image.exr"));
}

TEST(WholeFile, RemovesTheTemporaryFileOfAWriterThatThrows)
{
    const TemporaryFolder folder;
    const auto file = folder.write("file", "old");
    EXPECT_THROW(write_whole_file(file,
                                  [](const std::filesystem::path& temporary) {
                                      std::ofstream(temporary) << "half";
                                      throw std::runtime_error("stop");
                                  }),
                 std::runtime_error);
    EXPECT_EQ(read_whole_file(file), "old");
    EXPECT_THAT(folder.names(), ElementsAre("file"));
}

TEST(WholeFile, NoticesAWriterThatWritesNothing)
{
    const TemporaryFolder folder;
    EXPECT_THROW(write_whole_file(folder.path() / "file", [](const std::filesystem::path&) {}), StorageError);
    EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(WholeFile, SaysWhichFileCannotBeRead)
{
    const TemporaryFolder folder;
    try {
        read_whole_file(folder.path() / "missing.dat");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("missing.dat: cannot be read: No such file or directory"));
    }
    try {
        read_whole_file(folder.path());
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("cannot be read: Is a directory"));
    }
}

}
}
