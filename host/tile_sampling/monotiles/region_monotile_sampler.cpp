#include "host/tile_sampling/monotiles/region_monotile_sampler.hpp"

#include "analysis/regions/framed_region.hpp"
#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/programs/cache_folder.hpp"
#include "base/programs/interrupt.hpp"
#include "base/random/random.hpp"
#include "base/regions/region_source.hpp"
#include "base/regions/region_units.hpp"
#include "host/settings/sampler_table.hpp"
#include "host/tile_points/monotile_region.hpp"
#include "host/tile_points/tiled_region.hpp"
#include "host/tile_sampling/monotiles/monotile_file_sampler.hpp"
#include "host/tile_sampling/monotiles/monotile_sampler.hpp"
#include "tiles/monotiles/monotile_file.hpp"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

namespace poissonlab {
namespace {

constexpr const char* region_distance_key = "min_distance";

/// The attempt of the stream that places tilings under regions; windows of files use 3.
constexpr std::uint32_t region_place = 4;

/// The region in its own units, which lives as long as the request.
std::shared_ptr<const FixedRegion> region_of(const SampleRequest& request)
{
    return {request.region, &request.region->fixed()};
}

/// Reads the file of the parameters and proves it, or makes the bytes of one from a table that is built.
MonotilePointsFile points_for_regions(const std::string& tiling, const Parameters& given, const SampleRequest& request)
{
    if (has_monotile_file(given)) return proven_monotile_file(given, request).file;
    const auto levels = static_cast<std::uint32_t>(given.integer("levels"));
    const auto points = static_cast<std::uint32_t>(given.integer("points_per_tile"));
    const MonotileTable table = cached_monotile_table(tiling, points, levels, cache_folder(), request.on_step).built;
    return {ranked_monotile_file(table, levels), tiling + "-tiles"};
}

class RegionMonotileSampler final : public Sampler
{
public:
    RegionMonotileSampler(const std::string& tiling, const Parameters& given, SampleRequest request)
        : request_(std::move(request)), region_(region_of(request_)), begin_(std::chrono::steady_clock::now()),
          file_(points_for_regions(tiling, given, request_)), density_(given.number("density"))
    {
        if (given.is_given(region_distance_key)) min_distance_ = given.number(region_distance_key);
        preparation_seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    }

    PointSet sample(std::uint32_t realization) override
    {
        const auto words =
            philox({0, 0, 0, 0}, stream_key(request_.seed, Purpose::isohedral_points, realization, region_place));
        const std::array<std::int64_t, 2> shift{static_cast<std::int32_t>(words[0]),
                                                static_cast<std::int32_t>(words[1])};
        const auto points_at = [&](double edge) {
            stop_if_interrupted();
            return MonotileRegion(file_, region_, edge, shift).all_points(words[2], density_);
        };
        try {
            const double edge = min_distance_ ? edge_for(*min_distance_, file_, region_->box())
                                              : tile_width_for_points(request_.points, guessed_edge(),
                                                                      [&](double at) { return points_at(at).size(); });
            PointSet set{2, {}};
            for (const pmono_point& point : points_at(edge))
                set.coordinates.insert(set.coordinates.end(), point.position, point.position + 2);
            proven_ = min_distance_with(edge, file_, region_->box());
            points_ = set.size();
            return as_in_files(request_.region->own_polygons(), std::move(set));
        } catch (const InputError& error) { // the region has no place for so many edges
            throw InputError(
                fmt::format("{}: tiles of realization {}: {}", request_.region->name(), realization, error.what()));
        }
    }

    SetTraits traits() const override
    {
        SetTraits traits{.sizes_vary = true};
        traits.preparation_seconds = preparation_seconds_;
        if (points_ > 0)
            traits.proven_relative_radius =
                relative_radius(proven_ / std::sqrt(request_.region->own_area()), points_, 2);
        return traits;
    }

private:
    /// The length of an edge with which so many points are in the region on average.
    double guessed_edge() const
    {
        const double points = static_cast<double>(request_.points);
        return std::sqrt(request_.region->own_area() * file_.density() * density_ / points);
    }

    SampleRequest request_;
    std::shared_ptr<const FixedRegion> region_;
    std::chrono::steady_clock::time_point begin_;
    MonotilePointsFile file_;
    double density_;
    std::optional<double> min_distance_;
    double preparation_seconds_ = 0;
    double proven_ = 0; ///< minimum distance of the last set, in the region's units
    std::size_t points_ = 0;
};

/// Throws InputError for a distance at which the region would have more points than sets may have.
void check_region_distance(const Parameters& given, const SampleRequest& request)
{
    if (!given.is_given(region_distance_key)) return;
    // The densest packing has a point in each such square; hats and spectres have about half as many.
    const double side = given.number(region_distance_key) / max_min_distance(1, 2);
    if (request.region->own_area() / (side * side) > 2.0 * max_points)
        throw given.error(region_distance_key,
                          fmt::format("must be larger: the region would have more than {} points", max_points));
}

}

SamplerSpec region_monotile_sampler(const std::string& tiling, SamplerSpec in_windows)
{
    SamplerSpec spec = std::move(in_windows);
    std::erase_if(spec.parameters, [](const ParameterSpec& parameter) { return parameter.key == "kept_points"; });
    spec.parameters.push_back({.key = region_distance_key,
                               .help = "the minimum distance, from which the length of edges follows",
                               .unit = region_units,
                               .maximum = 1e12,
                               .exclusive_minimum = true,
                               .symbol = "d",
                               .unless_given = "by default what gives analysis.points points"});
    spec.summary = fmt::format("what the region has of a tiling by {}s, an aperiodic monotile, at a random place, with "
                               "points in each tile and a proven minimum distance",
                               tiling);
    spec.most_points = {};
    spec.check = [tiling](const Parameters& given, const SampleRequest& request, const SourceLocation&) {
        check_monotile_file(tiling, given, request);
        check_region_distance(given, request);
    };
    spec.create = [tiling](const Parameters& given, const SampleRequest& request, Engine,
                           const DeviceProvider&) -> std::unique_ptr<Sampler> {
        return std::make_unique<RegionMonotileSampler>(tiling, given, request);
    };
    return spec;
}

}
