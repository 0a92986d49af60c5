#include "host/tile_construction/filling/tile_filling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

/// Relaxation dart throwing is given up below this part of the radius that it starts from.
constexpr double least_radius = 0.2;

/// Surroundings of a tile are filled with this part of the attempts.
constexpr std::uint32_t surroundings_share = 4;

/// Passes of repulsion; those that succeed take 5 to 100.
constexpr std::uint32_t max_repulsion_passes = 400;

/// Points that are just short of the distance that is asked for are pushed a little farther, and so are those
/// that rounding to whole units may bring closer again.
constexpr double repulsion_margin = 1.0005;
constexpr double rounding_margin = 2;

/// Few points may be asked to keep distances whose squares have more than 32 bits.
std::uint32_t limited_to_words(double value)
{
    return static_cast<std::uint32_t>(std::min<double>(value, std::numeric_limits<std::uint32_t>::max()));
}

}

FillSettings fill_settings(const PoissonTileParameters& p)
{
    FillSettings settings;
    settings.dimension = p.dimension;
    settings.wanted = limited_to_words(static_cast<double>(asked_squared_distance(p)));
    const double distance = asked_min_distance(p) * tile_units;
    const double factor = p.filling == TileFilling::dart_throwing ? 0 : p.factor;
    for (double part = 1; part >= least_radius; part *= factor) {
        const double reduced = distance * part;
        settings.squared_distances.push_back(limited_to_words(std::ceil(reduced * reduced)));
    }
    settings.attempts = p.attempts;
    settings.surrounding_attempts = std::max<std::uint32_t>(1, p.attempts / surroundings_share);
    settings.lloyd_iterations = p.lloyd_iterations;
    settings.repulsion_passes = p.repulsion ? max_repulsion_passes : 0;
    settings.repulsion_distance = std::max(distance * repulsion_margin, distance + rounding_margin);
    settings.spacing = tile_units / std::pow(p.points_per_tile, 1.0 / p.dimension);
    settings.stream = stream_key(p.seed, Purpose::tile_filling, 0);
    return settings;
}

}
