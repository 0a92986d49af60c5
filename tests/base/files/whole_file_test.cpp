#include "base/files/whole_file.hpp"

#include "base/errors/errors.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <csignal>
#include <future>

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
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
    return message_of<StorageError>([&] { write_whole_file(path, content); });
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

TEST(WholeFile, ReadsPipes)
{
    const TemporaryFolder folder;
    const auto pipe = folder.path() / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    const std::string content(100000, 'x'); // more than a pipe holds
    const auto writing = std::async(std::launch::async, [&] { std::ofstream(pipe) << content; });
    EXPECT_EQ(read_whole_file(pipe), content);
}

TEST(WholeFile, RefusesWhatHasNoEndOrDoesNotFit)
{
    const auto error_of = [](const std::filesystem::path& path) { return message_of([&] { read_whole_file(path); }); };
    EXPECT_EQ(error_of("/dev/zero"), "/dev/zero: is a device, not a file");
    const TemporaryFolder folder;
    const auto file = folder.write("file", "x");
    std::error_code error;
    constexpr std::uintmax_t tebibytes_4 = std::uintmax_t{1} << 42; // of which nothing is on the disk
    std::filesystem::resize_file(file, tebibytes_4, error);
    if (error) GTEST_SKIP() << "this file system has no such files";
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) // whose allocators end the program
    rlimit old{};
    ASSERT_EQ(::getrlimit(RLIMIT_AS, &old), 0);
    const rlimit limit{tebibytes_4, old.rlim_max};
    ::setrlimit(RLIMIT_AS, &limit);
    EXPECT_EQ(error_of(file), file.string() + ": does not fit in memory: has 4398046511104 bytes");
    ::setrlimit(RLIMIT_AS, &old);
#endif
}

/// A process that has ended, whose number nobody has got since.
pid_t ended_process()
{
    const pid_t process = ::fork();
    if (process == 0) ::_exit(0);
    ::waitpid(process, nullptr, 0);
    return process;
}

TEST(WholeFile, RemovesWhatKilledProcessesLeftAndNothingElse)
{
    const TemporaryFolder folder;
    const std::string gone = std::to_string(ended_process());
    const std::string running = std::to_string(::getpid());
    const std::string left = ".tmp-" + gone;
    const std::vector<std::string> stale{left + "-12-a.b.exr", "below/" + left + "-1-file"};
    const std::vector<std::string> kept{"tmp-" + gone + "-1-a",
                                        left + "-a",
                                        ".tmp-notes",
                                        left + "-1",
                                        ".tmpx-" + gone + "-1-a",
                                        ".tmp-x" + gone + "-1-a",
                                        left + "--a",
                                        left + "-1.a",
                                        "other/" + left + "-1-a",
                                        ".tmp-" + running + "-1-a.svg"};
    for (const auto& names : {stale, kept})
        for (const std::string& name : names) folder.write(name, "x");
    std::filesystem::create_directory(folder.path() / (left + "-1-folder"));
    std::filesystem::create_symlink("nowhere", folder.path() / (left + "-1-link"));
    const TemporaryFolder elsewhere;
    const auto outside = elsewhere.write(left + "-1-a", "x");
    std::filesystem::create_directory_symlink(elsewhere.path(), folder.path() / "link");

    remove_stale_temporary_files(folder.path(), std::chrono::hours(1));
    EXPECT_TRUE(std::filesystem::exists(folder.path() / stale[0])) << "too young";
    remove_stale_temporary_files(folder.path(), std::chrono::seconds(0), "other");
    for (const std::string& name : stale) EXPECT_FALSE(std::filesystem::exists(folder.path() / name)) << name;
    for (const std::string& name : kept) EXPECT_TRUE(std::filesystem::exists(folder.path() / name)) << name;
    EXPECT_TRUE(std::filesystem::exists(folder.path() / (left + "-1-folder")));
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / (left + "-1-link")));
    EXPECT_TRUE(std::filesystem::exists(outside));
}

TEST(WholeFile, SaysWhichFileCannotBeRead)
{
    const TemporaryFolder folder;
    EXPECT_THAT(message_of([&] { read_whole_file(folder.path() / "missing.dat"); }),
                HasSubstr("missing.dat: cannot be read: No such file or directory"));
    EXPECT_THAT(message_of([&] { read_whole_file(folder.path()); }), HasSubstr("cannot be read: Is a directory"));
}

}
}
