#include "host/distribution/region_runs/region_results.hpp"

#include "analysis/regions/region_curves.hpp"
#include "base/files/npy_header.hpp"
#include "base/files/whole_file.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/regions/region_units.hpp"
#include "host/distribution/regions/varied_points.hpp"
#include "results/curve_tables.hpp"
#include "results/file_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

namespace poissonlab {

std::string words_of_varied(const VariedSet& set)
{
    const auto [least, most] = std::ranges::minmax(set.distances);
    std::string words = fmt::format("they keep {} of their distances, {:.6g} to {:.6g}",
                                    set.request.darts.is_mean ? "the mean" : "the smaller", least, most);
    if (set.scale != 1) words += fmt::format(", {:.9g} times what was asked for", set.scale);
    if (set.distances.size() > 1) words += fmt::format("; of all pairs, the nearest have {:.9g} times that", set.least);
    return words;
}

void append_varied_numbers(const VariedSet& set, DistributionNumbers& numbers)
{
    const auto [least, most] = std::ranges::minmax(set.distances);
    const VariedRequest& request = set.request;
    const std::string units = request.place.land ? length_units(request.place.land->whole) : "units of the region";
    numbers.push_back({"scale", "Scale", set.scale, "by which the distances that were asked for are multiplied"});
    numbers.push_back({"smallest_distance", "Smallest distance", least, "asked for at a point, in " + units});
    numbers.push_back({"largest_distance", "Largest distance", most, "asked for at a point, in " + units});
    numbers.push_back({"slope", "Slope", request.table.slope * set.scale,
                       "the largest one: by how much distances grow along a unit of length"});
    numbers.push_back({"slope_limit", "Limit of the slope",
                       slope_limit(request.darts.is_mean ? KeptDistance::mean : KeptDistance::smaller),
                       "below which a point's distance says how far its neighbours are"});
    if (set.distances.size() < 2) return;
    if (set.is_proven)
        numbers.push_back({"too_near", "Pairs too near", 0,
                           "to each other, of all pairs, by whole numbers: the set was looked at after it was made"});
    numbers.push_back({"least_ratio", "Least ratio", set.least,
                       "of all pairs: their distance over the one that both keep, as it was read at nodes"});
    numbers.push_back({"least_ratio_typed", "Least ratio as typed", set.least_as_typed,
                       "the same with the formula or picture itself at each point"});
    numbers.push_back(
        {"mean_ratio", "Mean ratio",
         std::accumulate(set.nearest.begin(), set.nearest.end(), 0.0) / static_cast<double>(set.nearest.size()),
         "of points and their nearest ones: their distance over the one that both keep"});
    numbers.push_back(
        {"relative_radius", "Relative radius",
         set.least * set.scale / (max_min_distance(set.distances.size(), 2) * std::sqrt(request.table.packing)),
         "distances over those with which the densest packing has as many points, as 1 / distance^2 is "
         "added up in the region"});
}

void write_distances(const std::filesystem::path& file, const VariedSet& set)
{
    const std::string header =
        npy_header_of(fmt::format("'{}f8'", npy_byte_order()), fmt::format("({},)", set.distances.size()));
    write_whole_file(file, header + std::string(reinterpret_cast<const char*>(set.distances.data()),
                                                set.distances.size() * sizeof(double)));
}

namespace {

constexpr std::size_t most_points_measured = 300'000;
constexpr std::uint32_t random_sets = 39;

/// Measuring random sets with more points than this together would take far longer than making the set.
constexpr std::size_t most_random_points = 200'000;

}

void add_region_curves(const PlaneRegion& region, const PointSet& points, DistributionFiles& files,
                       DistributionResult& result)
{
    if (points.size() < 2 || points.size() > most_points_measured) return;
    // Points are in the region's plane already, where that is one of longitude and latitude as well.
    PlaneRegion plane = region;
    plane.source = nullptr;
    const auto framed = std::make_shared<const FramedRegion>(plane, "the region");
    const std::uint32_t envelope = random_sets * points.size() <= most_random_points ? random_sets : 0;
    RegionCurves curves(framed, nullptr, points.size(), envelope);
    if (curves.distances().count == 0) return;
    curves.add(framed->framed(points, "darts"), "darts");
    write_whole_file(files.add(file_names::region_curves), region_curves_csv(curves.rows()));
    result.files.emplace_back(file_names::region_curves);
    if (envelope > 0)
        result.numbers.push_back({"envelope", "Random sets", static_cast<double>(envelope),
                                  "of as many points, whose curves make the bands"});
    if (const double error = curves.covariance().table_error(); error > 0)
        result.numbers.push_back({"covariance_error", "Error of areas in common", error,
                                  "of the region and the moved region, from a table, over the region's area"});
}

}
