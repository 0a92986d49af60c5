
#include "analysis/regions/framed_region.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/random/random.hpp"
#include "base/regions/region_source.hpp"
#include "base/regions/region_units.hpp"
#include "host/sampling/device_sampler.hpp"
#include "host/tile_construction/tile_construction.hpp"
#include "host/tile_points/point_levels.hpp"
#include "host/tile_points/tile_points.hpp"
#include "host/tile_points/tiled_region.hpp"
#include "host/tile_sampling/tile_samplers.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace poissonlab {
namespace {

constexpr const char* distance_key = "min_distance";

/// The width of tiles with which so many points are in the region on average.
double width_for_points(const TileSetChoice& choice, const SampleRequest& request)
{
    const double tiles = static_cast<double>(request.points) / (choice.density * choice.first.points_per_tile);
    return std::sqrt(request.region->own_area() / tiles);
}

/// The exact region of a request, which lives as long as that.
std::shared_ptr<const FixedRegion> fixed_region_of(const SampleRequest& request)
{
    return {request.region, &request.region->fixed()};
}

class RegionTileSampler final : public DeviceSampler
{
public:
    RegionTileSampler(const TileSetChoice& choice, std::optional<double> min_distance, const SampleRequest& request,
                      Engine engine, const DeviceProvider& device)
        : DeviceSampler(engine, device), request_(request), choice_(choice), min_distance_(min_distance),
          region_(fixed_region_of(request)), sets_(choice, request, engine, device)
    {
        for (const PoissonTileSet& set : sets_.all())
            streams_.push_back(device_ ? device_stream(*device_, set) : reference_stream(set));
    }

    PointSet sample(std::uint32_t realization) override
    {
        const std::size_t set = realization % sets_.all().size();
        const std::uint32_t seed = stream_key(request_.seed, Purpose::tile_choice, realization)[0];
        try {
            const double width = width_of(set, seed);
            proven_ = min_distance_in(width, sets_.all()[set], region_->box());
            PointSet points = points_at(set, seed, width);
            points_ = points.size();
            return as_in_files(request_.region->own_polygons(), std::move(points));
        } catch (const InputError& error) { // the region has no place for so many tiles
            throw InputError(
                fmt::format("{}: tiles of realization {}: {}", request_.region->name(), realization, error.what()));
        }
    }

    /// Widths are looked for until the number of points is right; where chance lets no width have it, it is near.
    SetTraits traits() const override
    {
        SetTraits traits = sets_.traits();
        traits.sizes_vary = true;
        if (points_ > 0)
            traits.proven_relative_radius =
                relative_radius(proven_ / std::sqrt(request_.region->own_area()), points_, 2);
        return traits;
    }

private:
    double width_of(std::size_t set, std::uint32_t seed)
    {
        if (min_distance_) return tile_width_for(*min_distance_, sets_.all()[set], region_->box());
        return tile_width_for_points(request_.points, width_for_points(choice_, request_),
                                     [&](double width) { return points_at(set, seed, width).size(); });
    }

    /// The points in the region with tiles of this width.
    PointSet points_at(std::size_t set, std::uint32_t seed, double width) const
    {
        const TiledRegion tiled(region_, width);
        const PoissonTileSet& tiles = sets_.all()[set];
        const std::size_t values_per_tile = tiles.parameters.points_per_tile * std::size_t{2};
        const PoissonTiling tiling{seed, 0};
        PointLevels levels(tiles, tiling, tiled.block());
        PointSet points{2, {}};
        streams_[set](tiling, tiled.block(), 0, tiled.block().tiles(), [&](std::span<const std::uint32_t> units) {
            std::span<const double> level;
            if (choice_.density < 1) level = levels.next(units.size() / values_per_tile);
            for (std::size_t i = 0; i < units.size() / 2; ++i)
                if (level.empty() || level[i] < choice_.density)
                    tiled.append_if_inside(units.subspan(2 * i, 2), points.coordinates);
        });
        return points;
    }

    SampleRequest request_;
    TileSetChoice choice_;
    std::optional<double> min_distance_;
    std::shared_ptr<const FixedRegion> region_;
    SeriesTileSets sets_;
    std::vector<UnitStream> streams_;
    double proven_ = 0; ///< minimum distance of the last set, in the region's units
    std::size_t points_ = 0;
};

std::optional<double> distance_of(const Parameters& given)
{
    if (!given.is_given(distance_key)) return std::nullopt;
    return given.number(distance_key);
}

/// The width of tiles, as near as it is known before they are built: at the relative radius that they have at least.
double expected_width(const TileSetChoice& choice, const Parameters& given, const SampleRequest& request)
{
    const auto distance = distance_of(given);
    if (!distance) return width_for_points(choice, request);
    return *distance / min_distance_for(choice.first.relative_radius, choice.first.points_per_tile, 2);
}

/// Throws InputError where so many tiles have no place in a tiling.
void check_width(const TileSetChoice& choice, const Parameters& given, const SampleRequest& request,
                 const SourceLocation& where)
{
    try {
        TiledRegion(fixed_region_of(request), expected_width(choice, given, request));
    } catch (const InputError& error) {
        if (given.is_given(distance_key)) throw given.error(distance_key, error.what());
        throw InputError::at(where, fmt::format("tiles of {} points: {}", choice.first.points_per_tile, error.what()));
    }
}

DeviceMemory region_tile_memory(const TileSetChoice& choice, const Parameters& given, const SampleRequest& request,
                                const DeviceInfo& device)
{
    // Sets are proven to be farther apart than they are asked to be, and widths are looked for below the expected one.
    constexpr double narrowest = 0.92;
    const double width = narrowest * expected_width(choice, given, request);
    const std::uint64_t tiles = TiledRegion(fixed_region_of(request), width).block().tiles();
    DeviceMemory taking;
    for (std::uint32_t i = 0; i < choice.sets; ++i)
        taking = taking + TilePointGenerator::memory(choice.first, tiles, device);
    return either(construction_memory(choice.first, device), taking);
}

}

SamplerSpec region_tile_sampler(const PoissonTileFamily& family, SamplerSpec on_torus)
{
    SamplerSpec spec = std::move(on_torus);
    spec.parameters.push_back({.key = distance_key,
                               .help = "the minimum distance, from which the width of tiles follows",
                               .unit = region_units,
                               .maximum = 1e12,
                               .exclusive_minimum = true,
                               .symbol = "d",
                               .unless_given = "by default what gives analysis.points points"});
    spec.most_points = {};
    spec.check = [family, checked = spec.check](const Parameters& given, const SampleRequest& request,
                                                const SourceLocation& where) {
        checked(given, request, where);
        check_width(tile_set_choice(family, given, request), given, request, where);
    };
    spec.device_memory = [family](const Parameters& given, const SampleRequest& request, const DeviceInfo& device) {
        return region_tile_memory(tile_set_choice(family, given, request), given, request, device);
    };
    spec.create = [family](const Parameters& given, const SampleRequest& request, Engine engine,
                           const DeviceProvider& device) -> std::unique_ptr<Sampler> {
        try {
            return std::make_unique<RegionTileSampler>(tile_set_choice(family, given, request), distance_of(given),
                                                       request, engine, device);
        } catch (const InputError& error) { // the radius could not be reached
            throw error.moved_to(place_of_tile_parameter(given, "relative_radius", family));
        }
    };
    return spec;
}

}
