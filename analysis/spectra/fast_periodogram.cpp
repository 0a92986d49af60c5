// The work is divided into lines. Grid points have indices (z, y, x), x fastest; a "line" along an axis has all
// others fixed.
//   1. lines along x are filled by all points that touch them, transformed, and cut to u = 0 .. M/2;
//   2. for each u, lines along y are transformed (3D: and cut to -M/2 .. M/2); then those along z.
// The grid itself is never stored, only the lines' transforms, those of each u together. Every line is
// transformed from consecutive numbers to consecutive numbers: FFTW's estimates of which plan is fast are far
// off for others.
#include "analysis/spectra/fast_periodogram.hpp"

#include "analysis/spectra/fftw_plan.hpp"
#include "analysis/spectra/point_spreading.hpp"
#include "analysis/spectra/uninitialized_vector.hpp"
#include "base/programs/interrupt.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <string>

namespace poissonlab {
namespace {

using Complex = std::complex<double>;

/// Grid points per frequency sample. Less than the usual 2: transforms take most of the time, and a wider
/// kernel, which less oversampling needs, is cheap; less so in 3D.
double oversampling(int dimension) { return dimension == 2 ? 1.25 : 1.5; }

constexpr std::size_t block = transposed_lines;

/// Complex numbers without values: threads touch first what they work on. (std::complex sets itself to zero.)
class Numbers
{
public:
    explicit Numbers(std::size_t size) : parts_(2 * size) {}
    Complex* data() { return reinterpret_cast<Complex*>(parts_.data()); }

private:
    UninitializedVector<double> parts_;
};

/// The narrowest kernel with this error: exp(-pi width sqrt(1 - 1 / oversampling)), times a factor that
/// covers clusters, in 3D.
int kernel_width(double tolerance, int dimension)
{
    for (int width = SpreadingKernel::min_width; width <= SpreadingKernel::max_width; width += 2) {
        const double error = 10 * std::exp(-std::numbers::pi * width * std::sqrt(1 - 1 / oversampling(dimension)));
        if (error <= tolerance) return width;
    }
    throw std::invalid_argument("FastPeriodogram: no kernel is as accurate as the tolerance asks for");
}

}

class FastPeriodogram::Plan
{
public:
    Plan(int dimension, int size, double tolerance, std::size_t band_bytes);

    void compute(const PointSet& points, HalfSpectrum& half);
    void compute(const PointStrips& points, HalfSpectrum& half);

private:
    /// The memory in which a thread works, kept from line to line.
    struct Workspace
    {
        explicit Workspace(const Plan& plan)
            : line(plan.spreading_.line_size()), lines(block * plan.line_),
              plane(plan.dimension_ == 3 ? (plan.size_ + 1) * plan.line_ : 0)
        {}
        Numbers line, lines;
        Numbers plane; ///< lines along z of one u
    };

    void transform(Complex* from, Complex* to) { fftw_execute_dft(plan_.get(), fftw(from), fftw(to)); }
    void check(int dimension, std::size_t points) const;
    void transform_along_x(std::size_t first, std::size_t last);
    void finish(std::size_t points, HalfSpectrum& half);
    void transform_band(std::size_t first, std::size_t end);
    void transform_pair(std::size_t y, std::size_t z, Workspace& work, Complex* result);
    void separate_pairs(const Complex* lines, std::size_t pairs, Complex* target) const;
    void transform_along_y(Complex* plane, Workspace& work);
    void store_power(const Complex* line, double factor, double* power) const;

    int dimension_;
    std::size_t band_bytes_;
    std::size_t size_;
    std::size_t grid_;    ///< grid points along each axis
    std::size_t line_;    ///< from one line to the next
    std::size_t plane_;   ///< from one frequency u to the next: a line, in 3D `grid_` lines
    std::size_t columns_; ///< frequencies 0 .. M/2 along x
    SpreadingKernel kernel_;
    PointSpreading spreading_;
    std::vector<double> deconvolution_; ///< one over the kernel's squared transform, at -M/2 .. M/2
    Numbers transforms_;                ///< [u][y] or [u][z][y]
    tbb::enumerable_thread_specific<Workspace> workspaces_;
    FftwPlan plan_;
};

FastPeriodogram::Plan::Plan(int dimension, int size, double tolerance, std::size_t band_bytes)
    : dimension_(dimension), band_bytes_(band_bytes), size_(static_cast<std::size_t>(size)),
      grid_(transform_size(std::max(oversampling(dimension) * size, 2.0 * SpreadingKernel::max_width))),
      line_(padded_line(grid_ + 1)), plane_(dimension == 2 ? line_ : line_ * grid_), columns_(size_ / 2 + 1),
      kernel_(kernel_width(tolerance, dimension), static_cast<double>(grid_) / size),
      spreading_(dimension, grid_, kernel_), transforms_(columns_ * plane_),
      workspaces_([this] { return Workspace(*this); })
{
    deconvolution_.resize(size_ + 1);
    for (std::size_t f = 0; f < columns_; ++f) {
        const double transform = kernel_.transform(static_cast<double>(f) / static_cast<double>(grid_));
        deconvolution_[size_ / 2 - f] = deconvolution_[size_ / 2 + f] = 1 / (transform * transform);
    }
    // An estimated plan is the same on every run. Measured ones are chosen by timing.
    Workspace& work = workspaces_.local();
    plan_ = make_fftw_plan(fftw_plan_dft_1d, static_cast<int>(grid_), fftw(work.line.data()), fftw(work.lines.data()),
                           FFTW_FORWARD, FFTW_ESTIMATE);
    if (!plan_) throw std::runtime_error("FFTW has no plan for " + std::to_string(grid_));
}

/// Lines y and y + 1 as the real and imaginary parts of one line.
void FastPeriodogram::Plan::transform_pair(std::size_t y, std::size_t z, Workspace& work, Complex* result)
{
    if (!spreading_.fill_lines(y, z, reinterpret_cast<double*>(work.line.data()))) {
        std::fill_n(result, grid_ + 1, Complex{});
        return;
    }
    transform(work.line.data(), result);
    result[grid_] = result[0]; // frequency 0 is its own negative
}

/// Twice the transforms of 2 * pairs lines, each u's in a row, from those of pairs: of a real line, that of
/// -u is the conjugate of that of u. Each u's are far from the next ones': without being asked for ahead they
/// keep the loop waiting.
void FastPeriodogram::Plan::separate_pairs(const Complex* lines, std::size_t pairs, Complex* target) const
{
    constexpr std::size_t ahead = 16;
    for (std::size_t u = 0; u < columns_; ++u) {
        const std::size_t later = std::min(u + ahead, columns_ - 1) * plane_;
        for (std::size_t i = 0; i < block; i += block / 2) __builtin_prefetch(target + later + i, 1);
        for (std::size_t pair = 0; pair < pairs; ++pair) {
            const Complex a = lines[pair * line_ + u], b = lines[pair * line_ + grid_ - u];
            target[u * plane_ + 2 * pair] = {a.real() + b.real(), a.imag() - b.imag()};
            target[u * plane_ + 2 * pair + 1] = {a.imag() + b.imag(), b.real() - a.real()};
        }
    }
}

/// Lines y in 2D, and the lines of slices z in 3D.
void FastPeriodogram::Plan::transform_band(std::size_t first, std::size_t end)
{
    spreading_.make_band(first, end);
    const std::size_t blocks = (grid_ + block - 1) / block; // of lines y
    const std::size_t begin = dimension_ == 2 ? first / block : first * blocks;
    const std::size_t last = dimension_ == 2 ? (end + block - 1) / block : end * blocks;
    tbb::parallel_for(begin, last, [&](std::size_t b) {
        Workspace& work = workspaces_.local();
        const std::size_t z = b / blocks, y = b % blocks * block;
        const std::size_t pairs = std::min(block, grid_ - y) / 2;
        for (std::size_t pair = 0; pair < pairs; ++pair) {
            transform_pair(y + 2 * pair, z, work, work.lines.data() + pair * line_);
        }
        separate_pairs(work.lines.data(), pairs, transforms_.data() + z * line_ + y);
    });
}

/// Slices first .. last - 1, whole blocks of them or up to the last one of all.
void FastPeriodogram::Plan::transform_along_x(std::size_t first, std::size_t last)
{
    while (first < last) {
        const std::size_t end = std::min(last, spreading_.band_end(first, dimension_ == 2 ? block : 1, band_bytes_));
        transform_band(first, end);
        first = end;
    }
}

/// The lines along y of one u, in 3D; each cut to -M/2 .. M/2, they become lines along z in work.plane.
void FastPeriodogram::Plan::transform_along_y(Complex* plane, Workspace& work)
{
    for (std::size_t begin = 0; begin < grid_; begin += block) {
        const std::size_t count = std::min(block, grid_ - begin);
        for (std::size_t i = 0; i < count; ++i) {
            transform(plane + (begin + i) * line_, work.lines.data() + i * line_);
        }
        for (std::size_t v = 0; v <= size_; ++v) {
            const std::size_t from = v < size_ / 2 ? grid_ + v - size_ / 2 : v - size_ / 2;
            Complex* const target = work.plane.data() + v * line_ + begin;
            for (std::size_t i = 0; i < count; ++i) target[i] = work.lines.data()[i * line_ + from];
        }
    }
}

/// Frequencies -M/2 .. M/2 of a transformed line.
void FastPeriodogram::Plan::store_power(const Complex* line, double factor, double* power) const
{
    const auto store = [&](std::size_t begin, std::size_t count, const Complex* values) {
        for (std::size_t i = 0; i < count; ++i) {
            const double real = values[i].real(), imaginary = values[i].imag();
            power[begin + i] = (real * real + imaginary * imaginary) * (factor * deconvolution_[begin + i]);
        }
    };
    store(0, size_ / 2, line + grid_ - size_ / 2);
    store(size_ / 2, columns_, line);
}

void FastPeriodogram::Plan::check(int dimension, std::size_t points) const
{
    if (dimension != dimension_ || points == 0)
        throw std::invalid_argument("FastPeriodogram: no points, or of another dimension");
}

void FastPeriodogram::Plan::compute(const PointSet& points, HalfSpectrum& half)
{
    check(points.dimension, points.size());
    spreading_.set_points(points);
    transform_along_x(0, grid_);
    finish(points.size(), half);
}

void FastPeriodogram::Plan::compute(const PointStrips& points, HalfSpectrum& half)
{
    check(points.dimension(), points.size());
    const auto first_slice = [&](std::size_t strip) {
        const auto slice = static_cast<std::size_t>(points.begin_of(strip) * static_cast<double>(grid_));
        return strip == points.count() ? grid_ : slice / block * block;
    };
    // Slices of a strip begin up to a block before it, and a kernel reaches over half its width.
    const double margin = static_cast<double>(block + SpreadingKernel::max_width) / static_cast<double>(grid_);
    PointSet part;
    for (std::size_t strip = 0; strip < points.count(); ++strip) {
        stop_if_interrupted();
        part = points.strip(strip);
        points.append_around(strip, std::min(1.0, margin), std::min(1.0, margin), false, part);
        spreading_.set_points(part);
        transform_along_x(first_slice(strip), first_slice(strip + 1));
    }
    finish(points.size(), half);
}

/// Powers from lines that were transformed along x.
void FastPeriodogram::Plan::finish(std::size_t points, HalfSpectrum& half)
{
    half.dimension = dimension_;
    half.size = static_cast<int>(size_);
    const std::size_t rows = half.rows();
    half.power.resize(columns_ * half.lines() * rows);
    const double scale = 0.25 / static_cast<double>(points); // 0.25: see separate_pairs()
    tbb::parallel_for(std::size_t{0}, columns_, [&](std::size_t u) {
        Workspace& work = workspaces_.local();
        Complex* const plane = transforms_.data() + u * plane_;
        const double factor = scale * deconvolution_[size_ / 2 + u];
        if (dimension_ == 2) {
            // Copying first is faster: memory far away comes faster in its own order than in that of a transform.
            std::copy_n(plane, grid_, work.lines.data());
            transform(work.lines.data(), work.line.data());
            store_power(work.line.data(), factor, half.power.data() + u * rows);
            return;
        }
        transform_along_y(plane, work);
        for (std::size_t v = 0; v < rows; ++v) {
            transform(work.plane.data() + v * line_, work.line.data());
            store_power(work.line.data(), factor * deconvolution_[v], half.power.data() + (u * rows + v) * rows);
        }
    });
}

FastPeriodogram::FastPeriodogram(int dimension, int size, double tolerance, std::size_t band_bytes)
{
    if (dimension != 2 && dimension != 3) throw std::invalid_argument("FastPeriodogram: dimension must be 2 or 3");
    if (size <= 0 || size % 2 != 0) throw std::invalid_argument("FastPeriodogram: size must be even and positive");
    plan_ = std::make_unique<Plan>(dimension, size, tolerance, band_bytes);
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

void FastPeriodogram::compute(const PointStrips& points, HalfSpectrum& result) { plan_->compute(points, result); }

}
