#include "host/tile_sampling/monotiles/monotile_sampler.hpp"

#include "base/errors/errors.hpp"
#include "base/files/byte_archive.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/programs/cache_folder.hpp"
#include "base/random/random.hpp"
#include "code_hashes.hpp"
#include "host/sampling/classics/plain_spec.hpp"
#include "host/settings/tile_sets/tile_set_keys.hpp"
#include "host/settings/tilings/polygon_tiling_file.hpp"
#include "host/tile_sampling/monotiles/monotile_file_sampler.hpp"
#include "tiles/polyominoes/polyomino_table.hpp"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cmath>
#include <utility>

namespace poissonlab {

template <class Archive>
void serialize(Archive& archive, MonotilePlace& place)
{
    archive(place.x, place.y);
}

template <class Archive>
void serialize(Archive& archive, SquaredLength& length)
{
    archive(length.whole, length.root);
}

namespace {

constexpr const char* points_key = "points_per_tile";
constexpr const char* kept_key = "kept_points";
constexpr const char* levels_key = "levels";

/// The attempt of the stream that places windows; isohedral tiles, which share the stream, use 1.
constexpr std::uint32_t window = 2;

/// The numbers of a table that a file stores; its states follow from the tiling.
struct StoredNumbers
{
    std::vector<MonotilePlace> places;
    std::vector<SquaredLength> distances;

    template <class Archive>
    void serialize(Archive& archive)
    {
        archive(places, distances);
    }
};

std::optional<MonotileTable> read_monotile_table(const std::filesystem::path& file, MonotileTable empty)
{
    const std::optional<std::string> bytes = read_with_checksum(file);
    if (!bytes) return std::nullopt;
    StoredNumbers numbers;
    from_bytes(*bytes, numbers);
    empty.places = std::move(numbers.places);
    empty.distances = std::move(numbers.distances);
    if (empty.places.size() != empty.states.parts.size() * empty.points || empty.distances.size() != empty.points)
        return std::nullopt;
    return empty;
}

class MonotileSampler final : public Sampler
{
public:
    MonotileSampler(const std::string& tiling, const Parameters& given, SampleRequest request)
        : request_(std::move(request)),
          kept_(static_cast<std::uint32_t>(given.integer(given.is_given(kept_key) ? kept_key : points_key)))
    {
        const auto begin = std::chrono::steady_clock::now();
        BuiltOnce<MonotileTable> cached = cached_monotile_table(
            tiling, static_cast<std::uint32_t>(given.integer(points_key)),
            static_cast<std::uint32_t>(given.integer(levels_key)), cache_folder(), request_.on_step);
        table_ = std::move(cached.built);
        points_.emplace(table_);
        const std::chrono::duration<double> all = std::chrono::steady_clock::now() - begin;
        preparation_seconds_ = all.count() - cached.waiting_seconds;
    }

    PointSet sample(std::uint32_t realization) override
    {
        PointSet set;
        // A small window may lie between points: then another place is tried.
        for (std::uint32_t attempt = 0; set.size() == 0; ++attempt) {
            const auto words =
                philox({attempt, 0, 0, 0}, stream_key(request_.seed, Purpose::isohedral_points, realization, window));
            const auto part = [&](std::size_t i) { return words[i] * 0x1p-32 - 0.5; };
            const std::array<double, 2> place{part(0) * MonotilePoints::farthest, part(1) * MonotilePoints::farthest};
            const RingPlace tile = points_->tile_at(place);
            // The window is centred on the random place and not on the tile.
            const PolygonTiling& tiling = *table_.states.tiling;
            const auto [x_away, y_away] = point_of(tiling, place_near(tiling, place) - tile);
            for (const auto& [x, y] : points_->square(tile, side(), kept_, {x_away + part(2), y_away + part(3)}))
                set.coordinates.insert(set.coordinates.end(), {x + 0.5, y + 0.5});
        }
        return set;
    }

    SetTraits traits() const override
    {
        SetTraits traits{.sizes_vary = true, .is_window = true};
        traits.proven_relative_radius =
            relative_radius(table_.distances[kept_ - 1].length() / side(), request_.points, 2);
        traits.preparation_seconds = preparation_seconds_;
        return traits;
    }

private:
    /// The side of a window, in units of the tiling.
    double side() const { return std::sqrt(static_cast<double>(request_.points) / monotile_density(table_, kept_)); }

    SampleRequest request_;
    std::uint32_t kept_;
    MonotileTable table_;
    std::optional<MonotilePoints> points_;
    double preparation_seconds_ = 0;
};

SamplerSpec monotile_sampler(const std::string& tiling, const std::string& title, const std::string& summary)
{
    using Kind = ParameterSpec::Kind;
    std::vector<ParameterSpec> parameters = monotile_parameters();
    parameters.insert(parameters.begin() + 1,
                      {.key = kept_key,
                       .kind = Kind::integer,
                       .help = "number of points kept in each tile; their distance is proven as well",
                       .minimum = 1,
                       .maximum = 16,
                       .symbol = "k",
                       .unless_given = "all"});
    for (ParameterSpec& parameter : monotile_file_parameters()) parameters.push_back(std::move(parameter));
    SamplerSpec spec = plain_spec(tiling + "-tiles", title, summary, {2}, std::move(parameters));
    spec.check = [tiling](const Parameters& given, const SampleRequest& request, const SourceLocation&) {
        check_monotile_file(tiling, given, request);
        if (!has_monotile_file(given) && given.is_given(kept_key) &&
            given.integer(kept_key) > given.integer(points_key))
            throw given.error(kept_key,
                              fmt::format("must be at most {}, which is {}", points_key, given.integer(points_key)));
    };
    spec.outside_input = monotile_file_hash;
    // A window cuts tiles: the number differs by at most about the points in a border of one tile's width.
    spec.most_points = [](const Parameters&, const SampleRequest& request) -> std::size_t {
        return request.points + static_cast<std::size_t>(8 * std::sqrt(static_cast<double>(request.points))) + 512;
    };
    spec.create = [tiling](const Parameters& given, const SampleRequest& request, Engine,
                           const DeviceProvider&) -> std::unique_ptr<Sampler> {
        if (has_monotile_file(given)) return monotile_file_sampler(given, request);
        return std::make_unique<MonotileSampler>(tiling, given, request);
    };
    return spec;
}

}

BuiltOnce<MonotileTable> cached_monotile_table(const std::string& tiling, std::uint32_t points, std::uint32_t levels,
                                               const std::filesystem::path& folder,
                                               const std::function<void(const std::string& what)>& on_step)
{
    const PolygonTiling& polygons = built_in_tiling(tiling);
    const std::string name =
        fmt::format("{}-tiles-{}-{}-{}.table", tiling, points, levels, POISSONLAB_SAMPLING_VERSION);
    return built_once(
        folder.empty() ? folder : folder / name, on_step,
        [&](const std::filesystem::path& file) {
            return read_monotile_table(file, {monotile_states(polygons, levels), points, {}, {}});
        },
        [&] { return build_monotile_table(polygons, points, levels, on_step); },
        [](const std::filesystem::path& file, const MonotileTable& table) {
            write_with_checksum(file, to_bytes(StoredNumbers{table.places, table.distances}));
        });
}

SamplerSpec hat_sampler()
{
    return monotile_sampler("hat", "Hats",
                            "a window of a tiling by hats, an aperiodic monotile, with points in each tile and a "
                            "proven minimum distance");
}

SamplerSpec spectre_sampler()
{
    return monotile_sampler("spectre", "Spectres",
                            "a window of a tiling by spectres, an aperiodic monotile without reflections, with points "
                            "in each tile and a proven minimum distance");
}

}
