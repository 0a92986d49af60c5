// Densities that classes of points follow in a region, as shares of cells.
#pragma once

#include "base/errors/errors.hpp"
#include "base/regions/distance_field.hpp"
#include "base/regions/fixed_region.hpp"
#include "host/sampling/classes/class_darts.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace poissonlab {

struct ClassDensity
{
    OpenCells cells;     ///< those in which the density is not 0, with their shares
    double fullness = 1; ///< the mean density in the region over the largest one
};

/// A text is no density of a class, or none in its region.
class DensityError : public InputError
{
public:
    using InputError::InputError;
};

/// A number at each place of a region, in its units.
using DensityAt = DistanceAt;

/// Cells that meet a region, and the part of each that lies in it.
struct RegionCells
{
    OpenCells cells;
    std::vector<double> shares;
};

/// Returns `least` cells or more, a 512th of the longest side of the region's grid wide at most.
RegionCells density_cells(const FixedRegion& region, std::size_t least);

/// Reads a density in the cells of a region: each has the mean of four places. Throws InputError, a line that begins
/// with `name`, where a density is negative or no number, and where it is 0 everywhere.
ClassDensity class_density(const FixedRegion& region, const RegionCells& cells, const DensityAt& density,
                           const std::string& name);

/// Returns the largest difference between the share that a sixteenth of a density, in the order of its cells, has of
/// some points, and a sixteenth.
double density_error(const OpenCells& density, const PointSet& points);

}
