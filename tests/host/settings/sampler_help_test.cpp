// The help on samplers is printed from their descriptions.
#include "host/settings/sampler_help.hpp"
#include "host/settings/sampler_texts.hpp"

#include "base/files/whole_file.hpp"
#include "host/settings/sampler_registry.hpp"
#include "tests/support/places.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace poissonlab {
namespace {

using testing::HasSubstr;

/// The description of a parameter of a sampler; both are there.
const ParameterSpec& parameter_of(const std::string& sampler, const std::string& key)
{
    return *std::ranges::find(find_sampler(sampler)->parameters, key, &ParameterSpec::key);
}

TEST(SamplerHelp, TheTableOfTheDocumentationIsTheOneThatIsPrinted)
{
    const std::string page = read_whole_file(source_folder() + "/docs/samplers.md");
    const std::string begin = "<!-- printed by `poissonlab samplers --markdown` -->\n",
                      end = "<!-- end of samplers -->";
    const std::size_t from = page.find(begin), to = page.find(end);
    ASSERT_NE(from, std::string::npos);
    ASSERT_NE(to, std::string::npos);
    EXPECT_EQ(page.substr(from + begin.size(), to - from - begin.size()), samplers_markdown(sampler_registry()));
}

TEST(SamplerHelp, SaysWhatHoldsWhereNothingIsGiven)
{
    const std::string text = samplers_text(sampler_registry(), {});
    EXPECT_THAT(text, HasSubstr("C, colours of corners; the set has C^4 tiles; needed\n"));
    EXPECT_THAT(text, HasSubstr("rho that every tiling has at least; default 0.75\n"));
    EXPECT_THAT(text, HasSubstr("the method that makes the sets to begin with; default random\n"));
    EXPECT_THAT(text, HasSubstr("in units of the torus' side; by default what gives about analysis.points points\n"));
}

TEST(SamplerHelp, OptionsOfCommandsSayTheSame)
{
    EXPECT_EQ(option_help(parameter_of("corner-tiles", "lloyd_iterations")),
              "Lloyd iterations of each piece: an integer from 0 to 100000; default: 20");
    EXPECT_EQ(option_help(parameter_of("corner-tiles", "colors")),
              "C, colours of corners; the set has C^4 tiles: an integer from 1 to 32");
}

/// A default that the config could not have been given would be a mistake in the description.
TEST(SamplerHelp, DefaultsAreOfTheKindAndInTheRangeOfTheirParameter)
{
    using Kind = ParameterSpec::Kind;
    for (const SamplerSpec& sampler : sampler_registry()) {
        for (const ParameterSpec& spec : sampler.parameters) {
            SCOPED_TRACE(sampler.name + ", " + spec.key);
            EXPECT_FALSE(spec.otherwise && !spec.unless_given.empty()) << "said twice";
            if (!spec.otherwise) continue;
            if (spec.kind == Kind::number || spec.kind == Kind::integer) {
                const bool whole = spec.kind == Kind::integer;
                const double value = whole ? static_cast<double>(std::get<std::int64_t>(*spec.otherwise))
                                           : std::get<double>(*spec.otherwise);
                EXPECT_GE(value, spec.minimum);
                EXPECT_LE(value, spec.maximum);
            } else if (spec.kind == Kind::boolean) {
                EXPECT_TRUE(std::holds_alternative<bool>(*spec.otherwise));
            } else if (spec.kind == Kind::choice) {
                EXPECT_THAT(spec.choices, testing::Contains(std::get<std::string>(*spec.otherwise)));
            } else if (spec.kind == Kind::text) {
                EXPECT_FALSE(std::get<std::string>(*spec.otherwise).empty());
            } else {
                EXPECT_EQ(spec.kind, Kind::sampler);
                EXPECT_TRUE(as_sampler(*spec.otherwise));
            }
        }
    }
}

}
}
