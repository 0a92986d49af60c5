// The power spectrum of a method, estimated by averaging periodograms (Bartlett).
//
// Dissertation, section 6.2.2, equations 6.1, 6.2 and 6.6.
// Scale, sign and order, fixed here for the whole project:
// - P(f) = |sum_j exp(-2 pi i f.x_j)|^2 / N on integer frequencies f: a Poisson process has mean power 1.
// - A spectrum of size M holds f in [-M/2, M/2) along each axis; f = 0 is at index M/2.
// - Row v holds frequency v - M/2 along y, column u holds u - M/2 along x; 3D: slice, then row, then column.
#pragma once

#include "analysis/spectra/half_spectrum.hpp"
#include "analysis/spectra/uninitialized_vector.hpp"
#include "base/geometry/point_set.hpp"
#include "base/points/point_strips.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace poissonlab {

// Mean and variance of many values at once, one observation of all of them after the other.

/// Welford: Note on a Method for Calculating Corrected Sums of Squares and Products, Technometrics 4(3),
/// 1962: no cancellation, one pass.
class RunningMoments
{
public:
    /// Adds an observation of each value; every call has equally many.
    void add(std::span<const double> values);

    /// Appends the observations of `other`; equal to adding them here, up to rounding. Chan, Golub and LeVeque,
    /// Algorithms for Computing the Sample Variance, The American Statistician 37(3), 1983, equations 2.1.
    void append(const RunningMoments& other);

    int count() const { return count_; }
    std::span<const double> mean() const { return mean_; }

    /// Squared deviations from the mean, summed up: the variance times count - 1. Empty for one observation.
    std::span<const double> squares() const { return squares_; }

    /// All members as bytes.
    template <class Archive>
    void serialize(Archive& archive)
    {
        archive(count_, mean_, squares_);
    }

private:
    int count_ = 0;
    UninitializedVector<double> mean_, squares_;
};

class FastPeriodogram;

/// The mean of K periodograms. K = 1, or a deterministic method: a periodogram, not an estimate.
struct Spectrum
{
    int dimension = 2;
    int size = 0;              ///< M: frequency samples along each axis, even
    std::size_t points = 0;    ///< N of each realization; of the first one where sizes vary
    int realizations = 0;      ///< K
    std::vector<double> power; ///< M^dimension values, row-major, y (then z) slowest
    /// The variance of each power between realizations (divisor K - 1), which estimates the squared error of the mean
    /// power times K. Empty for K = 1.
    std::vector<double> variance = {};
    double transform_error = 1e-11; ///< bound of the error of transform values, as a share of N
    PeriodicBox box = {};           ///< frequencies are u / a, v / b (, w / c) for its sides a, b (, c)

    double at(int fx, int fy) const
    {
        return power[static_cast<std::size_t>(fy + size / 2) * static_cast<std::size_t>(size) +
                     static_cast<std::size_t>(fx + size / 2)];
    }
};

/// The mean power of the block of a 2D spectrum whose lowest frequencies are (fx, fy), without frequency (0, 0).
double mean_power(const Spectrum& spectrum, int fx, int fy, int block);

/// A 2D spectrum's means over blocks of `block` x `block` frequencies, of which `size` must be a multiple. Has no
/// variance.
Spectrum block_means(const Spectrum& spectrum, int block);

/// The smallest power of two by which `size` may be divided so that it becomes `largest` at most, or the largest by
/// which it can be divided without a rest.
int block_for(int size, int largest);

/// Sizes beyond which the rule below does not go by itself: 8,192^2 doubles are 512 MiB, 256^3 128 MiB, and there are
/// several arrays of that size.
inline constexpr int largest_spectrum_2d = 8192;
inline constexpr int largest_spectrum_3d = 256;

/// The largest that can be asked for: 512^3 frequencies take some 7 GiB while they are made, and spectra of sets in
/// regions are made in memory for all of their frequencies at once.
inline constexpr int most_frequencies_2d = 8192, most_frequencies_3d = 512, largest_region_spectrum = 4096;

/// Files of 2D spectra that are larger hold means over blocks unless all is asked for: 16 MiB, and not 512 MiB.
inline constexpr int largest_stored_spectrum = 2048;

/// The size rule, equation 6.6 with the factor 2 that its text and numbers have: the frequencies reach twice
/// the principal frequency of a set with relative radius 0.75 on either side of zero, rounded up to a power
/// of two. 1,024 for 16,384 points in 2D, 256 for 65,536 in 3D.
///
/// The size is at most largest_spectrum_2d or _3d: the frequencies of sets of more than some 2,700,000 points in 2D, or
/// 156,000 in 3D, reach less than twice that far.
int spectrum_size(std::size_t points, int dimension);

/// The size for points in a box, whose frequencies reach as far as the rule asks along its longest side too, where they
/// are closest together; at most what is largest.
int spectrum_size(std::size_t points, int dimension, const PeriodicBox& box);

/// The size of these rules, whatever is largest. Measures that look at all frequencies, such as oscillation and
/// anisotropy, are others in a smaller spectrum: oscillation of dart throwing is 1.9 at 4 and 2.9 at 2.5 root N.
int size_asked_for(std::size_t points, int dimension, const PeriodicBox& box = {});

/// The ways to compute a periodogram.
enum class PeriodogramMethod
{
    fast, ///< FastPeriodogram: transform values within 1e-8, relative l2 error
    exact ///< exact_periodogram()
};

/// Averages periodograms in the order given; sums of floating point numbers depend on it.
///
/// Each periodogram is normalised by the number of points of its own set, so that sets whose sizes differ by
/// the nature of their method, as saturated ones do, can be averaged where `sizes_vary` says so.
class SpectrumEstimate
{
public:
    /// `size` must be even and positive; `bin_width` as for radial_statistics().
    SpectrumEstimate(int dimension, int size, bool sizes_vary = false,
                     PeriodogramMethod method = PeriodogramMethod::fast, double bin_width = 1);
    ~SpectrumEstimate();
    SpectrumEstimate(SpectrumEstimate&&) noexcept;
    SpectrumEstimate& operator=(SpectrumEstimate&&) noexcept;

    int dimension() const { return dimension_; }

    /// Points lie in this box: said before any is added.
    void lie_in(const PeriodicBox& box) { box_ = box; }

    /// Periodograms are those of points in a region: `compute` makes them.
    void compute_by(std::function<void(const PointSet& points, HalfSpectrum& periodogram)> compute)
    {
        compute_ = std::move(compute);
    }

    /// Adds the periodogram of one realization. Throws InputError when the number of points
    /// (unless sizes vary) or the dimension differs from those before, or when the set is empty.
    void add(const PointSet& points);

    /// Adds the periodogram of a set on disk, by FastPeriodogram alone. Throws InputError as above, and where the exact
    /// sum is asked for.
    void add(const PointStrips& points);

    /// Appends the realizations of `other`; equal to adding them here, up to rounding. Throws InputError as add()
    /// does.
    void append(const SpectrumEstimate& other);

    /// The mean of what was added, at least one realization.
    Spectrum mean() const;

    /// The standard error of the radially averaged power in each bin of radial_statistics() with the same width, from
    /// its spread between realizations; where they share tile sets or the like, between the `groups` to which they
    /// belong, see group_means(). No groups: each stands for itself. Empty where there is one only.
    std::vector<double> radial_errors(const std::vector<std::size_t>& groups = {}) const;

    /// The radially averaged power of each realization, in the bins of radial_statistics() one sample wide.
    const std::vector<std::vector<double>>& radial_curves() const { return radial_curves_; }

    /// The periodogram of the last realization.
    const HalfSpectrum& last_periodogram() const { return periodogram_; }

    /// The sums as bytes, which are read into an estimate that was constructed alike.
    template <class Archive>
    void serialize(Archive& archive)
    {
        archive(points_, power_, radial_curves_, wide_curves_);
    }

private:
    void check(const std::string& name, int dimension, std::size_t points);
    void compute_periodogram(const PointSet& points);
    void add_periodogram();

    int dimension_, size_;
    bool sizes_vary_;
    PeriodogramMethod method_;
    double bin_width_;
    PeriodicBox box_;
    std::size_t points_ = 0;   ///< of the first realization
    HalfSpectrum periodogram_; ///< of the last realization
    RunningMoments power_;     ///< of each frequency's power
    std::vector<std::vector<double>> radial_curves_;
    std::vector<std::vector<double>> wide_curves_; ///< in bins of bin_width; empty where that is 1
    std::unique_ptr<FastPeriodogram> fast_;
    std::function<void(const PointSet&, HalfSpectrum&)> compute_; ///< empty: by the method
};

/// The periodogram of one set on M x M (x M) integer frequencies, by the exact sum: every transform value is
/// within 1e-11 N of it (in practice 1e-14 N). Separable phases make it a product of matrices over one
/// quadrant of frequencies. Coordinates must lie in [0, 1); `size` must be even and positive, the set not
/// empty (std::invalid_argument). Any number of threads gives the same bytes; OpenBLAS is set to one thread.
std::vector<double> exact_periodogram(const PointSet& points, int size);

}
