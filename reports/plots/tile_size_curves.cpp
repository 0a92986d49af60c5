#include "reports/plots/tile_size_curves.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace poissonlab {

namespace {

constexpr auto size_key = "points_per_tile";

/// Radii that differ by less are the same for readers of a plot.
constexpr double visible_difference = 1e-3;

/// The settings that tile sets that differ only in their number of points have in common.
NamedTexts method_of(const Series& series)
{
    NamedTexts method = {{"sampler", series.sampler}};
    for (const auto& parameter : series.parameters)
        if (parameter.first != size_key) method.push_back(parameter);
    return method;
}

/// "corners, relative_radius = 0.7": of the parameters, those that not all methods have.
std::string label_of(const std::string& kind, const NamedTexts& method, const std::set<NamedTexts>& methods)
{
    std::vector<std::string> words;
    if (!kind.empty()) words.push_back(kind);
    for (const auto& parameter : method) {
        const auto has_it = [&](const NamedTexts& other) { return std::ranges::count(other, parameter) > 0; };
        if (std::ranges::all_of(methods, has_it)) continue;
        words.push_back(parameter.first == "sampler" ? parameter.second
                                                     : fmt::format("{} = {}", parameter.first, parameter.second));
    }
    if (words.empty()) return method.front().second; // the sampler, which all have
    return fmt::format("{}", fmt::join(words, ", "));
}

/// A sample of a series, with the kind of thing that it is about.
struct KindSample
{
    std::string kind;
    TileSizeSample sample;
};

/// The curves of the samples that `samples_of` gives for each series.
template <class SamplesOf>
std::vector<TileSizeCurve> curves_of(const std::vector<const Series*>& series, const SamplesOf& samples_of)
{
    std::set<NamedTexts> methods;
    for (const Series* entry : series)
        if (!samples_of(*entry).empty()) methods.insert(method_of(*entry));

    std::vector<TileSizeCurve> curves;
    std::map<std::string, std::size_t> places; // by label
    for (const Series* entry : series)
        for (const auto& [kind, sample] : samples_of(*entry)) {
            const std::string label = label_of(kind, method_of(*entry), methods);
            const std::size_t place = places.try_emplace(label, curves.size()).first->second;
            if (place == curves.size()) curves.push_back({0, label, {}});
            curves[place].samples.push_back(sample);
        }

    for (TileSizeCurve& curve : curves) std::ranges::stable_sort(curve.samples, {}, &TileSizeSample::points_per_tile);
    std::erase_if(curves, [](const TileSizeCurve& curve) {
        return curve.samples.front().points_per_tile == curve.samples.back().points_per_tile;
    });
    for (std::size_t i = 0; i < curves.size(); ++i) curves[i].index = i;
    return curves;
}

/// The largest dot or place of a line, at least `least`.
double highest_sample(const std::vector<TileSizeCurve>& curves, double least)
{
    for (const TileSizeCurve& curve : curves)
        for (const TileSizeSample& sample : curve.samples) least = std::max({least, sample.dot, sample.line});
    return least;
}

Plot plot_of(const std::vector<TileSizeCurve>& curves, PlotAxis y)
{
    Plot plot;
    for (const TileSizeCurve& source : curves) {
        PlotCurve curve{source.index, source.label};
        for (const TileSizeSample& sample : source.samples) {
            curve.x.push_back(sample.points_per_tile);
            curve.y.push_back(sample.line);
            curve.dots.push_back(sample.dot);
            curve.end = std::max(curve.end, sample.points_per_tile);
        }
        plot.curves.push_back(std::move(curve));
    }
    plot.x = {.label = "points per tile N"};
    plot.y = std::move(y);
    plot.right_margin = 4;
    return together(std::move(plot));
}

}

std::vector<TileSizeCurve> region_curves(const std::vector<const Series*>& series)
{
    return curves_of(series, [](const Series& entry) {
        std::vector<KindSample> samples;
        if (!entry.tile_set) return samples;
        for (const RegionPoints& region : entry.tile_set->regions)
            if (region.name != "interior")
                samples.push_back(
                    {region.name,
                     {static_cast<double>(entry.tile_set->points_per_tile), region.points, region.expected}});
        return samples;
    });
}

std::vector<TileSizeCurve> tile_radius_curves(const std::vector<const Series*>& series)
{
    auto curves = curves_of(series, [](const Series& entry) {
        std::vector<KindSample> samples;
        const auto within = entry.measures.numbers.find("relative_radius_within_tiles");
        if (entry.tile_set && entry.relative_radius && within != entry.measures.numbers.end())
            samples.push_back({"",
                               {static_cast<double>(entry.tile_set->points_per_tile), within->second.value,
                                entry.relative_radius->mean}});
        return samples;
    });
    const auto differs = [](const TileSizeSample& sample) { return sample.dot - sample.line > visible_difference; };
    const bool any = std::ranges::any_of(
        curves, [&](const TileSizeCurve& curve) { return std::ranges::any_of(curve.samples, differs); });
    return any ? curves : std::vector<TileSizeCurve>{};
}

Plot region_points_plot(const std::vector<TileSizeCurve>& curves)
{
    const double most_points = highest_sample(curves, 1);
    const double step = most_points > 10 ? 4 : most_points > 4 ? 2 : 1;
    return plot_of(
        curves,
        {.label = "points in the regions of a tile", .high = step * std::ceil(most_points / step), .step = step});
}

Plot tile_radius_plot(const std::vector<TileSizeCurve>& curves)
{
    const double top = std::ceil(10 * highest_sample(curves, 0.2) - 1e-9) / 10;
    return plot_of(curves, {.label = "relative radius", .high = top, .step = 0.2});
}

}
