#include "analysis/spectra/point_spreading.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace poissonlab {

/// Adds the points of bins begin .. end - 1 to two lines. `shift`: from a point's number to its place in the band,
/// modulo 2^64. `along_y`: how many lines behind its first one the
/// second line is, for the points of bin `begin`; one less for each bin that follows. `along_z` likewise, the
/// same for all, in 3D.
template <int width, int dimension>
void PointSpreading::add_bins(const Points& points, std::size_t begin, std::size_t end, std::size_t shift,
                              std::size_t along_y, std::size_t along_z, double* lines)
{
    for (std::size_t bin = begin; bin < end; ++bin, --along_y) {
        for (std::size_t p = points.starts[bin] + shift; p != points.starts[bin + 1] + shift; ++p) {
            const double* __restrict values = points.values.data() + p * (dimension * width + 2);
            double real = values[width + along_y], imaginary = values[width + 1 + along_y];
            if constexpr (dimension == 3) {
                real *= values[2 * width + 2 + along_z];
                imaginary *= values[2 * width + 2 + along_z];
            }
            double* __restrict target = lines + 2 * points.first[p];
            for (int i = 0; i < width; ++i) {
                target[2 * i] += real * values[i];
                target[2 * i + 1] += imaginary * values[i];
            }
        }
    }
}

/// add_bins for a width known at run time: loops of known length are several times faster.
template <int dimension, int width>
PointSpreading::AddBins PointSpreading::add_bins_for(int wanted)
{
    if constexpr (width > SpreadingKernel::min_width) {
        if (wanted < width) return add_bins_for<dimension, width - 2>(wanted);
    }
    return add_bins<width, dimension>;
}

PointSpreading::PointSpreading(int dimension, std::size_t grid, const SpreadingKernel& kernel)
    : dimension_(dimension), grid_(grid), kernel_(kernel),
      add_bins_(dimension == 2 ? add_bins_for<2>(kernel.width()) : add_bins_for<3>(kernel.width()))
{}

/// The grid point that a kernel touches first, and how far it is behind the kernel's left end.
std::size_t PointSpreading::first_of(double x, double& offset) const
{
    const double left = x * static_cast<double>(grid_) - static_cast<double>(kernel_.width()) / 2;
    auto first = static_cast<std::int64_t>(left); // std::ceil is a function call
    if (static_cast<double>(first) < left) ++first;
    offset = static_cast<double>(first) - left;
    return static_cast<std::size_t>(first < 0 ? first + static_cast<std::int64_t>(grid_) : first);
}

void PointSpreading::sort_into_bins(const PointSet& points)
{
    const std::size_t n = points.size();
    double unused;
    bins_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        bins_[i] = static_cast<std::uint32_t>(first_of(points[i][1], unused));
        if (dimension_ == 3) bins_[i] += static_cast<std::uint32_t>(grid_ * first_of(points[i][2], unused));
    }
    std::vector<std::size_t>& starts = points_.starts;
    starts.assign((dimension_ == 2 ? grid_ : grid_ * grid_) + 1, 0);
    for (const std::size_t bin : bins_) ++starts[bin + 1];
    for (std::size_t bin = 1; bin < starts.size(); ++bin) starts[bin] += starts[bin - 1];
    next_.assign(starts.begin(), starts.end() - 1);
    order_.resize(n);
    for (std::size_t i = 0; i < n; ++i) order_[next_[bins_[i]]++] = static_cast<std::uint32_t>(i);
}

void PointSpreading::set_values(std::size_t p, std::size_t place)
{
    const auto point = (*set_)[order_[p]];
    double* values = points_.values.data() + place * value_count();
    double offset;
    points_.first[place] = static_cast<std::uint32_t>(first_of(point[0], offset));
    kernel_.values(offset, values);
    values += width();
    first_of(point[1], offset);
    values[0] = values[width() + 1] = 0;
    kernel_.values(offset, values + 1);
    if (dimension_ == 2) return;
    first_of(point[2], offset);
    kernel_.values(offset, values + width() + 2);
}

void PointSpreading::set_points(const PointSet& points)
{
    set_ = &points;
    sort_into_bins(points);
}

/// Points that touch slices first .. end - 1 begin at most width - 1 slices before: behind the border of the torus,
/// where that is below 0.
std::array<PointSpreading::Run, 2> PointSpreading::runs_of(std::size_t first, std::size_t end) const
{
    const std::size_t before = width() - 1, all = slice_start(grid_);
    if (first >= before) return {Run{slice_start(first - before), slice_start(end), 0}, Run{}};
    const std::size_t behind = grid_ - (before - first);
    if (behind <= end) return {Run{0, all, 0}, Run{}};
    const Run low{0, slice_start(end), 0};
    return {low, Run{slice_start(behind), all, low.end}};
}

std::size_t PointSpreading::band_end(std::size_t first, std::size_t block, std::size_t bytes) const
{
    const auto bytes_to = [&](std::size_t end) {
        const auto [a, b] = runs_of(first, end);
        return (a.end - a.begin + b.end - b.begin) * value_count() * sizeof(double);
    };
    std::size_t end = std::min(first + block, grid_);
    while (end < grid_ && bytes_to(std::min(end + block, grid_)) <= bytes) end = std::min(end + block, grid_);
    return end;
}

void PointSpreading::make_band(std::size_t first, std::size_t end)
{
    band_ = runs_of(first, end);
    const std::size_t count = band_[0].end - band_[0].begin + band_[1].end - band_[1].begin;
    points_.first.resize(count);
    points_.values.resize(count * value_count());
    for (const Run& run : band_)
        tbb::parallel_for(tbb::blocked_range<std::size_t>(run.begin, run.end, 1024), [&](const auto& range) {
            for (std::size_t p = range.begin(); p < range.end(); ++p) set_values(p, p - run.begin + run.place);
        });
}

bool PointSpreading::fill_lines(std::size_t y, std::size_t z, double* lines) const
{
    bool is_touched = false;
    const auto add = [&](std::size_t begin, std::size_t end, std::size_t along_y, std::size_t along_z) {
        const std::size_t from = points_.starts[begin];
        if (from == points_.starts[end]) return;
        const Run& run = band_[1].end > band_[1].begin && from >= band_[1].begin ? band_[1] : band_[0];
        if (!is_touched) std::fill_n(lines, 2 * (grid_ + width()), 0.0);
        is_touched = true;
        add_bins_(points_, begin, end, run.place - run.begin, along_y, along_z, lines);
    };
    for (std::size_t along_z = 0; along_z < (dimension_ == 3 ? width() : 1); ++along_z) {
        // Bins y - width + 1 .. y + 1; those below 0 are at the end of the row of bins.
        const std::size_t row = (z + grid_ - along_z) % grid_ * grid_ * (dimension_ == 3 ? 1 : 0);
        const std::size_t below = y + 1 < width() ? width() - 1 - y : 0;
        if (below > 0) add(row + grid_ - below, row + grid_, width(), along_z);
        add(row + y + 1 + below - width(), row + y + 2, width() - below, along_z);
    }
    for (std::size_t i = 0; is_touched && i < 2 * width(); ++i) lines[i] += lines[2 * grid_ + i];
    return is_touched;
}

}
