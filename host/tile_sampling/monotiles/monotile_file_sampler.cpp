#include "host/tile_sampling/monotiles/monotile_file_sampler.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/files/xxh64_bytes.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/programs/interrupt.hpp"
#include "base/random/random.hpp"
#include "host/sampling/one_file.hpp"
#include "host/settings/tilings/polygon_tiling_file.hpp"
#include "tiles/monotiles/monotile_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

namespace poissonlab {
namespace {

constexpr const char* tiles_key = "tiles";
constexpr const char* density_key = "density";
constexpr const char* first_points_key = "kept_points";

/// The attempt of the stream that places windows; tables that are built use 2.
constexpr std::uint32_t file_window = 3;

/// The largest double below 1.
constexpr double below_one = 1 - 0x1p-53;

InputError file_error(const Parameters& given, const std::string& what)
{
    return invalid_value(given.location(tiles_key), tiles_key, fmt::format("\"{}\"", given.texts(tiles_key).front()),
                         what);
}

MonotilePointsFile given_file(const Parameters& given)
{
    const std::filesystem::path path = one_file(given, tiles_key);
    try {
        if (!is_monotile_points_file(path))
            throw InputError("must be a file of tiles build hat or tiles build spectre").moved_to({path.string()});
        return read_monotile_points(path);
    } catch (const InputError& error) {
        throw file_error(given, error.what());
    }
}

/// The points of a tile that are kept of all ranks.
std::uint32_t kept_points(const Parameters& given, const MonotilePointsFile& file)
{
    return given.is_given(first_points_key) ? static_cast<std::uint32_t>(given.integer(first_points_key))
                                            : file.set().points_per_tile;
}

void check_density(const Parameters& given, const MonotilePointsFile& file, const SampleRequest& request)
{
    if (given.is_given("min_distance")) return; // the length of edges follows from it, not from a number of points
    const double density = given.number(density_key), kept = kept_points(given, file);
    if (density < 1 && static_cast<double>(request.points) / (density * kept) > 0x1p26)
        throw given.error(density_key, "must be larger: a window would have more than 2^26 tiles");
}

class MonotileFileSampler final : public Sampler
{
public:
    MonotileFileSampler(const Parameters& given, SampleRequest request)
        : request_(std::move(request)), begin_(std::chrono::steady_clock::now()),
          proven_(proven_monotile_file(given, request_)), density_(given.number(density_key)),
          kept_(kept_points(given, proven_.file)),
          preparation_seconds_(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count())
    {}

    PointSet sample(std::uint32_t realization) override
    {
        PointSet set;
        // A small window may lie between points: then another place is tried.
        for (std::uint32_t attempt = 0; set.size() == 0; ++attempt) {
            stop_if_interrupted();
            const auto words = philox({attempt, 0, 0, 0},
                                      stream_key(request_.seed, Purpose::isohedral_points, realization, file_window));
            const std::array<std::int64_t, 2> origin{static_cast<std::int32_t>(words[0]),
                                                     static_cast<std::int32_t>(words[1])};
            std::array<double, 2> low{}, high{};
            for (std::size_t axis = 0; axis < 2; ++axis) {
                low[axis] = words[2 + axis] * 0x1p-32 * proven_.file.step()[axis] - side() / 2;
                high[axis] = low[axis] + side();
            }
            for (const pmono_point& point : proven_.file.in_window(words[0], origin, low, high, density_)) {
                if (point.index >= kept_) continue;
                for (std::size_t axis = 0; axis < 2; ++axis)
                    set.coordinates.push_back(std::min((point.position[axis] - low[axis]) / side(), below_one));
            }
        }
        return set;
    }

    SetTraits traits() const override
    {
        SetTraits traits{.sizes_vary = true, .is_window = true};
        traits.proven_relative_radius =
            relative_radius(proven_.distances[kept_ - 1].length() / side(), request_.points, 2);
        traits.preparation_seconds = preparation_seconds_;
        return traits;
    }

private:
    /// The side of a window, in edges.
    double side() const
    {
        const double kept = static_cast<double>(kept_) / proven_.file.set().points_per_tile;
        return std::sqrt(static_cast<double>(request_.points) / (proven_.file.density() * density_ * kept));
    }

    SampleRequest request_;
    std::chrono::steady_clock::time_point begin_;
    ProvenMonotileFile proven_;
    double density_;
    std::uint32_t kept_;
    double preparation_seconds_ = 0;
};

}

std::vector<ParameterSpec> monotile_file_parameters()
{
    return {{.key = tiles_key,
             .kind = ParameterSpec::Kind::paths,
             .help = "a file of tiles build, relative to the folder of the config",
             .unless_given = "a table that is built"},
            {.key = density_key,
             .help = "part of the points of a file that is kept: those of the lowest ranks",
             .maximum = 1,
             .exclusive_minimum = true,
             .symbol = "density",
             .otherwise = 1.0}};
}

ProvenMonotileFile proven_monotile_file(const Parameters& given, const SampleRequest& request)
{
    MonotilePointsFile file = given_file(given);
    check_density(given, file, request);
    if (request.on_step) request.on_step(fmt::format("{}: the proof of the minimum distance", file.name()));
    try {
        std::vector<SquaredLength> distances = proven_monotile_table(file, built_in_tiling(file.tiling())).distances;
        return {std::move(file), std::move(distances)};
    } catch (const InputError& error) {
        throw file_error(given, error.what());
    }
}

bool has_monotile_file(const Parameters& given) { return given.is_given(tiles_key); }

void check_monotile_file(const std::string& tiling, const Parameters& given, const SampleRequest& request)
{
    if (!has_monotile_file(given)) {
        if (given.is_given(density_key)) throw given.error(density_key, "needs tiles, a file whose points have ranks");
        return;
    }
    for (const char* key : {"points_per_tile", "levels"})
        if (given.is_given(key)) throw given.error(key, "cannot be combined with tiles, whose file says it");
    if (given.is_given(first_points_key) && given.is_given(density_key))
        throw given.error(density_key, fmt::format("cannot be combined with {}", first_points_key));
    const MonotilePointsFile file = given_file(given);
    if (file.tiling() != tiling)
        throw file_error(given,
                         fmt::format("{} has {}s: sampler = \"{}-tiles\"", file.name(), file.tiling(), file.tiling()));
    if (given.is_given(first_points_key) && given.integer(first_points_key) > file.set().points_per_tile)
        throw given.error(first_points_key, fmt::format("must be at most {}, the points of a tile of {}",
                                                        file.set().points_per_tile, file.name()));
    check_density(given, file, request);
}

std::uint64_t monotile_file_hash(const Parameters& given)
{
    return has_monotile_file(given) ? xxh64_bytes(read_whole_file(one_file(given, tiles_key))) : 0;
}

std::unique_ptr<Sampler> monotile_file_sampler(const Parameters& given, const SampleRequest& request)
{
    return std::make_unique<MonotileFileSampler>(given, request);
}

}
