#include "reports/plots/region_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace poissonlab {

namespace {

constexpr auto size_key = "points_per_tile";

/// The settings that tile sets that differ only in their number of points have in common.
NamedTexts method_of(const Series& series)
{
    NamedTexts method = {{"sampler", series.sampler}};
    for (const auto& parameter : series.parameters)
        if (parameter.first != size_key) method.push_back(parameter);
    return method;
}

/// "corners, relative_radius = 0.7": of the parameters, those that not all methods have.
std::string label_of(const std::string& region, const NamedTexts& method, const std::set<NamedTexts>& methods)
{
    std::string label = region;
    for (const auto& parameter : method) {
        const auto has_it = [&](const NamedTexts& other) { return std::ranges::count(other, parameter) > 0; };
        if (std::ranges::all_of(methods, has_it)) continue;
        label += parameter.first == "sampler" ? ", " + parameter.second
                                              : fmt::format(", {} = {}", parameter.first, parameter.second);
    }
    return label;
}

}

std::vector<RegionCurve> region_curves(const std::vector<const Series*>& series)
{
    std::set<NamedTexts> methods;
    for (const Series* entry : series)
        if (entry->tile_set && !entry->tile_set->regions.empty()) methods.insert(method_of(*entry));

    std::vector<RegionCurve> curves;
    std::map<std::string, std::size_t> places; // by label
    for (const Series* entry : series) {
        if (!entry->tile_set) continue;
        for (const RegionPoints& region : entry->tile_set->regions) {
            if (region.name == "interior") continue;
            const std::string label = label_of(region.name, method_of(*entry), methods);
            const std::size_t place = places.try_emplace(label, curves.size()).first->second;
            if (place == curves.size()) curves.push_back({0, label, {}});
            curves[place].samples.push_back(
                {static_cast<double>(entry->tile_set->points_per_tile), region.points, region.expected});
        }
    }

    for (RegionCurve& curve : curves) std::ranges::sort(curve.samples, {}, &RegionSample::points_per_tile);
    std::erase_if(curves, [](const RegionCurve& curve) {
        return curve.samples.front().points_per_tile == curve.samples.back().points_per_tile;
    });
    for (std::size_t i = 0; i < curves.size(); ++i) curves[i].index = i;
    return curves;
}

Plot region_points_plot(const std::vector<RegionCurve>& curves)
{
    Plot plot;
    double most_points = 1;
    for (const RegionCurve& source : curves) {
        PlotCurve curve{source.index, source.label};
        for (const RegionSample& sample : source.samples) {
            most_points = std::max({most_points, sample.points, sample.expected});
            curve.x.push_back(sample.points_per_tile);
            curve.y.push_back(sample.expected);
            curve.dots.push_back(sample.points);
            curve.end = std::max(curve.end, sample.points_per_tile);
        }
        plot.curves.push_back(std::move(curve));
    }
    const double step = most_points > 10 ? 4 : most_points > 4 ? 2 : 1;
    plot.x = {.label = "points per tile N"};
    plot.y = {.label = "points in the regions of a tile", .high = step * std::ceil(most_points / step), .step = step};
    plot.right_margin = 4;
    return together(std::move(plot));
}

}
