// The pages of the documentation that the program writes.
#include "app/commands/manual/manual.hpp"
#include "app/commands/manual/sampler_guide.hpp"
#include "host/config/sampler_registry.hpp"
#include "results/measures.hpp"
#include "tests/support/places.hpp"
#include "tests/support/program.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

using testing::HasSubstr;

TEST(Manual, TheTableOfResultsIsTheOneThatIsPrinted)
{
    const std::string page = content_of(source_folder() + "/docs/results.md");
    const std::string begin = "<!-- printed by `poissonlab manual --scale` -->\n", end = "<!-- end of the scale -->";
    const std::size_t from = page.find(begin), to = page.find(end);
    ASSERT_NE(from, std::string::npos);
    ASSERT_NE(to, std::string::npos);
    EXPECT_EQ(page.substr(from + begin.size(), to - from - begin.size()), scale_table());
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
