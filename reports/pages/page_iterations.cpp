// The panels of iterative methods: relative radius and energy over iterations.
#include "reports/pages/page_parts.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {

namespace {

// "Mean over 10 sets in the band from the least to the largest.", and how many stopped before the others.
std::string means_of_what(const Iterations& iterations)
{
    const auto first = static_cast<std::uint64_t>(iterations.realizations.front());
    const auto last = static_cast<std::uint64_t>(iterations.realizations.back());
    if (first == 1) return "Of one set.";
    auto text = fmt::format("Mean over {} sets, in the band from the least to the largest", format_count(first));
    if (last < first)
        text += fmt::format("; {} of them went on to the end, and means are over those that did", format_count(last));
    return text + ".";
}

std::string from_to(const IterationSpread& spread, std::size_t count)
{
    return fmt::format("From {} to {} in {} iteration{}. ", format_fixed(spread.mean.front(), 4),
                       format_fixed(spread.mean.back(), 4), format_count(count), count == 1 ? "" : "s");
}

}

PageData relative_radius_panel(const ReportSeries& series)
{
    if (!series.stored->iterations) return false;
    const auto& iterations = *series.stored->iterations;
    const auto& means = iterations.relative_radius.mean;
    const auto best = std::ranges::max_element(means);
    auto caption = from_to(iterations.relative_radius, iterations.count());
    if (best != means.end() - 1)
        caption += fmt::format("Largest {} after {}. ", format_fixed(*best, 4),
                               format_count(static_cast<std::uint64_t>(best - means.begin())));
    return picture_panel(series, {"relative-radius.svg", "relative-radius.png", "is_radius"},
                         "Relative radius over iterations", caption + means_of_what(iterations));
}

PageData energy_panel(const ReportSeries& series)
{
    if (!series.stored->iterations) return false;
    const auto& iterations = *series.stored->iterations;
    const auto caption = from_to(iterations.energy, iterations.count()) + means_of_what(iterations);
    return picture_panel(series, {"energy.svg", "energy.png", "is_energy"}, "Energy over iterations", caption);
}

}
