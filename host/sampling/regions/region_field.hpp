// The field of Gaussian blue noise in a region that fills little of its box: see
// host/sampling/optimized/gaussian_field.hpp.
//
// Cells of the field are kept where the region is, in listed cells of the grid of points. A place's Gaussian is the
// narrowest, from sigma on, that has a quarter of the points under it which it would have where the region is
// everywhere: beside a straight boundary, in right-angled corners, and in strips wider than 0.63 mean distances that is
// sigma itself; in narrower strips Gaussians reach to the points before and behind.
#pragma once

#include "base/regions/fixed_region.hpp"
#include "base/regions/region_shares.hpp"
#include "host/sampling/optimized/gaussian_field.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace poissonlab {

/// Is told the sizes of a field before the region is read for its cells. Where it returns false, the region is not
/// read: only sizes are asked for.
using FieldSizeCheck = std::function<bool(const GaussianFieldShape&)>;

class RegionField
{
public:
    /// Finds the cells for so many points; Gaussians are `sigma` mean distances wide. The region must outlive this.
    /// Throws InputError where cells are too large to know what margins leave of the region, or too many.
    RegionField(const FixedRegion& region, std::size_t points, double sigma, const FieldSizeCheck& check = {});

    GaussianFieldShape shape() const;
    GaussianField field(double step) const;

    /// The square that becomes the torus: its lowest corner and its side, in positions.
    const std::array<double, 2>& low() const { return lattice_.low; }
    double side() const { return lattice_.side * lattice_.columns; }

private:
    /// Cells of the field beside each other in a row that have equal parts of the region.
    struct Run
    {
        std::int64_t begin, end;
        double share;
    };

    /// A row with such cells.
    struct Row
    {
        std::int64_t number;
        std::size_t first; ///< of its runs
    };

    /// A width of Gaussians, in cells, and what its sums over runs are made of.
    struct Width
    {
        double squared = 1; ///< over sigma
        std::int64_t reach = 0;
        std::vector<double> taps, slopes;         ///< from -reach to reach
        std::vector<double> tap_sums, slope_sums; ///< of those before
    };

    static constexpr std::size_t cells_of_listed =
        std::size_t{contract::gaussian_blue_noise::FIELD_CELLS} * contract::gaussian_blue_noise::FIELD_CELLS;

    /// The numbers of the cells of the field in a listed one, row by row.
    using Numbers = std::array<GaussianNumbers, cells_of_listed>;

    bool list_cells(double cell);
    bool add_cells(std::uint32_t column, std::uint32_t row, std::uint32_t size,
                   std::vector<std::uint64_t>& found) const;
    double read_shares();
    double left_by_margins(const std::array<std::uint32_t, 2>& cell, double share) const;
    std::vector<Width> widths() const;
    Numbers numbers_for(std::int64_t column, std::int64_t row, const Width& width) const;
    Numbers narrowest(std::int64_t column, std::int64_t row, const std::vector<Width>& widths) const;

    const FixedRegion& region_;
    double points_, sigma_;
    double narrowest_ = 1; ///< of the widths, over sigma: a power of two
    double full_ = 1;      ///< points that the square would have if the region were everywhere
    ShareLattice lattice_; ///< the cells of the field
    CellRows listed_;
    std::vector<std::uint8_t> is_empty_; ///< the cells of the field in listed ones
    std::vector<Run> runs_;
    std::vector<Row> rows_; ///< and the end
};

}
