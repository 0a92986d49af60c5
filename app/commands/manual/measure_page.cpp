// The page of measures: what each means, and which methods of the gallery are good and bad at it.
#include "app/commands/manual/manual.hpp"
#include "reports/gallery/gallery.hpp"
#include "reports/words/number_format.hpp"
#include "results/measures.hpp"
#include "results/texture_measures.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
namespace {

/// The number of sets that most methods of the gallery have.
constexpr int sets_of_most = 10;

std::string example(const Measure& measure, const GalleryMethod& method, const char* word)
{
    const Estimate& estimate = method.measures.at(measure.key);
    return fmt::format("{}: {} ({})", word,
                       words_of(measure, MeasuredValue{estimate.value, estimate.standard_error}).shown, method.label);
}

/// The best and the worst of the gallery's methods in the plane, as a sentence; empty where it has none.
std::string examples(const Measure& measure)
{
    std::vector<const GalleryMethod*> methods;
    for (const GalleryMethod* method : reference_gallery(2))
        if (method->measures.contains(measure.key)) methods.push_back(method);
    if (measure.key == "peak_anisotropy") // which compares between as many sets only
        std::erase_if(methods, [](const GalleryMethod* method) { return method->curve.periodograms != sets_of_most; });
    if (methods.size() < 2) return "";
    const auto value = [&](const GalleryMethod* method) { return method->measures.at(measure.key).value; };
    const auto [low, high] = std::ranges::minmax(methods, {}, value);
    const bool from_high = measure.better == Better::higher;
    if (measure.better == Better::neither)
        return fmt::format(" In the gallery {}, {}.", example(measure, *low, "least"), example(measure, *high, "most"));
    return fmt::format(" In the gallery {}, {}.", example(measure, from_high ? *high : *low, "best"),
                       example(measure, from_high ? *low : *high, "worst"));
}

std::string measure_section(const Measure& measure, bool with_examples)
{
    const std::string unit = in_dimension(measure.unit);
    std::string text = fmt::format("\n### {}\n\n`{}`{}{}\n", in_dimension(measure.title()), measure.key,
                                   unit.empty() ? "" : ", " + unit,
                                   measure.better == Better::higher  ? ". Higher is better."
                                   : measure.better == Better::lower ? ". Lower is better."
                                                                     : ".");
    const std::string meaning = in_dimension(measure.meaning) + (with_examples ? examples(measure) : "");
    return meaning.empty() ? text : text + "\n" + meaning + "\n";
}

}

std::string measure_page()
{
    std::string text =
        "# Measures\n\nEvery number of a report, of results.json and of `diff`. Numbers of several sets "
        "come with one standard error; [the output folder](output-folder.md) says where they are "
        "stored. No measure alone makes a set good: a lattice has the largest radius, and regular points "
        "a small zone plate error.\n\n## Of point sets\n";
    for (const Measure& measure : measures()) text += measure_section(measure, true);
    text += "\n## Of texture tiles\n";
    for (const Measure& measure : texture_measures()) text += measure_section(measure, false);
    return text;
}

}
