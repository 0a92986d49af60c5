#include "analysis/tilings/tiled_sets.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace poissonlab {

void need_tile_measures() {}

double lattice_share(const HalfSpectrum& periodogram, int tiles)
{
    if (tiles < 1) throw InputError("tiles = " + std::to_string(tiles) + ": must be at least 1");
    const int end = periodogram.size / 2, slices = periodogram.dimension == 3 ? end : 1;
    double all = 0, lattice = 0;
    for (int x = 0; x < end; ++x)
        for (int y = 1 - end; y < end; ++y)
            for (int z = 1 - slices; z < slices; ++z) {
                if (x == 0 && y == 0 && z == 0) continue;
                const auto row = static_cast<std::size_t>(y + end);
                const std::size_t line = periodogram.dimension == 3 ? row : 0;
                const std::size_t last = periodogram.dimension == 3 ? static_cast<std::size_t>(z + end) : row;
                const std::size_t at =
                    (static_cast<std::size_t>(x) * periodogram.lines() + line) * periodogram.rows() + last;
                // Frequencies to the left have the power of their mirror images, which are stored.
                const double power = (x > 0 ? 2 : 1) * periodogram.power[at];
                all += power;
                if (x % tiles == 0 && y % tiles == 0 && z % tiles == 0) lattice += power;
            }
    return all > 0 ? lattice / all : 0;
}

namespace {

/// Rounding may have moved a point at a tile's lower border out of it.
constexpr double rounding_of_borders = 0x1p-17; // in tiles

/// A coordinate between those of a tile's borders: what was rounded to the torus' end belongs to its beginning.
double unrounded(double coordinate, int tiles)
{
    return coordinate * tiles + rounding_of_borders < tiles ? coordinate : coordinate - 1;
}

/// A point on its way along the first axis of its tile.
struct SweptPoint
{
    std::uint64_t tile = 0;
    std::array<double, 3> place{};

    auto operator<=>(const SweptPoint&) const = default;
};

SweptPoint swept_point(std::span<const double> point, int tiles)
{
    SweptPoint swept;
    for (std::size_t k = 0; k < point.size(); ++k) {
        swept.place[k] = unrounded(point[k], tiles);
        const auto along = static_cast<std::uint64_t>(swept.place[k] * tiles + rounding_of_borders);
        swept.tile = swept.tile * static_cast<std::uint64_t>(tiles) + along;
    }
    return swept;
}

double squared_offset(const SweptPoint& a, const SweptPoint& b)
{
    double squared = 0;
    for (std::size_t k = 0; k < a.place.size(); ++k) squared += (b.place[k] - a.place[k]) * (b.place[k] - a.place[k]);
    return squared;
}

}

double min_distance_within_tiles(const PointSet& points, int tiles)
{
    std::vector<SweptPoint> swept;
    swept.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) swept.push_back(swept_point(points[i], tiles));
    std::ranges::sort(swept);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < swept.size(); ++i)
        for (std::size_t j = i + 1; j < swept.size() && swept[j].tile == swept[i].tile; ++j) {
            const double ahead = swept[j].place[0] - swept[i].place[0];
            if (ahead * ahead >= least) break;
            least = std::min(least, squared_offset(swept[i], swept[j]));
        }
    return std::sqrt(least);
}

double min_distance_within_tiles(const PointStrips& points, int tiles)
{
    double least = std::numeric_limits<double>::infinity();
    for (int row = 0; row < tiles; ++row) {
        stop_if_interrupted();
        const double low = row / static_cast<double>(tiles) - rounding_of_borders;
        const double high = (row + 1) / static_cast<double>(tiles) + rounding_of_borders;
        PointSet part{points.dimension(), {}};
        for (std::size_t strip = 0; strip < points.count(); ++strip) {
            const double begin = points.begin_of(strip), end = points.begin_of(strip + 1);
            const bool is_rounded = end > 1 + low; // of the last strip, some points belong to the first row
            if ((end < low || begin > high) && !is_rounded) continue;
            const PointSet more = points.strip(strip);
            part.coordinates.insert(part.coordinates.end(), more.coordinates.begin(), more.coordinates.end());
        }
        least = std::min(least, min_distance_within_tiles(part, tiles));
    }
    return least;
}

}
