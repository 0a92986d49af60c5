// Programs with some of the modules: what the core knows of the others, and how it asks for them.
#include "app/command_tree.hpp"
#include "app/commands/core/stored_text.hpp"
#include "base/files/whole_file.hpp"
#include "host/modules/laboratory.hpp"
#include "tests/support/places.hpp"
#include "tests/support/program.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iterator>
#include <set>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

/// The program that has no module, beside the one that has all.
std::string core_file() { return (fs::path(program_file()).parent_path() / "poissonlab_core").string(); }

const std::string small_config = "[analysis]\npoints = 64\nrealizations = 2\nspectrum_size = 16\n";

class CoreProgram : public testing::Test
{
protected:
    Outcome core(const std::string& arguments, const std::string& environment = "")
    {
        return run_in_shell(folder_.path(), environment + " " + quoted(core_file()) + " " + arguments);
    }
    Outcome whole(const std::string& arguments) { return run_program_line(folder_.path(), arguments); }
    Outcome run_of(const std::string& tables, const std::string& environment = "")
    {
        folder_.write("c.toml", small_config + tables);
        return core("run c.toml --quiet --out out", environment);
    }

    TemporaryFolder folder_;
};

TEST(Manifest, HasTheWordsOfAllModules)
{
    std::vector<ManifestEntry> entries = entries_of_laboratory();
    std::ranges::move(entries_of_commands(), std::back_inserter(entries));
    EXPECT_EQ(manifest_text(entries), read_whole_file(fs::path(source_folder()) / "host/modules/manifest.tsv"))
        << "print it anew: poissonlab manual --stored .";
    EXPECT_TRUE(has_all_modules());
}

/// A mistyped name in the list of another module would be a word that no module brings.
TEST(Manifest, NamesModulesThatAreBuilt)
{
    std::set<std::string> built;
    for (const Module& module : built_modules()) built.insert(module.name);
    for (const ManifestEntry& entry : entries_of_commands()) built.insert(entry.module);
    for (const ManifestEntry& entry : manifest()) EXPECT_TRUE(built.contains(entry.module)) << entry.name;
}

TEST_F(CoreProgram, SaysWhatTheWholeProgramSays)
{
    for (const char* arguments :
         {"help", "samplers", "kinds", "completion bash", "completion zsh", "smaplers", "tiles biuld", "tiles",
          "help tiles", "help tlies", "texture bulid --out a", "--version", "run c.toml --set method.0.sampler=lyod"}) {
        SCOPED_TRACE(arguments);
        folder_.write("c.toml", small_config + "[[method]]\nsampler = \"random\"\n");
        const Outcome expected = whole(arguments), outcome = core(arguments);
        EXPECT_EQ(outcome.status, expected.status);
        EXPECT_EQ(outcome.out, expected.out);
        EXPECT_EQ(outcome.error, expected.error);
    }
}

TEST_F(CoreProgram, MakesTheSameResults)
{
    folder_.write("c.toml", small_config + "[[method]]\nsampler = \"dart-throwing\"\nrelative_radius = 0.6\n"
                                           "[[method]]\nsampler = \"lloyd\"\niterations = 2\n");
    ASSERT_EQ(core("run c.toml --quiet --out a").status, 0);
    ASSERT_EQ(whole("run c.toml --quiet --out b").status, 0);
    const auto made = files_below(folder_.path() / "a");
    int points = 0;
    for (const auto& [name, content] : made) {
        if (name.find("points") == std::string::npos || name.find(".html") != std::string::npos) continue;
        ++points;
        EXPECT_EQ(content, content_of(folder_.path() / "b" / name)) << name;
    }
    EXPECT_GE(points, 4) << "files of points, and their pictures";
}

TEST_F(CoreProgram, NamesTheModuleThatAWordNeeds)
{
    for (const auto& [tables, module] : std::vector<std::pair<std::string, std::string>>{
             {"[[method]]\nsampler = \"sobol\"\n", "methods"},
             {"[[method]]\nsampler = \"random\"\norder = \"sample-elimination\"\n", "methods"},
             {"[[method]]\nsampler = \"command\"\ncommand = \"a {out}\"\n", "own_methods"},
             {"[[method]]\nsampler = \"corner-tiles\"\n", "tiles"},
             {"[[method]]\nsampler = \"lloyd\"\niterations = 1\nstart = {sampler = \"penrose\"}\n", "other_tiles"},
             {"region = \"disk 0 0 1\"\n[[method]]\nsampler = \"random\"\n", "regions"},
             {"[[method]]\nsampler = \"random\"\nregion = \"disk 0 0 1\"\n", "regions"},
             {"[[distribution]]\nkind = \"darts\"\n", "regions"},
             {"[[distribution]]\nkind = \"stippling\"\n", "distributions"},
             {"[[distribution]]\nkind = \"mesh-set\"\n", "surface_spectra"},
             {"[[distribution]]\nkind = \"surface-classes\"\n", "surface_classes"},
             {"[[distribution]]\nkind = \"class-set\"\n", "classes"},
             {"[[distribution]]\nkind = \"geometry-tiles\"\n", "geometry_tiles"},
             {"[[distribution]]\nkind = \"recursive-tiles\"\n", "recursive_tiles"},
             {"[[distribution]]\nkind = \"sphere\"\n", "sphere"},
             {"[[texture]]\nexemplar = \"a.png\"\n", "textures"},
             {"dimension = 3\n[[method]]\nsampler = \"random\"\n", "space"},
             {"tiles = 2\n[[method]]\nsampler = \"random\"\n", "tile_measures"},
             {"zone_plate = true\n[[method]]\nsampler = \"random\"\n", "zone_plate"},
             {"[[tiling]]\nkind = \"corner\"\n", "tilings"}}) {
        SCOPED_TRACE(tables);
        const Outcome outcome = run_of(tables);
        EXPECT_EQ(outcome.status, 1);
        EXPECT_THAT(outcome.error, HasSubstr("poissonlab: error: this program was built without the module \"" +
                                             module + "\": build it with "));
        EXPECT_FALSE(fs::exists(folder_.path() / "out/results.json"));
    }
    folder_.write("c.toml", small_config + "[[method]]\nsampler = \"lloyd\"\niterations = 1\n");
    folder_.write("a.ply", "ply\nformat ascii 1.0\n");
    folder_.write("a.h5", "\x89HDF\r\n\x1a\n");
    folder_.write("a.png", "\x89PNG\r\n\x1a\n");
    folder_.write("a.csv", "x,y,class\n0.1,0.2,0\n0.5,0.6,1\n");
    for (const auto& [arguments, module] : std::vector<std::pair<std::string, std::string>>{
             {"tiles build corner", "tiles"},
             {"run c.toml --set 'engine=\"reference\"' --out out", "reference"},
             {"analyze a.ply --out out", "point_formats"},
             {"analyze a.png --out out", "distributions"},
             {"analyze a.csv --classes class --out out", "classes"},
             {"analyze a.h5 --out out", "particles"},
             {"help texture map", "textures"},
             {"distribute darts --help", "regions"},
             {"distribute stipple --help", "distributions"},
             {"texture surface --help", "surface_textures"},
             {"points lloyd --points 9", "large_sets"},
             {"tiling corner", "tilings"},
             {"diff a b", "results"},
             {"manual", "manual"}})
        EXPECT_THAT(core(arguments).error, HasSubstr("the module \"" + module + "\"")) << arguments;
    for (const char* missing : {"b.png", "b.ply", "b.h5"}) // a mistyped name builds nothing
        EXPECT_THAT(core("analyze " + std::string(missing) + " --out out").error, HasSubstr("o such file")) << missing;
    EXPECT_THAT(core("samplers --json").error, HasSubstr("without some of its modules"));
    EXPECT_THAT(run_of("[[method]]\nsampler = \"random\"\n", "OMPI_COMM_WORLD_SIZE=2 OMPI_COMM_WORLD_RANK=0").error,
                HasSubstr("the module \"processes\""));
}

/// A report without claims about tiles would look as if nothing was to be said of them.
TEST_F(CoreProgram, AsksForClaimsAboutTilesWhereResultsHaveThem)
{
    folder_.write("c.toml", small_config + "[[method]]\nsampler = \"corner-tiles\"\ncolors = 2\n");
    ASSERT_EQ(whole("run c.toml --quiet --out tiles").status, 0);
    EXPECT_THAT(core("report tiles --out report").error, HasSubstr("the module \"tilings\""));
    folder_.write("c.toml", small_config + "[[method]]\nsampler = \"random\"\n[[method]]\nsampler = \"sobol\"\n");
    ASSERT_EQ(whole("run c.toml --quiet --out sobol").status, 0);
    const std::string claims = content_of(folder_.path() / "sobol/claims.html");
    fs::remove(folder_.path() / "sobol/claims.html");
    EXPECT_EQ(core("report sobol --out sobol").status, 0);
    EXPECT_EQ(content_of(folder_.path() / "sobol/claims.html"), claims);
}

/// ./lab gets the whole command, word for word, and what it does is what the command does.
TEST_F(CoreProgram, HandsTheCommandToTheScriptThatAddsModules)
{
    folder_.write("lab", "#!/bin/sh\nprintf '<%s>' \"$@\"\ncat\nexit 7\n");
    fs::permissions(folder_.path() / "lab", fs::perms::owner_all);
    const std::string environment = "POISSONLAB_LAB=" + quoted((folder_.path() / "lab").string());
    folder_.write("c.toml", small_config + "[[method]]\nsampler = \"corner-tiles\"\n");
    const Outcome outcome = run_in_shell(folder_.path(), "echo input | " + environment + " " + quoted(core_file()) +
                                                             " run c.toml --set 'title=\"a b\"' --out 'x y'");
    EXPECT_EQ(outcome.status, 7);
    EXPECT_EQ(outcome.out, "<--with><tiles><run><c.toml><--set><title=\"a b\"><--out><x y>input\n");
    EXPECT_THAT(outcome.error, IsEmpty());
    // Words that no module knows call for none.
    EXPECT_EQ(core("tiles biuld", environment).status, 2);
    EXPECT_EQ(run_of("[[method]]\nsampler = \"corner-tlies\"\n", environment).status, 2);
}

}
}
