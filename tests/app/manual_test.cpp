// The pages of the documentation that the program writes.
#include "app/commands/manual/manual.hpp"
#include "base/errors/errors.hpp"
#include "experiment/config/config.hpp"
#include "experiment/exhibits/exhibit.hpp"
#include "host/kinds/kinds.hpp"
#include "host/sampling/guide/sampler_guide.hpp"
#include "host/settings/sampler_registry.hpp"
#include "results/measures.hpp"
#include "tests/support/places.hpp"
#include "tests/support/program.hpp"

#include <gmock/gmock.h>

#include <regex>
#include <set>

namespace poissonlab {
namespace {

using testing::HasSubstr;

/// The words that a pattern's first group finds in a text.
std::set<std::string> words_in(const std::string& text, const std::string& pattern)
{
    const std::regex expression(pattern);
    std::set<std::string> words;
    for (std::sregex_iterator found(text.begin(), text.end(), expression), end; found != end; ++found)
        words.insert((*found)[1]);
    return words;
}

TEST(Manual, PagesHaveTheResultsThatAreStored)
{
    for (const char* name : {"/docs/results.md", "/docs/chain-tiles.md", "/docs/scale.md"}) {
        const std::string page = content_of(source_folder() + name);
        EXPECT_NE(page.find("<!--= "), std::string::npos) << name;
        EXPECT_EQ(with_stored_results(page, name), page) << "poissonlab manual --results docs/results.md "
                                                            "docs/chain-tiles.md docs/scale.md puts them in anew";
    }
}

TEST(Manual, StoredResultsArePutInByName)
{
    const auto filled = [](const std::string& page) { return with_stored_results(page, "p.md"); };
    EXPECT_EQ(filled("at <!--= value regular relative_radius 4 -->0.5<!--/--> it is"),
              "at <!--= value regular relative_radius 4 -->0.9306<!--/--> it is");
    EXPECT_THAT(filled("<!--= measure random mean_nearest_distance 4 --><!--/-->"), HasSubstr("0.4658 ± 0.0007"));
    EXPECT_THAT(filled("<!--= scale -->\n<!--/-->"), HasSubstr("| Random |"));
    const std::vector<std::pair<const char*, const char*>> wrong = {
        {"a\n<!--= value random relative_radius 4 -->", "p.md:2: <!--= must be closed by <!--/-->"},
        {"<!--= value nobody relative_radius 4 --><!--/-->", "p.md:1: the gallery has no method nobody"},
        {"<!--= value random beauty 4 --><!--/-->", "p.md:1: random has no measure beauty"},
        {"<!--= words --><!--/-->",
         "p.md:1: \"words\": must be measure, value, scale, seams, even, averaged, sizes or claims"}};
    for (const auto& [page, problem] : wrong) {
        const auto fill = [&filled, &text = page] { filled(text); };
        EXPECT_THAT(fill, testing::ThrowsMessage<InputError>(HasSubstr(problem)));
    }
}

TEST(Manual, PagesOfMethodsHaveTheClaimsAboutThem)
{
    const ManualPages pages = method_pages();
    EXPECT_THAT(pages.at("methods/farthest-point.md"), HasSubstr("The nearest two points come to have 0.925"));
    EXPECT_THAT(pages.at("methods/dart-throwing.md"), HasSubstr("## What papers say"));
    EXPECT_THAT(pages.at("methods/random.md"), testing::Not(HasSubstr("0.925 of the largest")));
}

TEST(Manual, EveryMethodHasAPageWithItsParametersAndStoredPictures)
{
    const ManualPages pages = method_pages();
    for (const SamplerSpec& spec : sampler_registry()) {
        SCOPED_TRACE(spec.name);
        const std::string& page = pages.at("methods/" + spec.name + ".md");
        for (const ParameterSpec& parameter : spec.parameters)
            EXPECT_THAT(page, HasSubstr("| `" + parameter.key + "` |"));
        for (const char* picture : {"-points.svg", "-spectrum.png"}) {
            const std::string file = "pictures/" + spec.name + picture;
            const bool is_shown = page.find(file) != page.npos;
            EXPECT_TRUE(!is_shown || std::filesystem::exists(source_folder() + "/docs/methods/" + file)) << file;
        }
        EXPECT_THAT(pages.at("methods.md"), HasSubstr("(methods/" + spec.name + ".md)"));
    }
}

TEST(Manual, TheCheckoutSaysWhichMethodToUse)
{
    EXPECT_EQ(content_of(source_folder() + "/docs/methods.md"), stored_choice_page())
        << "poissonlab manual --stored . writes it anew";
}

TEST(Manual, EveryKindHasAPageWithItsKeysAnExampleAndAPicture)
{
    const ManualPages pages = kind_pages();
    const std::filesystem::path folder = source_folder() + "/docs/kinds";
    const Config examples = read_config(folder / "examples.toml");
    std::set<const Kind*> with_example;
    for (const Exhibit& exhibit : read_exhibits(examples)) with_example.insert(exhibit.kind);
    for (const Kind& kind : all_kinds()) {
        if (kind.table.empty()) continue;
        const std::string name = kind.word.empty() ? kind.table : kind.table + "-" + kind.word;
        SCOPED_TRACE(name);
        EXPECT_TRUE(with_example.contains(&kind));
        const std::string& page = pages.at("kinds/" + name + ".md");
        EXPECT_THAT(page, HasSubstr("    [[" + kind.table + "]]\n"));
        for (const KeySpec& key : kind.keys()) EXPECT_THAT(page, HasSubstr("| `" + key.value.key + "`"));
        // Costs of tilings are numbers.
        EXPECT_EQ(page.find("src=\"pictures/" + name) != page.npos, name != "scheme-tiling-costs");
        for (const std::string& picture : words_in(page, "src=\"(pictures/[^\"]*)\""))
            EXPECT_TRUE(std::filesystem::exists(folder / picture)) << picture;
        EXPECT_THAT(pages.at("beside-methods.md"), HasSubstr("(kinds/" + name + ".md)"));
    }
}

TEST(Manual, EverySamplerHasAGuide)
{
    for (const SamplerSpec& sampler : sampler_registry()) {
        SCOPED_TRACE(sampler.name);
        ASSERT_NO_THROW(sampler_guide(sampler.name));
        for (const std::string& text :
             {sampler_guide(sampler.name).source, sampler_guide(sampler.name).use, sampler_guide(sampler.name).avoid})
            EXPECT_TRUE(text.ends_with(".")) << text;
    }
}

TEST(Manual, EveryMeasureIsExplained)
{
    const std::string page = measure_page();
    for (const Measure& measure : measures()) EXPECT_THAT(page, HasSubstr("`" + measure.key + "`"));
}

TEST(Manual, TheReadmeIsShort)
{
    EXPECT_LE(content_of(source_folder() + "/README.md").size(), 8000U);
    for (const auto& entry : std::filesystem::directory_iterator(source_folder() + "/docs/pictures"))
        EXPECT_LE(entry.file_size(), 200'000U) << entry.path();
}

}
}
