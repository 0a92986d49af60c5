#include "app/commands/tiles/prefix_quality.hpp"

#include "analysis/measures/distance_statistics.hpp"
#include "analysis/spectra/radial_statistics.hpp"
#include "analysis/spectra/spectrum.hpp"
#include "base/geometry/relative_radius.hpp"
#include "host/tile_points/point_levels.hpp"
#include "host/tile_sampling/tile_samplers.hpp"

#include <algorithm>

namespace poissonlab {
namespace {

constexpr std::uint32_t tilings = 4;

/// The mean power below half of the principal frequency.
double low_power(const Spectrum& spectrum)
{
    const double end = principal_frequency(spectrum.points, spectrum.dimension) / 2;
    double power = 0, samples = 0;
    for (const RadialBin& bin : radial_statistics(spectrum)) {
        if (bin.frequency >= end) continue;
        power += bin.power * static_cast<double>(bin.samples);
        samples += static_cast<double>(bin.samples);
    }
    return power / samples;
}

PrefixQuality quality_at(const PoissonTileSet& set, double density)
{
    const PoissonTileParameters& p = set.parameters;
    const std::size_t wanted = p.dimension == 2 ? 4096 : 16'384;
    const std::uint32_t side = std::max(2U, tiling_side(wanted, density * p.points_per_tile, p.dimension));
    PrefixQuality quality{.density = density, .power = 0, .random_power = 0, .relative_radius = 1e300};
    std::optional<SpectrumEstimate> part, whole;
    for (std::uint32_t seed = 1; seed <= tilings; ++seed) {
        const PointSet all = reference::torus_points(set, seed, side);
        const PointSet kept = at_density(all, density, set, seed, side);
        if (!part) {
            const int size = spectrum_size(kept.size(), p.dimension);
            part.emplace(p.dimension, size, true);
            whole.emplace(p.dimension, size, true);
        }
        part->add(kept);
        whole->add(all);
        quality.relative_radius =
            std::min(quality.relative_radius, relative_radius(min_toroidal_distance(kept), kept.size(), p.dimension));
    }
    quality.power = low_power(part->mean());
    // The whole tiling's power at the frequencies of the part.
    Spectrum of_whole = whole->mean();
    of_whole.points = part->mean().points;
    quality.random_power = 1 - density + density * low_power(of_whole);
    return quality;
}

}

std::vector<PrefixQuality> prefix_qualities(const PoissonTileSet& set)
{
    std::vector<PrefixQuality> qualities;
    for (const double density : {0.25, 0.5, 0.75}) qualities.push_back(quality_at(set, density));
    return qualities;
}

}
