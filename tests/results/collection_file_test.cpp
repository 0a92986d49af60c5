#include "results/collection_file.hpp"

#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string error_of(const TemporaryFolder& folder, const std::string& text)
{
    folder.write("collection.json", text);
    return refusal_of([&] { read_collection_file(folder.path()); });
}

TEST(CollectionFile, ComesBack)
{
    const TemporaryFolder folder;
    EXPECT_FALSE(read_collection_file(folder.path()));
    write_collection_file(folder.path(), {"All \"of\" it", "poissonlab run all.toml", {"a", "fig-6-01"}});
    const auto read = read_collection_file(folder.path());
    ASSERT_TRUE(read);
    EXPECT_EQ(read->title, "All \"of\" it");
    EXPECT_EQ(read->command, "poissonlab run all.toml");
    EXPECT_THAT(read->runs, ElementsAre("a", "fig-6-01"));
}

TEST(CollectionFile, StandsForItsRuns)
{
    const TemporaryFolder folder;
    const auto all = folder.path() / "all", one = folder.path() / "one";
    std::filesystem::create_directory(all);
    write_collection_file(all, {"T", "c", {"b", "a"}});
    EXPECT_THAT(output_folders(one), ElementsAre(one)) << "what is in there is for others to say";
    EXPECT_THAT(output_folders(std::vector{one, all}), ElementsAre(one, all / "b", all / "a"));
}

TEST(CollectionFile, MistakesAreNamed)
{
    const TemporaryFolder folder;
    const auto with = [](const std::string& runs, const std::string& format = "poissonlab-collection",
                         int version = 1) {
        return "{\"format\": \"" + format + "\", \"format_version\": " + std::to_string(version) +
               ", \"title\": \"T\", \"command\": \"c\", \"runs\": " + runs + "}";
    };
    EXPECT_EQ(error_of(folder, with("[\"a\"]")), "accepted");
    EXPECT_THAT(error_of(folder, "{\n"), HasSubstr("collection.json:2: is not JSON: unexpected end of input"));
    EXPECT_THAT(error_of(folder, "{}"), HasSubstr("collection.json: format: must be"));
    EXPECT_THAT(error_of(folder, "[]"), HasSubstr("collection.json: format: must be"));
    EXPECT_THAT(error_of(folder, with("{}")), HasSubstr("collection.json: runs: must be a list of names of folders"));
    EXPECT_THAT(error_of(folder, with("[1]")), HasSubstr("collection.json: runs: 1 must be the name of a folder"));
    EXPECT_THAT(error_of(folder, with("[\"a\"]", "poissonlab-results")), HasSubstr("format: must be"));
    EXPECT_THAT(error_of(folder, with("[\"a\"]", "poissonlab-collection", 2)), HasSubstr("reads version 1"));
    EXPECT_THAT(error_of(folder, with("[]")), HasSubstr("runs: must name at least one folder"));
    for (const char* run : {"", "..", ".hidden", "a/b", "/a", "a/"})
        EXPECT_THAT(error_of(folder, with("[\"" + std::string(run) + "\"]")), HasSubstr("must be the name of a folder"))
            << run;
}

}
}
