#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "host/sampling/classics/plain_spec.hpp"
#include "host/sampling/device_sampler.hpp"
#include "host/sampling/sectors/sector_darts.hpp"
#include "host/sampling/sets_ahead.hpp"

#include <fmt/format.h>

#include <optional>
#include <vector>

namespace poissonlab {
namespace {

constexpr WordTable<SectorVariant, 3> sector_variants{{{{SectorVariant::logarithmic, "logarithmic"},
                                                        {SectorVariant::linear, "linear"},
                                                        {SectorVariant::boundary, "boundary"}}}};

/// The relative radius that full sets have, about.
double usual_radius(SectorVariant variant)
{
    return variant == SectorVariant::boundary ? 0.862 : variant == SectorVariant::linear ? 0.804 : 0.775;
}

SectorDartRequest sector_request(const Parameters& parameters, const SampleRequest& request)
{
    const SectorVariant variant = *sector_variants.find(parameters.text("variant"));
    if (parameters.is_given("min_distance")) return {parameters.number("min_distance"), variant};
    return {min_distance_for(usual_radius(variant), request.points, 2), variant};
}

/// On a device, realizations that are asked for one after the other are made side by side.
class SectorDartSampler final : public DeviceSampler
{
public:
    SectorDartSampler(std::uint64_t seed, const SectorDartRequest& request, Engine engine, const DeviceProvider& device)
        : DeviceSampler(engine, device), seed_(seed), request_(request)
    {
        if (device_) darts_.emplace(*device_);
    }

    void expect(std::uint32_t first, std::uint32_t count) override { sets_.expect(first, count); }

    PointSet sample(std::uint32_t realization) override
    {
        if (!darts_) return reference::throw_sector_darts(request_, stream_of(realization));
        return sets_.take(realization, *device_, [&] {
            std::vector<StreamKey> streams;
            const std::uint32_t count = sets_.expected_from(realization, SectorDarts::sets_at_once(request_));
            for (std::uint32_t i = 0; i < count; ++i) streams.push_back(stream_of(realization + i));
            return darts_->throw_darts(request_, streams);
        });
    }

    SetTraits traits() const override { return {.sizes_vary = true, .shared_seconds = sets_.seconds()}; }

private:
    StreamKey stream_of(std::uint32_t realization) const
    {
        return stream_key(seed_, Purpose::sector_darts, realization);
    }

    std::uint64_t seed_;
    SectorDartRequest request_;
    std::optional<SectorDarts> darts_; ///< nothing: the reference does the work
    SetsAhead<PointSet> sets_;
};

}

SamplerSpec sector_dart_sampler()
{
    SamplerSpec spec =
        plain_spec("sector-darts", "Sector darts",
                   "darts beside the points that are there, until none fits (Dunbar and Humphreys 2006); "
                   "serial within a set, sets side by side",
                   {2},
                   {{.key = "variant",
                     .kind = ParameterSpec::Kind::choice,
                     .help = "where the next dart falls: anywhere around points, by area; around one point after the "
                             "other; or at the least distance of one",
                     .choices = sector_variants.all(),
                     .otherwise = std::string(sector_variants[SectorVariant::boundary])},
                    {.key = "min_distance",
                     .help = "the minimum distance, in units of the torus' side",
                     .maximum = 0.125,
                     .exclusive_minimum = true,
                     .symbol = "d",
                     .unless_given = "what gives about analysis.points points"}});
    spec.check = [](const Parameters& parameters, const SampleRequest& request, const SourceLocation& where) {
        const double distance = sector_request(parameters, request).min_distance;
        if (distance > 0.125)
            throw InputError::at(where,
                                 fmt::format("sampler = \"sector-darts\": {} points have a distance of {:.3f}: must "
                                             "be at most 0.125, so that neighbourhoods do not meet themselves; more "
                                             "points",
                                             request.points, distance));
        constexpr double most = 1 << 26;
        if (1 / (distance * distance) > most)
            throw parameters.error("min_distance", fmt::format("must leave at most {:.0f} points", most));
    };
    spec.most_points = [](const Parameters& parameters, const SampleRequest& request) {
        return most_sector_darts(sector_request(parameters, request).min_distance);
    };
    spec.memory_growth = MemoryGrowth::limited;
    spec.device_memory = [](const Parameters& parameters, const SampleRequest& request, const DeviceInfo&) {
        return SectorDarts::memory(sector_request(parameters, request));
    };
    spec.kernels = {"sector_darts.cl"};
    spec.create = [](const Parameters& parameters, const SampleRequest& request, Engine engine,
                     const DeviceProvider& device) {
        return std::make_unique<SectorDartSampler>(request.seed, sector_request(parameters, request), engine, device);
    };
    return spec;
}

}
