// Points spread with a compact kernel onto a periodic grid of which two lines at a time exist.
#pragma once

#include "analysis/spectra/spreading_kernel.hpp"
#include "analysis/spectra/uninitialized_vector.hpp"
#include "base/geometry/point_set.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// Grid points have indices (z, y, x), x fastest; a line has all indices x. A line is summed up by one
/// thread, over its points in a fixed order: the division of lines among threads changes nothing.
///
/// Kernels take some 30 numbers a point. They exist for a band of slices at a time, as wide as the memory for them
/// allows; a slice is a line in 2D, and the lines of one z in 3D.
class PointSpreading
{
public:
    /// `grid`: grid points along each axis, even, at least twice the kernel's width.
    PointSpreading(int dimension, std::size_t grid, const SpreadingKernel& kernel);

    /// Coordinates in [0, 1). The points must stay there while lines are filled.
    void set_points(const PointSet& points);

    /// Returns the end of the band that begins with slice `first`: whole blocks of `block` slices, one at least, whose
    /// kernels take at most so many bytes, unless one block alone takes more.
    std::size_t band_end(std::size_t first, std::size_t block, std::size_t bytes) const;

    /// Makes the kernels of the points that touch slices first .. end - 1, which can be filled from then on.
    void make_band(std::size_t first, std::size_t end);

    /// Lines y, even, and y + 1, the one in the real parts and the other in the imaginary parts of `lines`:
    /// both in one go, as points of one touch the other, and as one complex transform does for both. `lines`:
    /// 2 line_size() numbers. False, and nothing in `lines`, where no point touches the lines. z: 0 in 2D.
    bool fill_lines(std::size_t y, std::size_t z, double* lines) const;

    /// Room for the grid points of a line and for those beyond its end, which fill_lines() adds to its
    /// beginning.
    std::size_t line_size() const { return grid_ + SpreadingKernel::max_width; }

private:
    /// Points, sorted by the first line along x that they touch ("bin"), and in a bin in the order of the set.
    struct Points
    {
        std::vector<std::size_t> starts;  ///< of each bin, y fastest; one more than there are bins
        std::vector<std::uint32_t> first; ///< the first grid point along x that a point of the band touches
        /// Each point's values of the kernel along x, along y between two zeros, and along z: value_count() numbers.
        UninitializedVector<double> values;
    };

    /// Points in their order, from the first on, and where the band has them.
    struct Run
    {
        std::size_t begin = 0, end = 0, place = 0;
    };
    using AddBins = void (*)(const Points&, std::size_t begin, std::size_t end, std::size_t shift, std::size_t along_y,
                             std::size_t along_z, double* lines);
    template <int width, int dimension>
    static void add_bins(const Points& points, std::size_t begin, std::size_t end, std::size_t shift,
                         std::size_t along_y, std::size_t along_z, double* lines);
    template <int dimension, int width = SpreadingKernel::max_width>
    static AddBins add_bins_for(int wanted);

    std::size_t first_of(double x, double& offset) const;
    void sort_into_bins(const PointSet& points);
    void set_values(std::size_t p, std::size_t place);
    std::array<Run, 2> runs_of(std::size_t first, std::size_t end) const;
    std::size_t slice_start(std::size_t slice) const { return points_.starts[slice * (dimension_ == 2 ? 1 : grid_)]; }
    std::size_t width() const { return static_cast<std::size_t>(kernel_.width()); }
    std::size_t value_count() const { return static_cast<std::size_t>(dimension_) * width() + 2; }

    int dimension_;
    std::size_t grid_;
    SpreadingKernel kernel_;
    AddBins add_bins_;
    const PointSet* set_ = nullptr;
    Points points_;
    std::array<Run, 2> band_;                 ///< the points of a band around the border of the torus are two runs
    std::vector<std::uint32_t> bins_, order_; ///< of a point in the set; points of the set in order
    std::vector<std::size_t> next_;           ///< free place of each bin
};

}
