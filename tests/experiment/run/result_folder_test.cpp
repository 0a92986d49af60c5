#include "experiment/run/result_folder.hpp"

#include "tests/support/errors.hpp"
#include "tests/support/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;
using Files = std::map<std::string, std::string>;

void write(const fs::path& file, const std::string& content)
{
    fs::create_directories(file.parent_path());
    std::ofstream(file) << content;
}

std::string listing(const std::string& series)
{
    return R"({"format": "poissonlab-results", "series": [{"name": ")" + series + "\"}]}";
}

void publish(const fs::path& out, const std::string& series, const std::string& content)
{
    const TemporaryFolder store;
    ResultFolder folder(out, {series});
    folder.add(series, {{"realization-000.dat", store.write("points", content)}});
    folder.publish(listing(series));
}

TEST(ResultFolder, PublishesEverythingAndNothingElse)
{
    const TemporaryFolder temporary;
    const fs::path out = temporary.path() / "a/b/c/";
    publish(out, "s", "points");
    EXPECT_EQ(files_below(temporary.path()),
              (Files{{"a/b/c/results.json", listing("s")}, {"a/b/c/s/realization-000.dat", "points"}}));
}

TEST(ResultFolder, LeavesNothingWithoutPublish)
{
    const TemporaryFolder temporary;
    const TemporaryFolder store;
    {
        ResultFolder folder(temporary.path(), {"s"});
        folder.add("s", {{"realization-000.dat", store.write("points", "points")}});
    }
    EXPECT_TRUE(temporary.names().empty());
}

TEST(ResultFolder, RemovesWhatAKilledProcessLeft)
{
    const TemporaryFolder temporary;
    write(temporary.path() / ".unfinished-123/s/realization-000.dat", "left over");
    publish(temporary.path(), "s", "points");
    EXPECT_EQ(files_below(temporary.path()),
              (Files{{"results.json", listing("s")}, {"s/realization-000.dat", "points"}}));
}

/// A page of an earlier report.
constexpr auto own_page = R"(<meta name="generator" content="poissonlab"/>)";

TEST(ResultFolder, LinksFilesWhereItCan)
{
    const TemporaryFolder temporary;
    const fs::path file = temporary.write("points", "points");
    {
        ResultFolder folder(temporary.path() / "out", {"s"});
        folder.add("s", {{"a.dat", file}});
        folder.publish(listing("s"));
    }
    EXPECT_TRUE(fs::equivalent(file, temporary.path() / "out/s/a.dat"));
}

TEST(ResultFolder, KeepsThePreviousResultUntilPublish)
{
    const TemporaryFolder temporary;
    publish(temporary.path(), "old", "old points");
    write(temporary.path() / "index.html", own_page);
    write(temporary.path() / "notes.txt", "mine");
    const Files before = files_below(temporary.path());
    {
        const TemporaryFolder store;
        ResultFolder folder(temporary.path(), {"old", "new"});
        folder.add("new", {{"realization-000.dat", store.write("points", "points")}});
    }
    EXPECT_EQ(files_below(temporary.path()), before);
}

TEST(ResultFolder, ReplacesThePreviousResultAndKeepsForeignFiles)
{
    const TemporaryFolder temporary;
    publish(temporary.path(), "old", "old points");
    write(temporary.path() / "index.html", own_page);
    write(temporary.path() / "notes.txt", "mine");
    publish(temporary.path(), "new", "new points");
    EXPECT_EQ(
        files_below(temporary.path()),
        (Files{{"new/realization-000.dat", "new points"}, {"notes.txt", "mine"}, {"results.json", listing("new")}}));
}

TEST(ResultFolder, ReplacesSeriesThatAKilledRunLeft)
{
    const TemporaryFolder temporary;
    write(temporary.path() / "s/realization-000.dat", "left over");
    publish(temporary.path(), "s", "points");
    EXPECT_EQ(content_of(temporary.path() / "s/realization-000.dat"), "points");
}

TEST(ResultFolder, RefusesFoldersOfOthers)
{
    const TemporaryFolder temporary;
    const std::string name = temporary.path().string();
    write(temporary.path() / "random/thesis.tex", "mine");
    EXPECT_EQ(message_of([&] { ResultFolder(temporary.path(), {"random"}); }),
              "--out " + name + ": has \"random\", which is not a result of poissonlab; choose another folder");

    // Nor is a results.json of another program a licence.
    write(temporary.path() / "results.json", R"({"series": [{"name": "random"}]})");
    message_of([&] { ResultFolder(temporary.path(), {"random"}); });
    EXPECT_EQ(content_of(temporary.path() / "random/thesis.tex"), "mine");

    // It stays, and so does a page.
    for (const char* file : {"results.json", "index.html"}) {
        const TemporaryFolder other;
        write(other.path() / file, "[]");
        EXPECT_THAT(message_of([&] { ResultFolder(other.path(), {"random"}); }),
                    testing::HasSubstr(std::string(file) + " that poissonlab did not write; choose another folder"));
        EXPECT_EQ(content_of(other.path() / file), "[]");
    }
}

TEST(ResultFolder, NamesThatLeadElsewhereAreNotRemoved)
{
    const TemporaryFolder temporary;
    write(temporary.path() / "precious/file", "mine");
    write(temporary.path() / "out/results.json", listing("../precious"));
    publish(temporary.path() / "out", "s", "points");
    EXPECT_EQ(content_of(temporary.path() / "precious/file"), "mine");
}

TEST(ResultFolder, OutIsAFile)
{
    const TemporaryFolder temporary;
    const auto file = temporary.write("out", "x");
    EXPECT_EQ(message_of([&] { ResultFolder(file, {"s"}); }),
              "--out " + file.string() + ": is a file; a folder is needed");
}

TEST(ResultFolder, UnwritableIsAStorageError)
{
    EXPECT_THROW(ResultFolder("/proc/poissonlab-out", {"s"}), StorageError);
    EXPECT_THROW(ResultFolder("/proc", {"s"}), StorageError);
}

}
}
