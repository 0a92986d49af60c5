#include "host/tile_sampling/penrose/penrose_sampler.hpp"

#include "base/densities/density_text.hpp"
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/files/xxh64_bytes.hpp"
#include "host/sampling/classics/plain_spec.hpp"
#include "host/sampling/device_sampler.hpp"
#include "host/tile_sampling/penrose/penrose_importance.hpp"
#include "host/tile_sampling/penrose/penrose_table_cache.hpp"
#include "host/tile_sampling/tile_set_cache.hpp"

#include <fmt/format.h>

#include <chrono>
#include <optional>

namespace poissonlab {
namespace {

constexpr const char* density_key = "density";
constexpr const char* channel_key = "density_from";

/// The density as it was given; of a picture the name with the folder of the config, where it is looked for.
std::string density_named(const Parameters& given)
{
    const std::filesystem::path folder = std::filesystem::path(given.location(density_key).file).parent_path();
    const std::string& text = given.text(density_key);
    const std::string file = (folder / text).string();
    return is_file_name(file) ? file : text;
}

DensityBounds density_bounds_of(const Parameters& given)
{
    if (!given.is_given(density_key)) return {};
    try {
        return DensityBounds(density_of_text(density_named(given), given.text(channel_key), 1, 1));
    } catch (const InputError& error) {
        throw InputError::at(given.location(density_key), fmt::format("{}: {}", density_key, error.what()));
    }
}

class PenroseSampler final : public DeviceSampler
{
public:
    PenroseSampler(const Parameters& given, const SampleRequest& request, Engine engine, const DeviceProvider& device)
        : DeviceSampler(engine, device)
    {
        const auto begin = std::chrono::steady_clock::now();
        CachedPenroseTable cached = cached_penrose_table(tile_cache_folder(), request.on_step);
        tiling_ = std::make_unique<PenroseTiling>(cached.table, density_bounds_of(given));
        importance_ = importance_for_points(*tiling_, request.points);
        if (device_) generator_.emplace(*device_, *tiling_);
        const std::chrono::duration<double> all = std::chrono::steady_clock::now() - begin;
        preparation_seconds_ = all.count() - build_seconds() - cached.waiting_seconds;
    }

    PointSet sample(std::uint32_t) override
    {
        return generator_ ? generator_->points(importance_)
                          : point_set_of(reference::penrose_points(*tiling_, importance_));
    }

    bool is_window() const override { return true; }
    double preparation_seconds() const override { return preparation_seconds_; }

private:
    std::unique_ptr<PenroseTiling> tiling_; ///< the generator points to it
    std::uint64_t importance_ = 0;
    std::optional<PenroseGenerator> generator_;
    double preparation_seconds_ = 0;
};

void check_density(const Parameters& given, const SampleRequest&, const SourceLocation&)
{
    if (given.is_given(channel_key) && !(given.is_given(density_key) && is_file_name(density_named(given))))
        throw given.error(channel_key, fmt::format("is for pictures, and there is none as {}", density_key));
    density_bounds_of(given);
}

}

SamplerSpec penrose_sampler()
{
    using Kind = ParameterSpec::Kind;
    SamplerSpec spec = plain_spec(
        "penrose", "Penrose tiling", "a window of a Penrose tiling whose points are moved by a table (all the same)",
        {2},
        {{.key = density_key,
          .kind = Kind::text,
          .help = "points follow it: a picture, from the folder of the config, or a formula in x and y from -1 to 1, "
                  "such as \"exp(-8*(x^2+y^2))\"",
          .unless_given = "the same everywhere"},
         {.key = channel_key,
          .kind = Kind::text,
          .help = "of a picture: light, ink or one of its channels",
          .otherwise = std::string("light")}});
    spec.deterministic = true;
    spec.check = check_density;
    spec.outside_input = [](const Parameters& given) -> std::uint64_t {
        if (!given.is_given(density_key) || !is_file_name(density_named(given))) return 0;
        return xxh64_bytes(read_whole_file(density_named(given)));
    };
    spec.device_memory = [](const Parameters& given, const SampleRequest& request, const DeviceInfo&) {
        return PenroseGenerator::memory(request.points, density_bounds_of(given).weights.size());
    };
    // Some more than asked for where the number lies between two rows of the table.
    spec.most_points = [](const Parameters&, const SampleRequest& request) -> std::size_t {
        return request.points + request.points / 16 + 16;
    };
    spec.create = [](const Parameters& given, const SampleRequest& request, Engine engine,
                     const DeviceProvider& device) -> std::unique_ptr<Sampler> {
        try {
            return std::make_unique<PenroseSampler>(given, request, engine, device);
        } catch (const InputError& error) {
            throw given.is_given(density_key) ? error.moved_to(given.location(density_key)) : error;
        }
    };
    return spec;
}

}
