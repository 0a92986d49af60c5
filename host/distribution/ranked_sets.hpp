// Sets with ranks that densities are painted with, square tiles or an aperiodic monotile: points of a rectangle, each
// with the density above which it is there.
#pragma once

#include "tiles/poisson/monotile_points_file.hpp"
#include "tiles/poisson/poisson_tile_set.hpp"

#include <cstdint>
#include <filesystem>
#include <variant>
#include <vector>

namespace poissonlab {

struct LeveledPoint
{
    double x = 0;
    double y = 0;
    double level = 0;
};

class RankedSet
{
public:
    /// Reads a tile set file. Throws InputError where it has no ranks or is of tiles in space.
    explicit RankedSet(const std::filesystem::path& file);

    double density() const;         ///< the number of points per unit of area, in tiles or edges
    double relative_radius() const; ///< the one that the file promises

    /// Returns all points of the rectangle from (0, 0), of the tiling or at the place that the seed chooses. Throws
    /// InputError for rectangles that are too long.
    std::vector<LeveledPoint> points(double width, double height, std::uint64_t seed) const;

private:
    std::variant<PoissonTileSet, MonotilePointsFile> set_;
};

}
