// Points spread with a compact kernel onto a periodic grid of which two lines at a time exist.
#pragma once

#include "analysis/spectra/spreading_kernel.hpp"
#include "analysis/spectra/uninitialized_vector.hpp"
#include "base/geometry/point_set.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// Grid points have indices (z, y, x), x fastest; a line has all indices x. A line is summed up by one
/// thread, over its points in a fixed order: the division of lines among threads changes nothing.
class PointSpreading
{
public:
    /// `grid`: grid points along each axis, even, at least twice the kernel's width.
    PointSpreading(int dimension, std::size_t grid, const SpreadingKernel& kernel);

    /// Coordinates in [0, 1).
    void set_points(const PointSet& points);

    /// Lines y, even, and y + 1, the one in the real parts and the other in the imaginary parts of `lines`:
    /// both in one go, as points of one touch the other, and as one complex transform does for both. `lines`:
    /// 2 line_size() numbers. False, and nothing in `lines`, where no point touches the lines. z: 0 in 2D.
    bool fill_lines(std::size_t y, std::size_t z, double* lines) const;

    /// Room for the grid points of a line and for those beyond its end, which fill_lines() adds to its
    /// beginning.
    std::size_t line_size() const { return grid_ + SpreadingKernel::max_width; }

private:
    /// Sorted by the first line along x that they touch ("bin"), in a bin in the order of the set.
    struct Points
    {
        std::vector<std::size_t> starts;  ///< of each bin, y fastest; one more than there are bins
        std::vector<std::uint32_t> first; ///< the first grid point along x that a point touches
        /// A point's kernel along x, along y between two zeros, and along z: value_count() numbers.
        UninitializedVector<double> values;
    };
    using AddBins = void (*)(const Points&, std::size_t begin, std::size_t end, std::size_t along_y,
                             std::size_t along_z, double* lines);
    template <int width, int dimension>
    static void add_bins(const Points& points, std::size_t begin, std::size_t end, std::size_t along_y,
                         std::size_t along_z, double* lines);
    template <int dimension, int width = SpreadingKernel::max_width>
    static AddBins add_bins_for(int wanted);

    std::size_t first_of(double x, double& offset) const;
    void sort_into_bins(const PointSet& points);
    void set_values(const PointSet& points, std::size_t p);
    std::size_t width() const { return static_cast<std::size_t>(kernel_.width()); }
    std::size_t value_count() const { return static_cast<std::size_t>(dimension_) * width() + 2; }

    int dimension_;
    std::size_t grid_;
    SpreadingKernel kernel_;
    AddBins add_bins_;
    Points points_;
    std::vector<std::uint32_t> bins_, order_; ///< of a point in the set; points of the set in order
    std::vector<std::size_t> next_;           ///< free place of each bin
};

}
