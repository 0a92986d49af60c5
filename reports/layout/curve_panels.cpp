// The plots of a series: radially averaged power, anisotropy, pair correlation, iterations, and the sampling test with
// its picture.
#include "analysis/measures/hyperuniformity.hpp"
#include "base/geometry/relative_radius.hpp"
#include "reports/layout/series_panels.hpp"
#include "reports/words/number_format.hpp"
#include "results/curve_tables.hpp"
#include "results/measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {

namespace {

std::string power_caption(const Curve& curve)
{
    const auto peak = peak_power(curve.bins);
    auto text =
        fmt::format("Highest {} at frequency {}. ", format_significant(peak.power, 3), format_exact(peak.frequency));
    if (!curve.principal_frequency) return text + "There is no principal frequency.";
    return text + fmt::format("Principal frequency {}{}.", format_significant(*curve.principal_frequency, 4),
                              curve.has_principal_in_sight() ? "" : ", beyond the axis");
}

Panel power_panel(const ReportSeries& series, std::size_t index, const RunPlots& plots)
{
    const char* rings = series.run->dimension == 3 ? "spherical shells" : "rings";
    return {.stem = "radial",
            .picture = power_alone(plots.power, index, series.curve),
            .title = "Radially averaged power",
            .caption = power_caption(series.curve),
            .guide = fmt::format(
                "The mean of the spectrum over {} of equal frequency; the band shows one standard error. Low "
                "power on the left means little coarse noise. A Poisson disk set has a single gentle peak "
                "near the principal frequency 1/d<sub>min</sub> (dotted), and power 1 beyond. Further peaks "
                "reveal more order.",
                rings),
            .stored = {{"csv", series.run->folder / series.stored->radial_file}},
            .thumbnail = Thumbnail{"radial", "Radial power"}};
}

/// The fit to the lowest frequencies; of results without it, that to all low ones.
std::optional<LowFrequencyPower> lowest_fit(const ReportSeries& series)
{
    const Measures& measures = series.stored->measures;
    const auto found = measures.numbers.find("hyperuniformity_exponent");
    if (found == measures.numbers.end()) return measures.low_frequency_power;
    const int tiles = measures.lattice_peaks ? measures.lattice_peaks->tiles : 0;
    const FrequencyRange range = hyperuniform_range(series.stored->points, series.run->dimension, tiles);
    LowFrequencyPower law;
    law.exponent = found->second.value;
    law.exponent_standard_error = found->second.standard_error.value_or(0);
    law.begin = range.begin;
    law.end = std::floor(range.end);
    return law;
}

/// The fit where it is a power law.
std::optional<LowFrequencyPower> lowest_power_law(const ReportSeries& series)
{
    const auto fit = lowest_fit(series);
    if (fit && is_power_law(*series.stored, fit->exponent, fit->exponent_standard_error)) return fit;
    return std::nullopt;
}

std::string slope_caption(const ReportSeries& series)
{
    if (series.stored->region)
        return "The region's boundary decides the lowest frequencies: they have no slope of the set's own.";
    const auto law = lowest_power_law(series);
    if (!law && !lowest_fit(series))
        return "There is too little power, or there are too few rings, at low frequencies to fit a slope.";
    auto text =
        law ? fmt::format("Dashed: from frequency {} to {} the power is proportional to the frequency to the power of "
                          "{}.",
                          format_exact(law->begin), format_exact(law->end),
                          format_estimate(law->exponent, law->exponent_standard_error, 3).text())
            : "The power rises towards frequency 0: no exponent describes it.";
    const auto& numbers = series.stored->measures.numbers;
    if (const auto p = numbers.find("hyperuniformity_p_value"); p != numbers.end())
        text += fmt::format(" Test for hyperuniformity: p = {}.", format_significant(p->second.value, 2));
    return text;
}

Panel structure_factor_panel(const ReportSeries& series, std::size_t index, const RunPlots& plots)
{
    return {
        .stem = "structure-factor",
        .picture = structure_factor_alone(plots.structure, index, series.curve, lowest_power_law(series)),
        .title = "Structure factor",
        .caption = slope_caption(series),
        .guide =
            "The radially averaged power with both axes logarithmic, so that power laws are straight lines. A set is "
            "<b>hyperuniform</b> if its power vanishes towards frequency 0: the curve keeps falling to the left, "
            "and the steeper it falls, the faster the errors of integrals decrease with <i>N</i>. A constant level "
            "instead, however low, is noise that remains at all scales, as in random points (1) and dart throwing "
            "(0.06). <b>Stealthy</b> sets have no power at all below some frequency, in practice at most "
            "10<sup>−3</sup>: their curve has a cliff, which no exponent describes. The error of the slope assumes "
            "a straight line; where the curve bends, the slope is only a mean. The test asks whether power remains "
            "at frequency 0: if <i>p</i> is below 0.05, the set is not hyperuniform, however small that power is.",
        .stored = {{"csv", series.run->folder / series.stored->radial_file}}};
}

Panel anisotropy_panel(const ReportSeries& series, std::size_t index, const RunPlots& plots)
{
    const bool in_space = series.run->dimension == 3;
    return {
        .stem = "anisotropy",
        .picture = anisotropy_alone(plots.anisotropy, index, series.curve),
        .title = "Anisotropy",
        .caption = fmt::format("Dashed: what noise alone gives, −10 log₁₀ K = {} dB for K\u00a0=\u00a0{}; the measure "
                               "“anisotropy above chance” is counted from there.",
                               format_fixed(series.curve.background_db, 1), series.curve.periodograms),
        .guide =
            fmt::format("How much the power varies along each {}. Chance alone gives −10 log₁₀ <i>K</i> dB (dashed). "
                        "Where the curve follows that line, no direction is preferred; values far above it come "
                        "from a grid, from tiles, or from rows. The first few {} hold few samples and scatter.",
                        in_space ? "shell" : "ring", in_space ? "spherical shells" : "rings"),
        .stored = {{"csv", series.run->folder / series.stored->radial_file}}};
}

Panel pair_correlation_panel(const ReportSeries& series, std::size_t index, const RunPlots& plots)
{
    const auto& bins = series.pair_correlation;
    const auto peak = *std::ranges::max_element(bins, {}, &PairCorrelationBin::value);
    const double unit = max_min_distance(series.stored->points, series.run->dimension);
    const auto own = own_unit(*series.stored);
    const std::string largest =
        own ? format_significant(unit * own->lengths, 4) + " " + own->name : format_significant(unit, 4);
    return {
        .stem = "pair-correlation",
        .picture = pair_correlation_alone(
            plots.pairs, index,
            series.stored->relative_radius ? std::optional(series.stored->relative_radius->mean) : std::nullopt),
        .title = "Pair correlation",
        .caption = fmt::format("Highest {} at {} of the largest possible minimum distance, {}.",
                               format_significant(peak.value, 3), format_fixed(peak.distance / unit, 2), largest),
        .guide =
            "The number of points at each distance from a point, divided by the number that random points would have "
            "there (dashed). It is 0 up to the minimum distance (dotted). A peak marks a distance at which many points "
            "have neighbours, and further waves show that order reaches far. The band shows one standard error.",
        .stored = {{"csv", series.run->folder / series.stored->pair_correlation_file}}};
}

Panel number_variance_panel(const ReportSeries& series, std::size_t index, const RunPlots& plots)
{
    const NumberVarianceBin& last = series.number_variance.back();
    return {
        .stem = "number-variance",
        .picture = alone(plots.variance, index),
        .title = "Number variance",
        .caption =
            fmt::format("{} within a radius of {}, where {} points are expected.", format_significant(last.variance, 3),
                        format_significant(last.radius, 3), format_significant(last.points, 4)),
        .guide = fmt::format(
            "The variance of the number of points in a {} at a random place, divided by that of random points "
            "(dashed). A set is <b>hyperuniform</b> if the curve keeps falling. It cannot fall faster than one over "
            "the radius, because points enter and leave at the {}.",
            series.run->dimension == 3 ? "ball" : "disk", series.run->dimension == 3 ? "surface" : "rim"),
        .stored = {{"csv", series.run->folder / series.stored->number_variance_file}}};
}

/// "Mean over 10 sets in the band from the least to the largest.", and how many stopped before the others.
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

std::string radius_caption(const Iterations& iterations)
{
    const auto& means = iterations.relative_radius.mean;
    const auto best = std::ranges::max_element(means);
    auto text = from_to(iterations.relative_radius, iterations.count());
    if (best != means.end() - 1)
        text += fmt::format("Largest {} after {}. ", format_fixed(*best, 4),
                            format_count(static_cast<std::uint64_t>(best - means.begin())));
    if (const auto& within = iterations.relative_radius_within_tiles)
        text += fmt::format("Within tiles from {} to {}. ", format_fixed(within->mean.front(), 4),
                            format_fixed(within->mean.back(), 4));
    return text + means_of_what(iterations);
}

std::string energy_guide(const ReportSeries& series)
{
    if (series.stored->sampler == "gaussian-blue-noise")
        return "The mean sum of the Gaussians of all points at a point, less that of evenly spread points: the method "
               "minimises it. Random points have about 1, and no set has less than 0. Where points follow a density, "
               "its "
               "attraction counts as well: the energy may rise a little, and end below 0.";
    if (series.stored->sampler == "target-spectrum")
        return "The mean squared difference between the radially averaged power of a set and its target curve, over "
               "all "
               "rings: the method minimises it.";
    return "The mean squared distance from a place to the nearest point, times <i>N</i><sup>2/<i>d</i></sup>: it is "
           "small "
           "where the points serve all places equally well. The dashed line is the best lattice; random points have "
           "about 0.32 in 2D and 0.35 in 3D.";
}

}

void add_curve_panels(const ReportSeries& series, std::size_t index, const RunPlots& plots, std::vector<Panel>& panels)
{
    if (series.stored->has_spectrum()) {
        panels.push_back(power_panel(series, index, plots));
        panels.push_back(structure_factor_panel(series, index, plots));
        panels.push_back(anisotropy_panel(series, index, plots));
    }
    if (!series.pair_correlation.empty()) panels.push_back(pair_correlation_panel(series, index, plots));
    if (!series.number_variance.empty()) panels.push_back(number_variance_panel(series, index, plots));
}

void add_iteration_panels(const ReportSeries& series, std::size_t index, const RunPlots& plots,
                          std::vector<Panel>& panels)
{
    if (!series.stored->iterations) return;
    const auto& iterations = *series.stored->iterations;
    const StoredFile csv{"csv", series.run->folder / iterations.file};
    std::string guide =
        "How the minimum distance grows while the method moves the points; iteration 0 is the start. Where the curve "
        "is "
        "level, nothing more is gained. The line is the mean over those of the <i>K</i> sets that came so far, and the "
        "band extends from the smallest to the largest.";
    if (iterations.relative_radius_within_tiles)
        guide += " The line is for tilings, and dots are for the closest two points of one tile: the difference is "
                 "lost where "
                 "tiles meet.";
    panels.push_back({.stem = "relative-radius",
                      .picture = alone(*plots.radius, index),
                      .title = "Relative radius over iterations",
                      .caption = radius_caption(iterations),
                      .guide = guide,
                      .stored = {csv}});
    const std::optional<Plot>& energy = has_own_energy(series) ? plots.own_energy : plots.energy;
    if (!energy || !has_curve(*energy, index)) return;
    panels.push_back({.stem = "energy",
                      .picture = alone(*energy, index),
                      .title = "Energy over iterations",
                      .caption = from_to(iterations.energy, iterations.count()) + means_of_what(iterations),
                      .guide = energy_guide(series),
                      .stored = {csv}});
}

}
