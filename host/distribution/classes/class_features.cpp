#include "host/distribution/classes/class_features.hpp"

#include "base/errors/errors.hpp"
#include "base/files/json_file.hpp"
#include "base/regions/obstacles.hpp"
#include "base/regions/polygon_sets.hpp"
#include "base/regions/region_features.hpp"
#include "base/regions/region_source.hpp"
#include "host/distribution/classes/class_points.hpp"
#include "host/settings/keys/keys.hpp"
#include "host/settings/sampler_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace poissonlab {
namespace {

/// Features that have more than this part of the area in common are refused; what rounding leaves is not.
constexpr double most_overlap = 1e-6;

/// Returns a property's value. `feature` is what messages call its feature.
double property_of(const nlohmann::json& properties, const std::string& name, bool is_count, const std::string& feature)
{
    const std::string needed = is_count ? fmt::format("must be a whole number from 0 to {}", max_points)
                                        : "must be a number from 0, points in a unit of area";
    const auto found = properties.find(name);
    if (found == properties.end())
        throw InputError(fmt::format("{}: has no property {}: {}", feature, shortened(printable(name)), needed));
    const double value = found->is_number() ? found->get<double>() : NAN;
    const bool is_allowed = std::isfinite(value) && value >= 0 &&
                            (!is_count || (value == std::floor(value) && value <= static_cast<double>(max_points)));
    if (!is_allowed)
        throw InputError(fmt::format("{}: property {} = {}: {}", feature, shortened(printable(name)),
                                     shortened(printable(found->dump())), needed));
    return value;
}

void check_overlap(const std::vector<PlaneRegion>& regions, const PlaneRegion& whole, const std::string& file)
{
    double sum = 0;
    for (const PlaneRegion& region : regions) sum += area_of(region);
    const double area = area_of(whole);
    if (sum - area > most_overlap * area)
        throw InputError(fmt::format("{}: its features overlap by an area of {:.6g}: numbers of points need features "
                                     "that do not",
                                     file, sum - area));
}

/// Returns the polygons of a feature, which become one where they overlap or share edges.
PlaneRegion region_of(const RegionFeature& feature)
{
    try {
        check_region({feature.polygons}, "");
    } catch (const InputError&) {
        if (!feature.polygons.empty()) return {united(feature.polygons)};
    }
    return {feature.polygons};
}

}

void check_counts(const ClassSettings& settings, const std::vector<std::size_t>& asked,
                  const std::vector<std::size_t>& counts, const std::string& where, int dimension)
{
    for (std::size_t i = 0; i < asked.size(); ++i) {
        if (counts[i] == asked[i]) continue;
        double share = 1;
        for (std::size_t j = 0; j < counts.size(); ++j)
            if (asked[j] > 0) share = std::min(share, static_cast<double>(counts[j]) / static_cast<double>(asked[j]));
        // A class without any point says nothing of the distances that it would have room for: all points together do.
        if (share == 0)
            share =
                std::accumulate(counts.begin(), counts.end(), 0.0) / std::accumulate(asked.begin(), asked.end(), 0.0);
        const double scale = std::pow(share, 1.0 / dimension);
        throw InputError(
            fmt::format("{}class {} is full with {} of {} points: no further one fits; {} can be reached", where, i,
                        counts[i], asked[i],
                        settings.distances.empty() && settings.matrix.empty()
                            ? fmt::format("a relative radius of about {:.3f}", 0.99 * scale * settings.relative_radius)
                            : fmt::format("distances of about {:.3f} times as much", 0.99 * scale)));
    }
}

void check_numbers(const ClassSettings& settings, const ClassSet& set)
{
    if (set.work.features->empty())
        return check_counts(settings, settings.points, set.points.counts(), "", set.dimension());
    std::size_t at = 0;
    for (std::size_t part = 0; part < set.work.features->size(); ++part) {
        const FeaturePart& feature = (*set.work.features)[part];
        std::vector<std::size_t> counts(feature.points.size());
        for (; at < set.points.part_ends[part]; ++at) ++counts[set.points.classes[at]];
        check_counts(settings, feature.points, counts,
                     fmt::format("{}: features[{}]: ", name_of_input(settings.place.region), feature.number), 2);
    }
}

std::vector<FeaturePart> feature_parts(const FeatureNumbers& asked, const PlaneRegion& whole,
                                       const std::vector<RegionPolygon>& obstacles, const std::string& file)
{
    if (!whole.source || whole.source->features.empty())
        throw InputError(fmt::format("{}: has no features: a FeatureCollection of GeoJSON has some", file));
    const std::vector<RegionFeature>& features = whole.source->features;
    std::vector<PlaneRegion> regions;
    for (const RegionFeature& feature : features) regions.push_back(region_of(feature));
    check_overlap(regions, whole, file);
    std::vector<FeaturePart> parts;
    for (std::size_t f = 0; f < features.size(); ++f) {
        const std::string name = fmt::format("{}: features[{}]", file, f);
        const auto properties = parsed_json(features[f].properties, name);
        FeaturePart part{f, std::move(regions[f]), {}};
        if (!obstacles.empty() && !part.region.polygons.empty()) part.region = without_polygons(part.region, obstacles);
        double sum = 0;
        for (const std::string& key : asked.names()) {
            const double value = property_of(properties, key, !asked.points.empty(), name);
            const double points = asked.points.empty() ? std::round(value * area_of(part.region)) : value;
            sum += points;
            if (sum > static_cast<double>(max_points))
                throw InputError(fmt::format("{}: has {:.6g} points: at most {} are possible", name, sum, max_points));
            if (value > 0 && part.region.polygons.empty())
                throw InputError(fmt::format(
                    "{}: has {} = {:g} and {}: must have a polygon or the number 0", name, shortened(printable(key)),
                    value, features[f].polygons.empty() ? "no polygon" : "no area without obstacles"));
            part.points.push_back(static_cast<std::size_t>(points));
        }
        if (sum > 0) parts.push_back(std::move(part));
    }
    for (std::size_t i = 0; i < asked.names().size(); ++i)
        if (std::ranges::all_of(parts, [&](const FeaturePart& part) { return part.points[i] == 0; }))
            throw InputError(fmt::format("{}: no feature has points of class {}: {} is 0 everywhere{}", file, i,
                                         shortened(printable(asked.names()[i])),
                                         asked.points.empty() ? ", or times the area less than half a point" : ""));
    return parts;
}

ClassedPoints ClassSet::in_units() const
{
    if (!work.request.region) return points;
    ClassedPoints own = points;
    own.points = in_units_of(*work.request.region, points.points);
    return own;
}

std::vector<std::string> ClassSet::features() const
{
    if (is_on_lines()) return features_on_lines;
    if (!work.land || !work.land->whole.source) return {};
    const std::vector<RegionFeature>& features = work.land->whole.source->features;
    std::vector<std::string> ids;
    for (std::size_t part = 0; part < work.features->size(); ++part)
        ids.resize(points.part_ends[part], features[(*work.features)[part].number].id);
    if (ids.empty() && features.size() > 1) ids = ids_of_features(features, in_units().points);
    return ids;
}

ClassedPoints ClassSet::as_in_files() const
{
    ClassedPoints own = in_units();
    if (work.land) own.points = poissonlab::as_in_files(work.land->whole, std::move(own.points));
    return own;
}

}
