#include "base/files/file_lock.hpp"

#include "base/errors/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

namespace poissonlab {
namespace {

TEST(FileLock, OneHasIt)
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "lock";
    {
        const FileLock lock(file);
        EXPECT_FALSE(FileLock::try_lock(file)) << "a second opening of the file is like another process";
    }
    EXPECT_TRUE(FileLock::try_lock(file));
}

TEST(FileLock, GoesWithItsProcessHoweverThatEnds)
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "lock";
    int ready[2];
    ASSERT_EQ(::pipe(ready), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        const FileLock lock(file);
        [[maybe_unused]] const auto written = ::write(ready[1], "x", 1);
        for (;;) ::pause();
    }
    char byte = 0;
    ASSERT_EQ(::read(ready[0], &byte, 1), 1);
    EXPECT_FALSE(FileLock::try_lock(file));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    EXPECT_TRUE(FileLock::try_lock(file));
}

TEST(FileLock, WhereNothingCanBeWritten)
{
    EXPECT_THROW(FileLock("/proc/no-such-folder/lock"), StorageError);
    EXPECT_THROW(FileLock::try_lock("/proc/no-such-folder/lock"), StorageError);
}

}
}
