// How the work is divided. Grid points have indices (z, y, x), x fastest; a "line" along an axis has all others fixed.
//   1. each line along x is filled by all points that touch it, transformed, and cut to the frequencies 0 .. M/2;
//   2. each line along y is transformed (3D: and cut to -M/2 .. M/2); then each along z.
// The grid itself is never stored, only the lines' transforms. A line is summed up by one thread, over its points in a
// fixed order, so the division among threads changes nothing.
#include "analysis/fast_periodogram.hpp"

#include "analysis/spreading_kernel.hpp"

#include <fftw3.h>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <new>
#include <numbers>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace poissonlab {
namespace {

using Complex = std::complex<double>;

/// Grid points per frequency sample. Less than the usual 2: transforms take most of the time, and a wider kernel, which
/// less oversampling needs, is cheap; less so in 3D.
double oversampling(int dimension) { return dimension == 2 ? 1.25 : 1.5; }

/// Columns that are transformed together, and lines along x that are filled one after the other.
constexpr std::size_t block = 8;

template <typename T>
struct FftwDelete
{
    void operator()(T* memory) const { fftw_free(memory); }
};

/// Memory as FFTW likes it aligned.
template <typename T>
class Aligned
{
public:
    explicit Aligned(std::size_t size) : memory_(static_cast<T*>(fftw_malloc(size * sizeof(T))))
    {
        if (!memory_) throw std::bad_alloc();
        std::uninitialized_value_construct_n(memory_.get(), size);
    }
    T* data() { return memory_.get(); }
    T& operator[](std::size_t i) { return memory_.get()[i]; }

private:
    std::unique_ptr<T, FftwDelete<T>> memory_;
};

fftw_complex* fftw(Complex* values) { return reinterpret_cast<fftw_complex*>(values); }

struct PlanDelete
{
    void operator()(fftw_plan plan) const { fftw_destroy_plan(plan); }
};
using FftwPlan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, PlanDelete>;

/// The smallest even size of at least `least` without other prime factors than 2, 3 and 5.
std::size_t transform_size(double least)
{
    for (auto size = static_cast<std::size_t>(std::ceil(least));; ++size) {
        std::size_t rest = size;
        for (const std::size_t factor : {2, 3, 5}) {
            while (rest % factor == 0) rest /= factor;
        }
        if (rest == 1 && size % 2 == 0) return size;
    }
}

/// The narrowest kernel with this error: exp(-pi width sqrt(1 - 1 / oversampling)), times a factor that covers clusters, in 3D.
int kernel_width(double tolerance, int dimension)
{
    for (int width = SpreadingKernel::min_width; width <= SpreadingKernel::max_width; width += 2) {
        const double error = 10 * std::exp(-std::numbers::pi * width * std::sqrt(1 - 1 / oversampling(dimension)));
        if (error <= tolerance) return width;
    }
    throw std::invalid_argument("FastPeriodogram: no kernel is as accurate as the tolerance asks for");
}

/// Points, sorted by the first line along x that they touch ("bin"), in a bin in the order of the set.
struct SpreadPoints
{
    std::vector<std::size_t> starts;  ///< of each bin, y fastest; one more than there are bins
    std::vector<std::uint32_t> first; ///< the first grid point along x that a point touches
    std::vector<double> values;       ///< a point's kernel along x, then y, then z: dimension * width values
};

/// Adds the points of bins begin .. end - 1 to a line. `along_y`: how many lines behind its first one the line is, for
/// the points of bin `begin`; one less for each bin that follows. `along_z` likewise, the same for all, in 3D.
template <int width, int dimension>
void add_bins(const SpreadPoints& spread, std::size_t begin, std::size_t end, std::size_t along_y, std::size_t along_z,
              double* line)
{
    for (std::size_t bin = begin; bin < end; ++bin, --along_y) {
        for (std::size_t p = spread.starts[bin]; p < spread.starts[bin + 1]; ++p) {
            const double* values = spread.values.data() + p * (dimension * width);
            double weight = values[width + along_y];
            if constexpr (dimension == 3) weight *= values[2 * width + along_z];
            double* target = line + spread.first[p];
            for (int i = 0; i < width; ++i) target[i] += weight * values[i];
        }
    }
}

using AddBins = decltype(&add_bins<4, 2>);

/// add_bins for a width known at run time: loops of known length are several times faster.
template <int dimension, int width = SpreadingKernel::max_width>
AddBins add_bins_for(int wanted)
{
    if constexpr (width > SpreadingKernel::min_width) {
        if (wanted < width) return add_bins_for<dimension, width - 2>(wanted);
    }
    return add_bins<width, dimension>;
}

}

class FastPeriodogram::Plan
{
public:
    Plan(int dimension, int size, double tolerance);

    void compute(const PointSet& points, HalfSpectrum& half);

private:
    /// What a thread works in, kept from line to line.
    struct Workspace
    {
        explicit Workspace(std::size_t grid)
            : line(grid + SpreadingKernel::max_width), transformed(grid / 2 + 1), columns(block * grid)
        {}
        Aligned<double> line;
        Aligned<Complex> transformed; ///< of the line
        Aligned<Complex> columns;     ///< `block` lines along y or z, side by side
    };

    void make_plans();
    void spread(const PointSet& points);
    bool fill_line(std::size_t y, std::size_t z, double* line) const;
    void transform_along_x();
    template <typename Store>
    void transform_columns(Complex* first, std::size_t step, const Store& store);
    /// The place of frequency number `row`, -M/2 + row, in a transform.
    std::size_t in_transform(std::size_t row) const { return row < size_ / 2 ? grid_ + row - size_ / 2 : row - size_ / 2; }

    int dimension_;
    std::size_t size_;
    std::size_t grid_;    ///< grid points along each axis
    std::size_t columns_; ///< frequencies 0 .. M/2 along x
    SpreadingKernel kernel_;
    AddBins add_bins_;
    std::vector<double> deconvolution_; ///< one over the kernel's squared transform, at frequencies 0 .. M/2
    SpreadPoints spread_;
    Aligned<Complex> transforms_;       ///< a row of `columns_` for each line along x
    FftwPlan line_plan_, column_plan_;
    tbb::enumerable_thread_specific<Workspace> workspaces_;
};

FastPeriodogram::Plan::Plan(int dimension, int size, double tolerance)
    : dimension_(dimension), size_(static_cast<std::size_t>(size)),
      grid_(transform_size(std::max(oversampling(dimension) * size, 2.0 * SpreadingKernel::max_width))), columns_(size_ / 2 + 1),
      kernel_(kernel_width(tolerance, dimension), static_cast<double>(grid_) / size),
      add_bins_(dimension == 2 ? add_bins_for<2>(kernel_.width()) : add_bins_for<3>(kernel_.width())),
      transforms_((dimension == 2 ? grid_ : grid_ * grid_) * columns_), workspaces_([this] { return Workspace(grid_); })
{
    for (std::size_t f = 0; f < columns_; ++f) {
        const double transform = kernel_.transform(static_cast<double>(f) / static_cast<double>(grid_));
        deconvolution_.push_back(1 / (transform * transform));
    }
    make_plans();
}

/// Estimated plans are the same on every run. Measured ones are chosen by timing.
void FastPeriodogram::Plan::make_plans()
{
    Workspace& work = workspaces_.local();
    const int grid = static_cast<int>(grid_);
    line_plan_.reset(
        fftw_plan_dft_r2c_1d(grid, work.line.data(), fftw(work.transformed.data()), FFTW_ESTIMATE));
    column_plan_.reset(fftw_plan_many_dft(1, &grid, block, fftw(work.columns.data()), nullptr, block, 1,
                                          fftw(work.columns.data()), nullptr, block, 1, FFTW_FORWARD, FFTW_ESTIMATE));
    if (!line_plan_ || !column_plan_) throw std::runtime_error("FFTW has no plan for " + std::to_string(grid));
}

void FastPeriodogram::Plan::spread(const PointSet& points)
{
    const std::size_t n = points.size();
    const std::size_t width = static_cast<std::size_t>(kernel_.width());
    const auto dimension = static_cast<std::size_t>(dimension_);
    // The grid point that a kernel touches first, and how far it is behind the kernel's left end.
    const auto first_of = [&](double x, double& offset) {
        const double left = x * static_cast<double>(grid_) - static_cast<double>(width) / 2;
        const double first = std::ceil(left);
        offset = first - left;
        return static_cast<std::size_t>(first < 0 ? first + static_cast<double>(grid_) : first) % grid_;
    };
    double unused;
    std::vector<std::size_t> bins(n);
    for (std::size_t i = 0; i < n; ++i) {
        bins[i] = first_of(points[i][1], unused);
        if (dimension == 3) bins[i] += grid_ * first_of(points[i][2], unused);
    }

    std::vector<std::size_t>& starts = spread_.starts;
    starts.assign((dimension == 2 ? grid_ : grid_ * grid_) + 1, 0);
    for (const std::size_t bin : bins) ++starts[bin + 1];
    for (std::size_t bin = 1; bin < starts.size(); ++bin) starts[bin] += starts[bin - 1];
    std::vector<std::size_t> next(starts.begin(), starts.end() - 1);
    std::vector<std::size_t> order(n);
    for (std::size_t i = 0; i < n; ++i) order[next[bins[i]]++] = i;

    spread_.first.resize(n);
    spread_.values.resize(n * dimension * width);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, 1024), [&](const auto& range) {
        for (std::size_t p = range.begin(); p < range.end(); ++p) {
            for (std::size_t k = 0; k < dimension; ++k) {
                double offset;
                const std::size_t first = first_of(points[order[p]][k], offset);
                if (k == 0) spread_.first[p] = static_cast<std::uint32_t>(first);
                kernel_.values(offset, spread_.values.data() + (p * dimension + k) * width);
            }
        }
    });
}

/// False where no point touches it.
bool FastPeriodogram::Plan::fill_line(std::size_t y, std::size_t z, double* line) const
{
    const auto width = static_cast<std::size_t>(kernel_.width());
    std::fill_n(line, grid_ + width, 0.0);
    bool is_touched = false;
    const auto add = [&](std::size_t begin, std::size_t end, std::size_t along_y, std::size_t along_z) {
        if (spread_.starts[begin] == spread_.starts[end]) return;
        is_touched = true;
        add_bins_(spread_, begin, end, along_y, along_z, line);
    };
    for (std::size_t along_z = 0; along_z < (dimension_ == 3 ? width : 1); ++along_z) {
        // Bins y - width + 1 .. y; those below 0 are at the end of the row of bins.
        const std::size_t row = (z + grid_ - along_z) % grid_ * grid_ * (dimension_ == 3 ? 1 : 0);
        const std::size_t below = y + 1 < width ? width - 1 - y : 0;
        if (below > 0) add(row + grid_ - below, row + grid_, width - 1, along_z);
        add(row + y + 1 - (width - below), row + y + 1, width - 1 - below, along_z);
    }
    for (std::size_t i = 0; i < width; ++i) line[i] += line[grid_ + i];
    return is_touched;
}

void FastPeriodogram::Plan::transform_along_x()
{
    const std::size_t lines = dimension_ == 2 ? grid_ : grid_ * grid_;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, lines, block), [&](const auto& range) {
        Workspace& work = workspaces_.local();
        for (std::size_t line = range.begin(); line < range.end(); ++line) {
            Complex* const target = transforms_.data() + line * columns_;
            if (!fill_line(line % grid_, line / grid_, work.line.data())) {
                std::fill_n(target, columns_, Complex{});
                continue;
            }
            fftw_execute_dft_r2c(line_plan_.get(), work.line.data(), fftw(work.transformed.data()));
            std::copy_n(work.transformed.data(), columns_, target);
        }
    });
}

/// Transforms columns of values that are `step` apart, the first in a row from `first` on, and calls
/// store(column, row, value) for all their frequencies -M/2 .. M/2.
template <typename Store>
void FastPeriodogram::Plan::transform_columns(Complex* first, std::size_t step, const Store& store)
{
    tbb::parallel_for(std::size_t{0}, (columns_ + block - 1) / block, [&](std::size_t b) {
        const std::size_t begin = b * block, count = std::min(block, columns_ - begin);
        Aligned<Complex>& columns = workspaces_.local().columns;
        for (std::size_t i = 0; i < grid_; ++i) std::copy_n(first + i * step + begin, count, &columns[i * block]);
        fftw_execute_dft(column_plan_.get(), fftw(columns.data()), fftw(columns.data()));
        for (std::size_t row = 0; row <= size_; ++row) {
            const Complex* values = &columns[in_transform(row) * block];
            for (std::size_t k = 0; k < count; ++k) store(begin + k, row, values[k]);
        }
    });
}

void FastPeriodogram::Plan::compute(const PointSet& points, HalfSpectrum& half)
{
    if (points.dimension != dimension_ || points.size() == 0)
        throw std::invalid_argument("FastPeriodogram: no points, or of another dimension");
    spread(points);
    transform_along_x();

    half.dimension = dimension_;
    half.size = static_cast<int>(size_);
    const std::size_t rows = half.rows();
    half.power.resize(columns_ * rows * half.slices());
    const auto deconvolution = [&](std::size_t row) {
        return deconvolution_[row < size_ / 2 ? size_ / 2 - row : row - size_ / 2];
    };
    const double scale = 1 / static_cast<double>(points.size());
    if (dimension_ == 2) {
        transform_columns(transforms_.data(), columns_, [&](std::size_t u, std::size_t row, Complex value) {
            half.power[row * columns_ + u] = std::norm(value) * (deconvolution_[u] * deconvolution(row) * scale);
        });
        return;
    }
    const std::size_t slice = grid_ * columns_;
    tbb::parallel_for(std::size_t{0}, grid_, [&](std::size_t z) {
        Complex* const first = transforms_.data() + z * slice;
        transform_columns(first, columns_, [&](std::size_t u, std::size_t row, Complex value) {
            first[row * columns_ + u] = value; // rows in order of frequencies from now on
        });
    });
    tbb::parallel_for(std::size_t{0}, rows, [&](std::size_t v) {
        transform_columns(transforms_.data() + v * columns_, slice, [&](std::size_t u, std::size_t row, Complex value) {
            half.power[(row * rows + v) * columns_ + u] =
                std::norm(value) * (deconvolution_[u] * deconvolution(v) * deconvolution(row) * scale);
        });
    });
}

FastPeriodogram::FastPeriodogram(int dimension, int size, double tolerance)
{
    if (dimension != 2 && dimension != 3) throw std::invalid_argument("FastPeriodogram: dimension must be 2 or 3");
    if (size <= 0 || size % 2 != 0)
        throw std::invalid_argument("FastPeriodogram: size must be even and positive");
    plan_ = std::make_unique<Plan>(dimension, size, tolerance);
}

FastPeriodogram::~FastPeriodogram() = default;
FastPeriodogram::FastPeriodogram(FastPeriodogram&&) noexcept = default;
FastPeriodogram& FastPeriodogram::operator=(FastPeriodogram&&) noexcept = default;

HalfSpectrum FastPeriodogram::compute(const PointSet& points)
{
    HalfSpectrum half;
    plan_->compute(points, half);
    return half;
}

void FastPeriodogram::compute(const PointSet& points, HalfSpectrum& result) { plan_->compute(points, result); }

}
