#include "host/distribution/region_runs/region_curve_files.hpp"

#include "analysis/regions/region_curves.hpp"
#include "base/files/whole_file.hpp"
#include "results/curve_tables.hpp"
#include "results/file_names.hpp"

#include <memory>

namespace poissonlab {
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
