#include "host/sampling/classics/candidate_darts.hpp"

#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/random/random.hpp"
#include "host/sampling/classics/plain_spec.hpp"
#include "host/sampling/classics/torus_grid.hpp"

#include <fmt/format.h>

#include <cmath>

namespace poissonlab {
namespace {

TorusPosition random_position(const std::array<std::uint32_t, 4>& words, int dimension)
{
    return {words[0], words[1], dimension == 3 ? words[2] : 0};
}

/// The relative radius that sets of 30 attempts have, within a percent: more attempts come nearer to saturation.
constexpr double usual_radius_2d = 0.730, usual_radius_3d = 0.745;

double bridson_distance(const Parameters& parameters, const SampleRequest& request)
{
    if (parameters.is_given("min_distance")) return parameters.number("min_distance");
    return min_distance_for(request.dimension == 2 ? usual_radius_2d : usual_radius_3d, request.points,
                            request.dimension);
}

class BridsonSampler final : public Sampler
{
public:
    BridsonSampler(const SampleRequest& request, double min_distance, std::int64_t attempts)
        : request_(request), attempts_(static_cast<std::uint32_t>(attempts)),
          distance_(static_cast<std::uint64_t>(std::ceil(min_distance * 4294967296.0)))
    {}

    SetTraits traits() const override { return {.sizes_vary = true}; }

    PointSet sample(std::uint32_t realization) override
    {
        const StreamKey stream = stream_key(request_.seed, Purpose::bridson, realization);
        const double side = static_cast<double>(distance_) / 4294967296.0;
        TorusGrid grid(static_cast<std::size_t>(1 / std::pow(side, request_.dimension)), request_.dimension);
        std::vector<std::uint32_t> active{0};
        grid.add(random_position(philox({0, 0, 0, first_use}, stream), request_.dimension));
        for (std::uint32_t turn = 0; !active.empty(); ++turn) {
            const std::uint64_t random = philox({turn, 0, 0, choice_use}, stream)[0];
            const std::size_t chosen = static_cast<std::size_t>(random * active.size() >> 32);
            if (throws_well(grid, grid[active[chosen]], turn, stream)) {
                active.push_back(static_cast<std::uint32_t>(grid.size() - 1));
            } else {
                active[chosen] = active.back();
                active.pop_back();
            }
        }
        return grid.point_set();
    }

private:
    static constexpr std::uint32_t first_use = 0, choice_use = 1, dart_use = 2;

    /// Adds the first dart around a point that is not too near to any.
    bool throws_well(TorusGrid& grid, const TorusPosition& around, std::uint32_t turn, const StreamKey& stream) const
    {
        grid.ask_around(around, 3 * distance_);
        std::uint32_t word = 0;
        for (std::uint32_t attempt = 0; attempt < attempts_; ++attempt) {
            TorusPosition dart = around;
            // A place in the ring of one to two distances: a uniform one in the square around it, of those the first.
            for (;; ++word) {
                const auto words = philox({turn, word, 0, dart_use}, stream);
                std::uint64_t squared = 0;
                for (std::size_t k = 0; k < static_cast<std::size_t>(request_.dimension); ++k) {
                    const auto offset = static_cast<std::int64_t>((4 * distance_ * words[k]) >> 32) -
                                        static_cast<std::int64_t>(2 * distance_);
                    squared += static_cast<std::uint64_t>(offset * offset);
                    dart[k] = around[k] + static_cast<std::uint32_t>(offset);
                }
                if (squared >= distance_ * distance_ && squared < 4 * distance_ * distance_) break;
            }
            ++word;
            if (grid.is_near(dart, distance_)) continue;
            grid.add(dart);
            return true;
        }
        return false;
    }

    SampleRequest request_;
    std::uint32_t attempts_;
    std::uint64_t distance_; ///< in units of 2^-32
};

}

SamplerSpec bridson_sampler()
{
    SamplerSpec spec =
        plain_spec("bridson", "Bridson's dart throwing",
                   "darts around the points that are there, until none finds room (Bridson 2007)", {2, 3},
                   {{.key = "min_distance",
                     .help = "the minimum distance, in units of the torus' side",
                     .maximum = 0.25,
                     .exclusive_minimum = true,
                     .symbol = "d",
                     .unless_given = "what gives about analysis.points points"},
                    {.key = "attempts",
                     .kind = ParameterSpec::Kind::integer,
                     .help = "darts around a point before it is given up",
                     .minimum = 1,
                     .maximum = 1'000'000,
                     .symbol = "k",
                     .otherwise = std::int64_t{30}}});
    spec.check = [](const Parameters& parameters, const SampleRequest& request, const SourceLocation& where) {
        constexpr double most = 1 << 28;
        const double distance = bridson_distance(parameters, request);
        if (distance > 0.25)
            throw InputError::at(where,
                                 fmt::format("sampler = \"bridson\": {} points have a distance of {:.3f}: must be at "
                                             "most 0.25; more points",
                                             request.points, distance));
        if (std::pow(distance, -request.dimension) > most)
            throw parameters.error("min_distance", fmt::format("must leave at most {:.0f} points", most));
    };
    spec.most_points = [](const Parameters& parameters, const SampleRequest& request) -> std::size_t {
        const double ratio = saturation_relative_radius(request.dimension) /
                             relative_radius(bridson_distance(parameters, request), 1, request.dimension);
        return static_cast<std::size_t>(1.05 * std::pow(ratio, request.dimension)) + 20;
    };
    spec.create = [](const Parameters& parameters, const SampleRequest& request, Engine, const DeviceProvider&) {
        return std::make_unique<BridsonSampler>(request, bridson_distance(parameters, request),
                                                parameters.integer("attempts"));
    };
    return spec;
}

}
