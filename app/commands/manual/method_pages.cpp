// Pages of methods: pictures, parameters, advice, and what the gallery measured.
#include "app/commands/manual/manual.hpp"
#include "host/sampling/guide/sampler_guide.hpp"
#include "host/settings/parameter_values.hpp"
#include "host/settings/sampler_registry.hpp"
#include "host/settings/sampler_texts.hpp"
#include "reports/claims/claim_table.hpp"
#include "reports/gallery/gallery.hpp"
#include "reports/gallery/sizes.hpp"
#include "reports/words/number_format.hpp"
#include "results/measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace poissonlab {
namespace {

constexpr std::array page_measures = {"relative_radius", "mean_nearest_distance", "effective_nyquist",
                                      "oscillation",     "low_frequency_mean",    "anisotropy_above_chance"};

std::string sentence(std::string text)
{
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return text.back() == '.' ? text : text + ".";
}

/// DartThrowing of dart-throwing, as the Python package calls it.
std::string python_name(const std::string& sampler)
{
    std::string name;
    bool starts_word = true;
    for (const char letter : sampler) {
        if (letter != '-')
            name += starts_word ? static_cast<char>(std::toupper(static_cast<unsigned char>(letter))) : letter;
        starts_word = letter == '-';
    }
    return name;
}

std::vector<const GalleryMethod*> gallery_of(const std::string& sampler)
{
    std::vector<const GalleryMethod*> found;
    for (const GalleryMethod& method : reference_gallery())
        if (method.sampler == sampler) found.push_back(&method);
    return found;
}

std::string gallery_value(const GalleryMethod& method, const std::string& key)
{
    const auto found = method.measures.find(key);
    if (found == method.measures.end()) return "";
    const Estimate& estimate = found->second;
    return words_of(measure(key), MeasuredValue{estimate.value, estimate.standard_error}).shown;
}

std::string gallery_head()
{
    std::string text = "| |";
    for (const char* key : page_measures) text += fmt::format(" {} |", in_dimension(measure(key).name));
    text += "\n| --- |";
    for ([[maybe_unused]] const char* key : page_measures) text += " --- |";
    return text + "\n";
}

std::string gallery_row(const GalleryMethod& method, const std::string& name)
{
    std::string text = fmt::format("| {} |", name);
    for (const char* key : page_measures) text += fmt::format(" {} |", gallery_value(method, key));
    return text + "\n";
}

std::string gallery_rows(const std::string& sampler)
{
    const auto methods = gallery_of(sampler);
    if (methods.empty()) return "";
    std::string text = "\n## Measured\n\nBy this laboratory, each the mean over independent sets: [the gallery]"
                       "(../gallery/README.md) has the curves, their errors, and published numbers beside these; "
                       "[measures](../measures.md) says how to read them.\n\n" +
                       gallery_head();
    for (const GalleryMethod* method : methods)
        text += gallery_row(*method, fmt::format("{}, {}D, N = {}", method->label, method->curve.dimension,
                                                 format_count(method->curve.points)));
    return text;
}

std::string pictures(const SamplerSpec& spec)
{
    if (gallery_of(spec.name).empty()) return "";
    const auto figure = [&](const char* what, const char* extension, const std::string& caption) {
        return fmt::format("<figure><img src=\"pictures/{0}-{1}.{2}\" alt=\"{3}: {1}\" /><figcaption>{4}</figcaption>"
                           "</figure>\n",
                           spec.name, what, extension, spec.title, caption);
    };
    const bool in_space = spec.dimensions.front() == 3;
    return "\n<div class=\"pictures\" markdown=\"0\">\n" +
           figure("points", "svg", in_space ? "Points of a slab at z = 0." : "Points.") +
           figure("spectrum", "png",
                  spec.deterministic ? "The periodogram, logarithmic, frequency 0 in the middle."
                                     : "The power spectrum of ten sets, logarithmic, frequency 0 in the middle.") +
           fmt::format("<figure><img src=\"{}.svg\" alt=\"{}: radially averaged power\" /><figcaption>Power over "
                       "frequency, from the gallery; random points have 1.</figcaption></figure>\n",
                       spec.name, spec.title) +
           "</div>\n";
}

std::string use_of(const SamplerSpec& spec)
{
    std::string text = fmt::format("\n    [[method]]\n    sampler = \"{}\"\n", spec.name);
    for (const ParameterSpec& parameter : spec.parameters)
        if (!parameter.otherwise && parameter.unless_given.empty())
            text += fmt::format("    {} = ...    # {}\n", parameter.key, allowed_values(parameter));
    return text + fmt::format("\nin a [config](../experiments.md); in [Python](../python.md) `pl.{}(...)`.\n",
                              python_name(spec.name));
}

std::string cost_of(const SamplerSpec& spec)
{
    const bool on_host = spec.memory_growth == MemoryGrowth::none;
    const std::string memory =
        on_host ? "It works on the host and takes no device memory."
                : sentence(memory_growths[spec.memory_growth]) + " N is the number of points of a set.";
    const std::string sizes = size_table(spec.name);
    return "\n## Cost\n\n" + memory +
           (sizes.empty()
                ? ""
                : " Time of all processor cores together, and the most memory of the process, on the machine of "
                  "[sizes](../scale.md):\n\n" +
                      sizes) +
           "\nRatios to other programs: [performance](../performance.md).\n";
}

/// Sentences of papers that looked at sets of a sampler here; more of them disagree than one would think.
std::string claims_about(const SamplerSpec& spec)
{
    std::string text;
    for (const StoredClaim& claim : reference_claims()) {
        if (std::ranges::find(claim.samplers, spec.name) == claim.samplers.end()) continue;
        text += fmt::format("- *{}* {}{}<br>**{}**: {}\n", claim.says, claim.paper,
                            claim.section.empty() ? "" : ", " + claim.section, claim.agreement, claim.measured);
    }
    if (text.empty()) return "";
    return "\n## What papers say\n\nEach sentence with what was measured here, judged by a criterion that reports "
           "state; "
           "*open*: within two standard errors, *shown*: nothing could refute it. The methods that it names are "
           "compared, so it may stand on several pages.\n\n" +
           text;
}

/// Says what the method takes where its sets lie in a region.
std::string in_regions(const SamplerSpec& spec)
{
    const SamplerSpec* in_region = find_sampler(spec.name, region_sampler_registry());
    if (!in_region) return "";
    const std::string where = "\n## In a region\n\nWith `region` in the method, or in `[analysis]`, its sets lie in "
                              "[polygons with holes](../regions.md#methods-over-several-sets), in units of their own";
    if (in_region->parameters.empty()) return where + ".\n";
    return where + ":\n\n" + parameters_markdown(*in_region);
}

std::string method_page(const SamplerSpec& spec)
{
    const SamplerGuide& guide = sampler_guide(spec.name);
    std::string text = fmt::format("# {}\n\n`{}`: {} In {}.\n", spec.title, spec.name, sentence(spec.summary),
                                   spec.dimensions.size() == 2    ? "2D and 3D"
                                   : spec.dimensions.front() == 3 ? "3D"
                                                                  : "2D");
    text += pictures(spec);
    text += fmt::format("\n**When to use it.** {}\n\n**When not.** {}\n\n**Source.** {}\n", guide.use, guide.avoid,
                        guide.source);
    text += use_of(spec);
    if (!spec.parameters.empty()) text += "\n## Parameters\n\n" + parameters_markdown(spec);
    text += in_regions(spec);
    return text + cost_of(spec) + gallery_rows(spec.name) + claims_about(spec);
}

std::string title_in_choice(const SamplerSpec& spec, bool has_pages)
{
    return has_pages ? fmt::format("[{}](methods/{}.md)", spec.title, spec.name) : spec.title;
}

std::string choice_page(bool has_pages)
{
    std::string text = "# Which method\n\n";
    text += has_pages ? "Every method has a page with pictures, its parameters, and what was measured. "
                      : "`./lab docs` makes a page for every method, with pictures, and what was measured; [one "
                        "table](results.md#todays-methods-on-one-scale) compares them. ";
    text += "All of them take the same keys in configs, arguments in Python, and appear in the same "
            "reports; [samplers](samplers.md) has all parameters in one table.\n\n| | | use it |\n| --- | --- "
            "| --- |\n";
    for (const SamplerSpec& spec : sampler_registry()) {
        std::string traits = spec.dimensions.size() == 2 ? "2D, 3D" : fmt::format("{}D", spec.dimensions.front());
        text += fmt::format("| {} | `{}`, {} | {} |\n", title_in_choice(spec, has_pages), spec.name, traits,
                            first_sentence(sampler_guide(spec.name).use));
    }
    return text;
}

}

std::string stored_choice_page() { return choice_page(false); }

std::string scale_table()
{
    std::string text = gallery_head();
    for (const GalleryMethod* method : reference_gallery(2)) text += gallery_row(*method, method->label);
    return text;
}

ManualPages method_pages()
{
    ManualPages pages{{"methods.md", choice_page(true)}};
    for (const SamplerSpec& spec : sampler_registry())
        pages[fmt::format("methods/{}.md", spec.name)] = method_page(spec);
    return pages;
}

}
