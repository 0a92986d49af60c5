#include "host/tile_construction/chain_corners.hpp"

#include "base/random/random.hpp"
#include "host/tile_construction/joint/unit_circle.hpp"

#include <array>
#include <cmath>

namespace poissonlab {
namespace {

constexpr std::uint32_t choices = 4000;
constexpr double reach = 0.7; ///< of offsets, in spacings

/// Frequencies looked at, in units of the square root of the points a tile: around the ring of a good distribution.
constexpr double lowest = 0.6, highest = 1.3;

/// One of each two opposite frequencies.
std::vector<TileFrequency> ring_frequencies(double root)
{
    std::vector<TileFrequency> frequencies;
    const auto most = static_cast<std::int32_t>(std::floor(highest * root));
    for (std::int32_t x = 0; x <= most; ++x)
        for (std::int32_t y = x == 0 ? 1 : -most; y <= most; ++y)
            if (const double length = std::hypot(x, y); length >= lowest * root && length <= highest * root)
                frequencies.push_back({x, y, 0});
    return frequencies;
}

/// Even units in the disk, by rejection; every try has its own random numbers.
UnitPosition offset_in_disk(const StreamKey& stream, std::uint32_t choice, std::uint32_t color, double radius)
{
    for (std::uint32_t attempt = 0;; ++attempt) {
        const auto words = philox({choice, color, attempt, 0}, stream);
        const double x = (words[0] * 0x1p-31 - 1) * radius, y = (words[1] * 0x1p-31 - 1) * radius;
        if (x * x + y * y <= radius * radius)
            return {2 * static_cast<std::int32_t>(x / 2), 2 * static_cast<std::int32_t>(y / 2), 0};
    }
}

double unevenness(const std::vector<UnitPosition>& offsets, const std::vector<TileFrequency>& ring)
{
    double sum = 0;
    for (const auto& frequency : ring) {
        std::complex<double> transform = 0;
        for (const UnitPosition& offset : offsets) transform += unit_circle()[phase_of(frequency, offset)];
        sum += std::norm(transform) * std::norm(transform);
    }
    return sum;
}

}

std::vector<UnitPosition> spread_corners(const PoissonTileParameters& parameters)
{
    std::vector<UnitPosition> best(parameters.colors, UnitPosition{});
    if (parameters.colors == 1) return best; // wherever it is, all corners are there
    const double root = std::sqrt(parameters.points_per_tile);
    const auto ring = ring_frequencies(root);
    const StreamKey stream = stream_key(parameters.seed, Purpose::chain_corners, 0);
    double least = unevenness(best, ring);
    for (std::uint32_t choice = 0; choice < choices; ++choice) {
        std::vector<UnitPosition> offsets;
        for (std::uint32_t color = 0; color < parameters.colors; ++color)
            offsets.push_back(offset_in_disk(stream, choice, color, reach * tile_units / root));
        const double found = unevenness(offsets, ring);
        if (found >= least) continue;
        least = found;
        best = offsets;
    }
    return best;
}

}
