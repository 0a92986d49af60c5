#include "host/distribution/classes/class_pictures.hpp"

#include "base/files/whole_file.hpp"
#include "base/regions/region_source.hpp"
#include "host/distribution/region_runs/dart_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// The longest side of the picture: its numbers have two decimals.
constexpr double class_picture_side = 4096;

/// The part of a class' distance that the radius of its disks is.
constexpr double shown_radius = 0.16;

/// Pairs whose curves a picture has room for.
constexpr std::size_t most_curves = 18;

std::string class_name(std::uint32_t number, const std::vector<std::string>& names)
{
    return names.empty() ? fmt::format("class {}", number) : names[number];
}

std::vector<std::string> pair_names(const std::vector<std::uint32_t>& used, const std::vector<std::string>& names)
{
    std::vector<std::string> pairs;
    for (std::size_t i = 0; i < used.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            pairs.push_back(names.empty() ? fmt::format("{}, {}", used[j], used[i])
                                          : fmt::format("{} and {}", names[used[j]], names[used[i]]));
    return pairs;
}

/// Makes a curve that leaves out places where no value is known.
ChartCurve curve_of(const std::string& name, const std::string& color, const std::vector<double>& values, double unit)
{
    ChartCurve curve{name, color, {}};
    for (std::size_t k = 0; k < values.size(); ++k)
        if (!std::isnan(values[k])) curve.places.push_back({static_cast<double>(k + 1) / unit, values[k]});
    return curve;
}

/// Frequencies over the root of the number of all points.
ChartAxis frequency_axis(const CrossSpectra& spectra, double unit)
{
    return {"frequency / sqrt(number of all points)", 0, static_cast<double>(spectra.bins()) / unit, 0.5};
}

double root_of_number(std::size_t points) { return std::sqrt(static_cast<double>(points)); }

MarkPicture picture_of_torus(const ClassedPoints& points, const ClassDistances& distances)
{
    MarkPicture picture{class_picture_side, class_picture_side};
    for (std::uint32_t i = 0; i < distances.classes(); ++i) {
        MarkGroup disks{class_color(i)};
        const double radius = std::clamp(shown_radius * distances.at(i, i), 5e-4, 0.03) * class_picture_side;
        for (std::size_t p = 0; p < points.classes.size(); ++p) {
            const auto at = points.points[p];
            if (points.classes[p] != i || (at.size() == 3 && at[2] > 0.1)) continue;
            disks.disks.push_back({at[0] * class_picture_side, at[1] * class_picture_side, radius});
        }
        picture.groups.push_back(std::move(disks));
    }
    // Large disks lie below small ones.
    std::ranges::stable_sort(picture.groups, std::greater{},
                             [](const MarkGroup& g) { return g.disks.empty() ? 0 : g.disks.front()[2]; });
    return picture;
}

/// Draws points of classes in their region. Large disks lie below small ones.
MarkPicture picture_in_region(const ClassSet& set)
{
    const ClassedPoints points = set.in_units();
    const ClassDistances kept = set.kept();
    std::vector<LandDots> dots;
    for (std::uint32_t i = 0; i < kept.classes(); ++i)
        dots.push_back({class_color(i), points.of_class(i), shown_radius * kept.at(i, i)});
    std::ranges::stable_sort(dots, std::greater{}, &LandDots::radius);
    return land_picture(*set.work.land,
                        set.is_on_lines() ? box_around(lines_of(set.work.land->whole)) : set.work.request.region->box(),
                        dots);
}

/// Draws the mean radial power of each class and of all points.
CurveChart power_chart(std::size_t points, const ClassSpectra& spectra, const std::vector<std::string>& names)
{
    const std::vector<std::uint32_t>& used = spectra.classes;
    const double unit = root_of_number(points);
    std::vector<ChartCurve> curves{curve_of("all", "#000000", spectra.mean.power.back(), unit)};
    for (std::size_t i = 0; i < std::min(used.size(), most_curves); ++i)
        curves.push_back(curve_of(class_name(used[i], names), class_color(used[i]), spectra.mean.power[i], unit));
    return {frequency_axis(spectra.mean, unit), {"radially averaged power", 0, 3, 0.5}, 1, curves};
}

CurveChart cross_chart(std::size_t points, const ClassSpectra& spectra, const std::vector<std::string>& class_names)
{
    const std::vector<std::string> names = pair_names(spectra.classes, class_names);
    const double unit = root_of_number(points);
    std::vector<ChartCurve> curves;
    for (std::size_t i = 0; i < std::min(names.size(), most_curves); ++i)
        curves.push_back(curve_of(names[i], class_color(i), spectra.mean.cross[i], unit));
    return {frequency_axis(spectra.mean, unit), {"radially averaged cross power", -1.5, 1.5, 0.5}, 0, curves};
}

}

MarkPicture class_picture(const ClassSet& set)
{
    return set.work.land ? picture_in_region(set) : picture_of_torus(set.points, set.kept());
}

std::vector<std::uint32_t> used_classes(const ClassedPoints& points)
{
    const std::vector<std::size_t> counts = points.counts();
    std::vector<std::uint32_t> used;
    for (std::uint32_t i = 0; i < counts.size(); ++i)
        if (counts[i] > 0) used.push_back(i);
    return used;
}

CrossSpectra class_spectra(const ClassedPoints& points, std::size_t bins)
{
    std::vector<PointSet> sets;
    for (const std::uint32_t i : used_classes(points)) sets.push_back(points.of_class(i));
    const double reach = std::clamp(2.5 * root_of_number(points.points.size()), 8.0, 1024.0);
    return cross_spectra(sets, bins > 0 ? static_cast<int>(bins) : static_cast<int>(reach));
}

void add_class_spectra(std::size_t points, const ClassSpectra& spectra, const std::vector<std::string>& names,
                       DistributionFiles& files, DistributionResult& result)
{
    const std::string of = spectra.sets == 1 ? "of this set alone" : fmt::format("the mean of {} sets", spectra.sets);
    files.add_curves("power", power_chart(points, spectra, names),
                     fmt::format("Radially averaged power of each class and of all points, {}.", of), result);
    if (!spectra.mean.cross.empty())
        files.add_curves("cross-power", cross_chart(points, spectra, names),
                         fmt::format("Cross power of pairs of classes, {}: 0 where they are independent of each other, "
                                     "below 0 where one has its points between those of the other.",
                                     of),
                         result);
    write_whole_file(files.add("spectra.csv", result), spectra_csv(spectra));
}

}
