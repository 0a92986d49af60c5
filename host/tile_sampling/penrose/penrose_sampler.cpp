#include "host/tile_sampling/penrose/penrose_sampler.hpp"

#include "base/programs/cache_folder.hpp"
#include "base/random/random.hpp"
#include "host/sampling/classics/plain_spec.hpp"
#include "host/sampling/density_parameters.hpp"
#include "host/sampling/device_sampler.hpp"
#include "host/tile_sampling/penrose/penrose_importance.hpp"
#include "host/tile_sampling/penrose/penrose_table_cache.hpp"

#include <chrono>
#include <optional>

namespace poissonlab {
namespace {

constexpr const char* window_key = "random_window";
constexpr int window_halvings = 1; // windows have half of the side of the square that is made

DensityBounds density_bounds_of(const Parameters& given)
{
    const auto density = given_density(given);
    return density ? DensityBounds(*density) : DensityBounds();
}

/// Realizations at random places have so many times the points in the whole square.
std::size_t points_of_square(const Parameters& given, std::size_t points)
{
    return given.flag(window_key) ? points << (2 * window_halvings) : points;
}

/// A window's points, stretched over the unit square.
PointSet stretched(PointSet points, const PenroseWindow& window)
{
    const double times = 0x1p32 / static_cast<double>(window.side);
    for (std::size_t i = 0; i < points.coordinates.size(); ++i)
        points.coordinates[i] = times * (points.coordinates[i] - window.low[i % 2] * 0x1p-32);
    return points;
}

class PenroseSampler final : public DeviceSampler
{
public:
    PenroseSampler(const Parameters& given, const SampleRequest& request, Engine engine, const DeviceProvider& device)
        : DeviceSampler(engine, device), seed_(request.seed), has_random_window_(given.flag(window_key))
    {
        const auto begin = std::chrono::steady_clock::now();
        BuiltOnce<PenroseTable> cached = cached_penrose_table(cache_folder(), request.on_step);
        tiling_ = std::make_unique<PenroseTiling>(cached.built, density_bounds_of(given));
        importance_ = importance_for_points(*tiling_, points_of_square(given, request.points));
        if (device_) generator_.emplace(*device_, *tiling_);
        const std::chrono::duration<double> all = std::chrono::steady_clock::now() - begin;
        preparation_seconds_ = all.count() - build_seconds() - cached.waiting_seconds;
    }

    PointSet sample(std::uint32_t realization) override
    {
        const PenroseWindow window = window_of(realization);
        PointSet points = generator_ ? generator_->points(importance_, window)
                                     : point_set_of(reference::penrose_points(*tiling_, importance_, window));
        return has_random_window_ ? stretched(std::move(points), window) : points;
    }

    SetTraits traits() const override
    {
        SetTraits traits;
        traits.sizes_vary = has_random_window_; // windows of one size have about as many points
        traits.is_window = true;
        traits.preparation_seconds = preparation_seconds_;
        return traits;
    }

private:
    PenroseWindow window_of(std::uint32_t realization) const
    {
        if (!has_random_window_) return {};
        const StreamKey place = stream_key(seed_, Purpose::penrose_window, realization);
        return {{place[0] >> window_halvings, place[1] >> window_halvings}, std::uint64_t{1} << (32 - window_halvings)};
    }

    std::uint64_t seed_;
    bool has_random_window_;
    std::unique_ptr<PenroseTiling> tiling_; ///< the generator points to it
    std::uint64_t importance_ = 0;
    std::optional<PenroseGenerator> generator_;
    double preparation_seconds_ = 0;
};

void check_penrose(const Parameters& given, const SampleRequest&, const SourceLocation&)
{
    if (given_density(given) && given.flag(window_key))
        throw given.error(window_key, "is for points that are the same everywhere, and there is a density");
}

std::vector<ParameterSpec> penrose_parameters()
{
    std::vector<ParameterSpec> specs = density_parameters();
    specs.push_back({.key = window_key,
                     .kind = ParameterSpec::Kind::boolean,
                     .help = "realizations are windows of a larger tiling at random places, with about as many points; "
                             "else all are the same",
                     .otherwise = false});
    return specs;
}

}

SamplerSpec penrose_sampler()
{
    SamplerSpec spec =
        plain_spec("penrose", "Penrose tiling", "a window of a Penrose tiling whose points are moved by a table", {2},
                   penrose_parameters());
    spec.is_deterministic = [](const Parameters& given) { return !given.flag(window_key); };
    spec.check = check_penrose;
    spec.outside_input = density_hash;
    spec.memory_growth = MemoryGrowth::linear;
    spec.device_memory = [](const Parameters& given, const SampleRequest& request, const DeviceInfo&) {
        return PenroseGenerator::memory(points_of_square(given, request.points),
                                        density_bounds_of(given).weights.size());
    };
    // Some more than asked for where the number lies between two rows of the table.
    spec.most_points = [](const Parameters&, const SampleRequest& request) -> std::size_t {
        return request.points + request.points / 16 + 16;
    };
    spec.kernels = {"penrose.cl"};
    spec.create = [](const Parameters& given, const SampleRequest& request, Engine engine,
                     const DeviceProvider& device) -> std::unique_ptr<Sampler> {
        try {
            return std::make_unique<PenroseSampler>(given, request, engine, device);
        } catch (const InputError& error) { // tiles would have to be too fine
            throw given.is_given("density") ? error.moved_to(given.location("density")) : error;
        }
    };
    return spec;
}

}
