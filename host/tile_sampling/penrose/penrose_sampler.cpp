#include "host/tile_sampling/penrose/penrose_sampler.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/cache_folder.hpp"
#include "base/random/random.hpp"
#include "code_hashes.hpp"
#include "host/sampling/classics/plain_spec.hpp"
#include "host/sampling/density_parameters.hpp"
#include "host/sampling/device_sampler.hpp"
#include "host/tile_sampling/penrose/penrose_relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <optional>

namespace poissonlab {

std::string penrose_table_name() { return fmt::format("penrose-{}.table", POISSONLAB_SAMPLING_VERSION); }

BuiltOnce<PenroseTable> cached_penrose_table(const std::filesystem::path& folder,
                                             const std::function<void(const std::string& what)>& on_step)
{
    return built_once(
        folder.empty() ? folder : folder / penrose_table_name(), on_step, read_penrose_table,
        [&] { return relaxed_penrose_table({}, on_step); }, write_penrose_table);
}

namespace {

/// The nearest set so far.
class Nearest
{
public:
    explicit Nearest(std::size_t points) : points_(points) {}

    void offer(std::uint64_t importance, std::size_t found)
    {
        const std::size_t away = std::max(found, points_) - std::min(found, points_);
        if (away >= away_) return;
        away_ = away;
        importance_ = importance;
    }

    bool is_exact() const { return away_ == 0; }
    std::uint64_t importance() const { return importance_; }

private:
    std::size_t points_;
    std::size_t away_ = SIZE_MAX;
    std::uint64_t importance_ = 1;
};

/// Within a row no point moves, so that sets of smaller importances are parts of the row's last one.
void offer_row(const PenroseTiling& tiling, const ImportanceRange& row, std::size_t points, Nearest& nearest)
{
    std::vector<std::uint64_t> values;
    for (const PenrosePoint& point : reference::penrose_points(tiling, row.end - 1)) values.push_back(point.value);
    std::ranges::sort(values);
    const std::uint64_t wanted = points <= values.size() ? values[points - 1] + 1 : row.end - 1;
    const std::uint64_t importance = std::clamp(wanted, row.begin, row.end - 1);
    nearest.offer(importance, static_cast<std::size_t>(std::ranges::lower_bound(values, importance) - values.begin()));
}

std::uint64_t for_even_density(const PenroseTiling& tiling, std::size_t points, std::uint64_t guess)
{
    constexpr int rows_around = 2; // of 5 % more or fewer points each
    Nearest nearest(points);
    const PenroseRow middle = row_of_importance(tiling.scales, guess);
    const int number = static_cast<int>(middle.level) * contract::penrose::ROWS + static_cast<int>(middle.row);
    for (int step = 0; step <= 2 * rows_around && !nearest.is_exact(); ++step) {
        const int other = number + (step % 2 == 0 ? step / 2 : -(step + 1) / 2);
        if (other < 0) continue;
        const ImportanceRange range =
            importances_of(tiling.scales, {static_cast<std::size_t>(other) / contract::penrose::ROWS,
                                           static_cast<std::size_t>(other) % contract::penrose::ROWS});
        if (range.begin < range.end && range.end - 1 <= most_penrose_importance())
            offer_row(tiling, range, points, nearest);
    }
    return nearest.importance();
}

std::uint64_t for_density(const PenroseTiling& tiling, std::size_t points, std::uint64_t guess)
{
    constexpr int tries = 20;
    Nearest nearest(points);
    std::uint64_t low = 1, high = most_penrose_importance(), importance = guess;
    for (int i = 0; i < tries && !nearest.is_exact() && low < high; ++i) {
        const std::size_t found = reference::penrose_points(tiling, importance).size();
        nearest.offer(importance, found);
        if (found < points)
            low = importance + 1;
        else
            high = importance;
        // The next importance is in proportion to points at first; where that leads astray, the range is halved.
        const double next = static_cast<double>(importance) * static_cast<double>(points) /
                            static_cast<double>(std::max<std::size_t>(found, 1));
        const bool is_between = next >= static_cast<double>(low) && next < static_cast<double>(high);
        importance = i < tries / 2 && is_between ? static_cast<std::uint64_t>(next) : low + (high - low) / 2;
    }
    return nearest.importance();
}

}

std::uint64_t importance_for_points(const PenroseTiling& tiling, std::size_t points)
{
    const DensityBounds& density = tiling.density;
    const std::size_t pixels = std::size_t{density.width} * density.height;
    const double sum =
        std::accumulate(density.weights.begin(), density.weights.begin() + static_cast<std::ptrdiff_t>(pixels), 0.0);
    const double mean = sum / static_cast<double>(pixels) / static_cast<double>(full_weight);
    const double guess = static_cast<double>(points) / points_per_importance / mean + 1;
    if (guess > 0.9 * static_cast<double>(most_penrose_importance()))
        throw InputError(fmt::format("{} points in the {:.2g}th part of the square: tiles would have to be finer than "
                                     "level {}; fewer points, or a density that is less peaked",
                                     points, 1 / mean, int{contract::penrose::DEEPEST}));
    const auto start = static_cast<std::uint64_t>(guess);
    return pixels == 1 ? for_even_density(tiling, points, start) : for_density(tiling, points, start);
}

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
