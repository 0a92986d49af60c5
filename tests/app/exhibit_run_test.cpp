// A run makes pictures of tables beside its methods: they stand alone where a method is left out, and after a
// change of a label all results are reused.
#include "tests/support/program.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <set>

namespace poissonlab {
namespace {

using testing::HasSubstr;

class ExhibitRun : public testing::Test
{
protected:
    Outcome run(const std::string& config) const
    {
        folder_.write("c.toml", "engine = \"reference\"\n" + config);
        return run_program(folder_.path(), {"run", "c.toml", "--out", "out", "--quiet"});
    }

    /// The units that are stored.
    std::set<std::string> units() const
    {
        std::set<std::string> names;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path() / "out" / ".units"))
            names.insert(entry.path().string());
        return names;
    }

    TemporaryFolder folder_;
};

TEST_F(ExhibitRun, OfAnyKindStandsWithoutTheMethodThatIsMissing)
{
    const std::string missing =
        "[[method]]\nsampler = \"command\"\ncommand = \"true {points} {seed} {out}\"\nneeds = \"false\"\n";
    for (const std::string table : {"[[scheme]]\nkind = \"corner-problem\"\n", "[[packing]]\n", "[[tile_set]]\n",
                                    "[[construction]]\nkind = \"set\"\nshow = \"lloyd\"\npoints = 9\n"}) {
        const Outcome outcome = run(missing + table);
        EXPECT_EQ(outcome.status, 0) << table << outcome.error;
    }
}

TEST_F(ExhibitRun, WithAnotherLabelIsNotMadeAnew)
{
    const std::string tables = "[[scheme]]\nkind = \"corner-problem\"\nlabel = \"A\"\n[[packing]]\nlabel = \"A\"\n"
                               "[[tile_set]]\nlabel = \"A\"\n[[construction]]\nkind = \"set\"\npoints = 9\nlabel = "
                               "\"A\"\n[[texture]]\npattern = \"noise\"\npattern_size = 64\nsize = 16\ncolors = 2\n"
                               "attempts = 2\nshow = [\"set\"]\nlabel = \"A\"\n";
    ASSERT_EQ(run(tables).status, 0);
    const auto before = units();
    std::string others = tables;
    for (std::size_t at = 0; (at = others.find("\"A\"", at)) != std::string::npos;) others[at + 1] = 'B';
    ASSERT_EQ(run(others).status, 0);
    EXPECT_EQ(units(), before);
    std::ifstream file(folder_.path() / "out" / "results.json");
    const auto json = nlohmann::json::parse(file);
    for (const char* member : {"tilings", "constructions", "schemes", "distributions"})
        EXPECT_EQ(json.at(member).at(0).at("label"), "B") << member;
}

}
}
