#include "host/sampling/classics/open_darts.hpp"

#include "base/geometry/relative_radius.hpp"
#include "base/programs/interrupt.hpp"
#include "base/random/random.hpp"
#include "host/sampling/classics/torus_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

bool is_open(const Parameters& parameters) { return parameters.text("border") == "open"; }

/// The square is a part of a torus whose side is longer by the minimum distance, so that no point is near to one at the
/// opposite border.
class OpenDarts final : public Sampler
{
public:
    OpenDarts(const Parameters& parameters, const SampleRequest& request, Purpose purpose)
        : parameters_(parameters), request_(request), purpose_(purpose)
    {
        const double distance = min_distance_for(parameters.number("relative_radius"), request.points, 2);
        units_ = std::floor(0x1p32 / (1 + distance));
        distance_ = std::min(half_torus - 1, static_cast<std::uint64_t>(std::ceil(distance * units_)));
    }

    SetTraits traits() const override { return {.is_window = true}; }

    PointSet sample(std::uint32_t realization) override
    {
        constexpr std::uint64_t darts_a_point = 20'000; // a relative radius of 0.76 takes some 300
        const StreamKey stream = stream_key(request_.seed, purpose_, realization);
        TorusGrid grid(request_.points, 2);
        const std::uint64_t most = darts_a_point * (request_.points + 10);
        for (std::uint64_t dart = 0; grid.size() < request_.points; ++dart) {
            if (dart % (1 << 16) == 0) stop_if_interrupted();
            if (dart == most) throw too_full(grid.size(), realization);
            const auto words =
                philox({static_cast<std::uint32_t>(dart), static_cast<std::uint32_t>(dart >> 32), 0, 1}, stream);
            const auto along = [&](std::uint32_t word) {
                return static_cast<std::uint32_t>(std::uint64_t{word} * static_cast<std::uint64_t>(units_) >> 32);
            };
            const TorusPosition place{along(words[0]), along(words[1]), 0};
            if (!grid.is_near(place, distance_)) grid.add(place);
        }
        PointSet points = grid.point_set();
        for (double& x : points.coordinates) x *= 0x1p32 / units_;
        return points;
    }

private:
    InputError too_full(std::size_t reached, std::uint32_t realization) const
    {
        return parameters_.error(
            "relative_radius",
            fmt::format("realization {} has {} of {} points, and darts find no room for more; ask for "
                        "less",
                        realization, reached, request_.points));
    }

    Parameters parameters_;
    SampleRequest request_;
    Purpose purpose_;
    double units_ = 0; ///< of the square's side: parts of 2^-32 of the torus
    std::uint64_t distance_ = 0;
};

}

SamplerSpec with_open_border(SamplerSpec spec, Purpose purpose)
{
    spec.parameters.push_back({.key = "border",
                               .kind = ParameterSpec::Kind::choice,
                               .help = "the square is a torus, or open: points at opposite borders may be near each "
                                       "other, as in Jones' own sets",
                               .choices = {"torus", "open"},
                               .otherwise = "torus"});
    spec.check = [check = spec.check](const Parameters& given, const SampleRequest& request,
                                      const SourceLocation& where) {
        check(given, request, where);
        if (is_open(given) && given.text("stop") == "saturation")
            throw given.error("border",
                              "cannot be combined with stop = \"saturation\"; relative_radius sets the distance");
    };
    spec.device_memory = [memory = spec.device_memory](const Parameters& given, const SampleRequest& request,
                                                       const DeviceInfo& device) {
        return is_open(given) ? DeviceMemory{} : memory(given, request, device);
    };
    spec.create = [create = spec.create, purpose](const Parameters& given, const SampleRequest& request, Engine engine,
                                                  const DeviceProvider& device) -> std::unique_ptr<Sampler> {
        if (is_open(given)) return std::make_unique<OpenDarts>(given, request, purpose);
        return create(given, request, engine, device);
    };
    return spec;
}

}
