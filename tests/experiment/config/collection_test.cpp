// Configs that include others: what is read, and one test for each kind of mistake.
#include "experiment/config/collection.hpp"

#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

const std::string random_method = "[[method]]\nsampler = \"random\"\n";

class CollectionConfigs : public testing::Test
{
protected:
    Collection read(const std::string& text, const std::vector<std::string>& overrides = {}) const
    {
        return read_collection(parse_file(folder_.write("all.toml", text)), overrides);
    }

    std::vector<std::string> names(const std::string& text) const
    {
        std::vector<std::string> result;
        for (const CollectedConfig& config : read(text).configs) result.push_back(config.name);
        return result;
    }

    /// The message, with the names of files without their folder.
    std::string error_of(const std::string& text, const std::vector<std::string>& overrides = {}) const
    {
        std::string message = message_of([&] { read(text, overrides); });
        const std::string prefix = folder_.path().string() + "/";
        for (std::size_t at = 0; (at = message.find(prefix)) != std::string::npos;) message.erase(at, prefix.size());
        return message;
    }

    void SetUp() override
    {
        folder_.write("one.toml", "title = \"One\"\nseed = 7\n" + random_method);
        folder_.write("sub/two.toml", "device = \"two's\"\n" + random_method);
        folder_.write("sub/three.toml", random_method);
    }

    TemporaryFolder folder_;
};

TEST_F(CollectionConfigs, AreReadInOrder)
{
    const Collection collection = read("title = \"All\"\ndevice = \"d\"\ninclude = [\"sub/two.toml\", \"one.toml\"]\n");
    EXPECT_EQ(collection.title, "All");
    ASSERT_EQ(collection.configs.size(), 2U);
    EXPECT_EQ(collection.configs[0].name, "two");
    EXPECT_EQ(collection.configs[0].device, "two's") << "a config's own device goes before that of the collection";
    EXPECT_EQ(collection.configs[1].name, "one");
    EXPECT_EQ(collection.configs[1].device, "d");
    EXPECT_EQ(collection.configs[1].config.title, "One");
    EXPECT_EQ(collection.configs[1].config.seed, 7U) << "each keeps its own seed";
    EXPECT_EQ(collection.configs[1].config.device, "");
    EXPECT_EQ(read("include = [\"one.toml\"]").title, "all") << "the file's stem";
}

TEST_F(CollectionConfigs, GlobsAreSortedByName)
{
    EXPECT_THAT(names("include = [\"sub/*.toml\", \"one.toml\"]\n"), ElementsAre("three", "two", "one"));
}

TEST_F(CollectionConfigs, MayIncludeCollections)
{
    folder_.write("sub/inner.toml", "title = \"Inner\"\ndevice = \"i\"\ninclude = [\"two.toml\", \"three.toml\"]\n");
    EXPECT_THAT(names("include = [\"sub/inner.toml\", \"one.toml\"]\n"), ElementsAre("two", "three", "one"));
    const Collection collection = read("device = \"d\"\ninclude = [\"sub/inner.toml\", \"one.toml\"]\n");
    EXPECT_EQ(collection.configs[1].device, "i");
    EXPECT_EQ(collection.configs[2].device, "d");
}

TEST_F(CollectionConfigs, OverridesApplyToEach)
{
    const Collection collection = read("include = [\"one.toml\", \"sub/*.toml\"]\n", {"seed=3", "analysis.points=64"});
    for (const CollectedConfig& collected : collection.configs) {
        EXPECT_EQ(collected.config.seed, 3U);
        EXPECT_EQ(collected.config.points, 64U);
        EXPECT_THAT(collected.config.overrides, ElementsAre("seed=3", "analysis.points=64"));
    }
}

TEST_F(CollectionConfigs, OtherConfigsAreNone)
{
    EXPECT_FALSE(is_collection(parse_file(folder_.path() / "one.toml")));
    EXPECT_THAT(message_of([&] { parse_file(folder_.path()); }), HasSubstr("is a folder"));
    EXPECT_THAT(message_of([&] { parse_file(folder_.path() / "missing.toml"); }), HasSubstr("missing.toml"));
}

TEST_F(CollectionConfigs, HaveNoExperimentOfTheirOwn)
{
    EXPECT_EQ(error_of("include = [\"one.toml\"]\nseed = 1\n"),
              "all.toml:2: seed = 1: cannot be combined with include: a collection has only the keys include, title "
              "and device");
    EXPECT_EQ(
        error_of("include = [\"one.toml\"]\n" + random_method),
        "all.toml:2: method = [{...}]: cannot be combined with include: a collection has only the keys include, title "
        "and device");
    EXPECT_EQ(message_of([&] { read_config(folder_.write("c.toml", random_method), {"include=[\"one.toml\"]"}); }),
              "--set include=[\"one.toml\"]: include = [\"one.toml\"]: makes a config a collection, which has no "
              "experiment of its own");
}

TEST_F(CollectionConfigs, IncludeIsAListOfPaths)
{
    const std::string allowed = "must be a list of paths of configs, such as [\"first.toml\", \"more/*.toml\"]";
    EXPECT_EQ(error_of("include = \"one.toml\"\n"), "all.toml:1: include = \"one.toml\": " + allowed);
    EXPECT_EQ(error_of("include = []\n"), "all.toml:1: include = []: " + allowed);
    EXPECT_EQ(error_of("include = [\n  \"one.toml\",\n  2]\n"), "all.toml:3: include = 2: " + allowed);
}

TEST_F(CollectionConfigs, FilesMustBeThere)
{
    EXPECT_THAT(error_of("include = [\"one.toml\",\n\"four.toml\"]\n"),
                testing::StartsWith("all.toml:2: include = \"four.toml\": no such file in "));
    EXPECT_THAT(error_of("include = [\"sub/x*.toml\"]\n"), HasSubstr("no such file in "));
    EXPECT_THAT(error_of("include = [\"/nowhere/x.toml\"]\n"), EndsWith("include = \"/nowhere/x.toml\": no such file"));
    EXPECT_EQ(error_of("include = [\"sub\"]\n"),
              "all.toml:1: include = \"sub\": sub is a folder; config files (.toml) are needed");
}

TEST_F(CollectionConfigs, EachFileOnce)
{
    EXPECT_EQ(error_of("include = [\"one.toml\", \"sub/../one.toml\"]\n"),
              "all.toml:1: include = \"sub/../one.toml\": one.toml is included twice");
    folder_.write("inner.toml", "include = [\"one.toml\"]\n");
    EXPECT_EQ(error_of("include = [\"one.toml\", \"inner.toml\"]\n"),
              "inner.toml:1: include = \"one.toml\": one.toml is included twice");
}

TEST_F(CollectionConfigs, NamesOfFoldersDiffer)
{
    folder_.write("sub/one.toml", random_method);
    EXPECT_EQ(error_of("include = [\"one.toml\", \"sub/one.toml\"]\n"),
              "all.toml:1: include = \"sub/one.toml\": sub/one.toml: another config has the same name, and with it the "
              "folder \"one\"");
}

TEST_F(CollectionConfigs, CyclesAreShown)
{
    EXPECT_EQ(error_of("include = [\"all.toml\"]\n"),
              "all.toml:1: include = \"all.toml\": goes round in a circle: all.toml includes all.toml");
    folder_.write("b.toml", "include = [\"sub/c.toml\"]\n");
    folder_.write("sub/c.toml", "include = [\"../b.toml\"]\n");
    EXPECT_EQ(
        error_of("include = [\"b.toml\"]\n"),
        "sub/c.toml:1: include = \"../b.toml\": goes round in a circle: b.toml includes sub/c.toml includes b.toml");
}

TEST_F(CollectionConfigs, MistakesInIncludedConfigsAreNamed)
{
    folder_.write("bad.toml", "sede = 1\n" + random_method);
    EXPECT_THAT(error_of("include = [\"one.toml\", \"bad.toml\"]\n"),
                testing::StartsWith("bad.toml:1: sede = 1: unknown key"));
}

TEST_F(CollectionConfigs, SomeOverridesDoNotSuit)
{
    const std::string all = "include = [\"one.toml\"]\n";
    EXPECT_EQ(
        error_of(all, {"method.0.label=White"}),
        "--set method.0.label=White: a collection has no numbered methods; method.KEY=VALUE changes every method that "
        "has KEY");
    EXPECT_THAT(error_of(all, {"title=T"}), HasSubstr("cannot be set"));
    EXPECT_THAT(error_of(all, {"include=[]"}), HasSubstr("cannot be set"));
    EXPECT_THAT(error_of(all, {"method.iterations=3"}),
                testing::StartsWith("one.toml: --set method.iterations=3: iterations = 3: unknown key"));
}

}
}
