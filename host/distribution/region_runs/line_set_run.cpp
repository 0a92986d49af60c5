// kind = "line-set" measures points on lines, wherever they come from.
#include "base/points/point_file.hpp"
#include "base/regions/region_source.hpp"
#include "base/regions/region_text.hpp"
#include "base/regions/region_units.hpp"
#include "base/text/noun.hpp"
#include "host/distribution/regions/line_set.hpp"
#include "host/kinds/kinds.hpp"
#include "host/settings/keys/region_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace poissonlab {
namespace {

/// Points that darts leave for each distance of a long straight line (Rényi 1958).
constexpr double renyi_jamming = 0.7475979202;

/// Points of a file, in the region's plane.
PointSet line_set_points(const LineSetSettings& s, const PlaneRegion& region)
{
    PointReading how;
    how.domain = any_coordinates;
    std::vector<PointSet> sets = read_points(s.set, how);
    const std::string name = s.set.string();
    if (sets.size() != 1)
        throw InputError(
            fmt::format("{}: has {} sets; points on lines are measured one set at a time", name, sets.size()));
    if (sets.front().dimension != 2) throw InputError(name + ": points in space are not on lines of the plane");
    if (sets.front().size() < 2) throw InputError(name + ": has one point; distances need at least two");
    return as_in_plane(region, std::move(sets.front()));
}

LineSet line_set_of(const LineSetSettings& s)
{
    const PlaneRegion region = read_region(s.region, s.reading);
    try {
        return measure_line_set(region, line_set_points(s, region));
    } catch (const InputError& error) {
        const std::string name = s.set.string(), message = error.what();
        throw InputError(message.starts_with(name) ? message : name + ": " + message);
    }
}

void line_set_keys(Keys& keys, LineSetSettings& s)
{
    keys.file("set", s.set, "the points: a file of points, in the region's coordinates").required();
    keys.region(s.region);
    region_coordinates_keys(keys, s.reading);
    s.reading.is_along = true;
    if (!keys.is_read()) return;
    keys.check("region", [&] { read_region(s.region, s.reading); });
    keys.check("set", [&] { line_set_of(s); });
}

std::string line_set_label(const LineSetSettings& s)
{
    return fmt::format("{} along {}", s.set.stem().string(), name_of_input(s.region));
}

/// The part of gaps that are at least so long, beside the exponential law of random points.
CurveChart gap_curves(const std::vector<double>& gaps, double mean)
{
    ChartCurve found{"points", "#2c728e", {}}, random{"random points", "#8a8f98", {}};
    const double most = std::ceil(std::min(gaps.back() / mean, 6.0));
    const std::size_t step = std::max<std::size_t>(1, gaps.size() / 2000);
    for (std::size_t i = 0; i < gaps.size(); i += step)
        found.places.push_back({gaps[i] / mean, 1 - static_cast<double>(i) / static_cast<double>(gaps.size())});
    for (double x = 0; x <= most; x += most / 200) random.places.push_back({x, std::exp(-x)});
    return {{"gap / mean gap", 0, most, 1}, {"part of gaps at least as long", 0, 1, 0.2}, 0, {random, found}};
}

DistributionNumbers line_set_numbers(std::size_t points, const LineSet& set, const std::string& units)
{
    const double each = set.length / static_cast<double>(points);
    DistributionNumbers numbers{
        {"points", "Points", static_cast<double>(points), "on the lines"},
        {"length", "Length", set.length, "of the lines, in " + units},
        {"least_distance", "Least distance", set.least, "of two points through the plane, in " + units},
        {"mean_nearest", "Mean nearest distance", set.mean_nearest,
         "of points from their nearest ones through the plane, in " + units},
        {"nearest_ratio", "Mean nearest distance over random", 2 * set.mean_nearest / each,
         "random points on one straight line have 1, points at equal steps 2; where lines cross or bend, less"},
        {"relative_radius", "Relative radius", set.least / each,
         "least distance over the length of the lines for each point"},
        {"jamming_share", "Share of jamming", set.least / each / renyi_jamming,
         "relative radius over 0.7476, that of darts on a long straight line on which no further one fits: above 1, "
         "points are more even than such darts; at equal steps it is 1.338"}};
    if (set.gaps.empty()) return numbers;
    const auto count = static_cast<double>(set.gaps.size());
    const double mean = std::accumulate(set.gaps.begin(), set.gaps.end(), 0.0) / count;
    double squares = 0;
    for (const double gap : set.gaps) squares += (gap - mean) * (gap - mean);
    numbers.insert(numbers.end(),
                   {{"gaps", "Gaps", count, "between neighbours on one line, also around closed ones"},
                    {"mean_gap", "Mean gap", mean, "along the line, in " + units},
                    {"least_gap", "Least gap", set.gaps.front(), "along the line"},
                    {"largest_gap", "Largest gap", set.gaps.back(), "along the line"},
                    {"gap_variation", "Variation of gaps", mean > 0 ? std::sqrt(squares / count) / mean : 0,
                     "standard deviation over the mean: random points have 1, points at equal steps 0"}});
    return numbers;
}

DistributionResult measure_lines(const LineSetSettings& settings, std::uint64_t /*seed*/,
                                 const DistributionPlace& /*place*/, DistributionFiles& files)
{
    const PlaneRegion region = read_region(settings.region, settings.reading);
    const PointSet points = line_set_points(settings, region);
    const LineSet set = measure_line_set(region, points);
    DistributionResult result;
    result.facts = {fmt::format("{} points", points.size()),
                    fmt::format("{} {}, {:.6g} long", set.lines, noun(set.lines, "line"), set.length)};
    for (const std::string& note : notes_of(region)) result.facts.push_back(note);
    result.numbers = line_set_numbers(points.size(), set, length_units(region));
    if (set.gaps.empty()) return result;
    const double mean = std::accumulate(set.gaps.begin(), set.gaps.end(), 0.0) / static_cast<double>(set.gaps.size());
    if (mean > 0)
        files.add_curves("gaps", gap_curves(set.gaps, mean),
                         "Gaps between neighbours on a line: the part of gaps that are at least as long, and the same "
                         "for random points.",
                         result);
    return result;
}

}

Kind line_set_kind()
{
    return make_kind<LineSetSettings>(
        {"distribution", "line-set", "", "Points on lines", "Measure points on lines, made here or elsewhere", false},
        line_set_keys, line_set_label, measure_lines);
}

}
