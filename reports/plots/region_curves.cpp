#include "reports/plots/region_curves.hpp"

#include "reports/plots/plot_style.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

namespace poissonlab {

namespace {

constexpr auto size_key = "points_per_tile";

/// What tile sets that differ only in their number of points have in common.
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

std::string data_block(const RegionCurve& curve)
{
    std::string block = fmt::format("$regions{} << END\n", curve.index);
    for (const auto& sample : curve.samples)
        fmt::format_to(std::back_inserter(block), "{} {:.6g} {:.6g}\n", sample.points_per_tile, sample.points,
                       sample.expected);
    return block + "END\n";
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

GnuplotPicture plot_region_points(const std::vector<RegionCurve>& curves, const std::filesystem::path& stem)
{
    double most_points = 1;
    double largest_tile = 1;
    std::string data;
    std::string plot;
    std::vector<KeyEntry> key;
    for (const RegionCurve& curve : curves) {
        for (const RegionSample& sample : curve.samples) {
            most_points = std::max({most_points, sample.points, sample.expected});
            largest_tile = std::max(largest_tile, sample.points_per_tile);
        }
        data += data_block(curve);
        plot +=
            fmt::format("{0}$regions{1} using 1:3 with lines {2} notitle, $regions{1} using 1:2 with points pt 7 "
                        "ps 0.4 lc rgb '{3}' notitle",
                        plot.empty() ? "plot " : ", ", curve.index, line_style(curve.index), curve_color(curve.index));
        key.push_back({curve.index, curve.label});
    }
    const double step = most_points > 10 ? 4 : most_points > 4 ? 2 : 1;
    const double top = step * std::ceil(most_points / step);
    return with_key(axes("points per tile N", 0, largest_tile, {"points in the regions of a tile", 0, top, step, 0}) +
                        "set rmargin 4\n" + data,
                    plot, key, stem);
}

}
