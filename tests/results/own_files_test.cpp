// Files of output folders that other programs have written.
#include "results/own_files.hpp"

#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

TEST(OwnFiles, AreKnownByWhatTheySay)
{
    const TemporaryFolder folder;
    EXPECT_NO_THROW(check_own_files(folder.path() / "none"));
    EXPECT_NO_THROW(check_own_files(folder.path()));
    folder.write("index.html", "<!DOCTYPE html><head><meta name=\"generator\" content=\"poissonlab\"/></head>");
    folder.write("compare.html", "<link rel=\"stylesheet\" href=\"site/report.css\"/>"); // as version 0.2 wrote them
    folder.write("results.json", "{\n  \"format\": \"poissonlab-results\"");             // cut off
    folder.write("collection.json", "");
    folder.write("notes.html", "mine");
    EXPECT_NO_THROW(check_own_files(folder.path()));
}

TEST(OwnFiles, OfOthersAreNamed)
{
    for (const char* name : {"index.html", "compare.html", "claims.html", "results.json", "collection.json"}) {
        const TemporaryFolder folder;
        folder.write(name, "<html><body>The page of another.</body></html>");
        const std::string said = message_of([&] { check_own_files(folder.path()); });
        EXPECT_EQ(said, "--out " + folder.path().string() + ": has " + (name[0] == 'i' ? "an " : "a ") + name +
                            " that poissonlab did not write; choose another folder");
    }
    const TemporaryFolder folder;
    std::filesystem::create_symlink("nowhere", folder.path() / "index.html");
    EXPECT_NE(refusal_of([&] { check_own_files(folder.path()); }), "accepted") << "a link that leads nowhere";
}

}
}
