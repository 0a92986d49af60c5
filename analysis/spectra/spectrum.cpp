#include "analysis/spectra/spectrum.hpp"

#include "analysis/spectra/fast_periodogram.hpp"
#include "analysis/statistics/jackknife.hpp"
#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/programs/side_by_side.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <stdexcept>

namespace poissonlab {
namespace {

/// Twice the principal frequency 1/(2r) on either side of zero: 2 / r samples, r = 0.75 rmax.
double samples_asked_for(std::size_t points, int dimension)
{
    return 2.0 / (0.75 * 0.5 * max_min_distance(points, dimension));
}

}

void RunningMoments::add(std::span<const double> values)
{
    ++count_;
    if (count_ == 1) mean_.resize(values.size());
    if (count_ == 2) squares_.resize(values.size());
    const double share = 1.0 / count_;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mean_.size(), 65536), [&](const auto& range) {
        if (count_ == 1) {
            for (std::size_t i = range.begin(); i < range.end(); ++i) mean_[i] = values[i];
            return;
        }
        if (count_ == 2) std::fill_n(squares_.begin() + range.begin(), range.size(), 0.0);
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const double difference = values[i] - mean_[i];
            mean_[i] += difference * share;
            squares_[i] += difference * (values[i] - mean_[i]);
        }
    });
}

void RunningMoments::append(const RunningMoments& other)
{
    if (other.count_ == 0) return;
    if (count_ == 0) {
        *this = other;
        return;
    }
    const bool had_squares = count_ > 1;
    const double all = count_ + other.count_;
    const double share = other.count_ / all;
    const double weight = count_ * share;
    count_ += other.count_;
    if (!had_squares) squares_.resize(mean_.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mean_.size(), 65536), [&](const auto& range) {
        if (!had_squares) std::fill_n(squares_.begin() + range.begin(), range.size(), 0.0);
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const double difference = other.mean_[i] - mean_[i];
            mean_[i] += difference * share;
            squares_[i] += difference * difference * weight;
            if (other.count_ > 1) squares_[i] += other.squares_[i];
        }
    });
}

int spectrum_size(std::size_t points, int dimension)
{
    const double samples = samples_asked_for(points, dimension);
    int size = 2;
    const int largest = dimension == 2 ? largest_spectrum_2d : largest_spectrum_3d;
    while (size < samples && size < largest) size *= 2;
    return size;
}

int spectrum_size(std::size_t points, int dimension, const PeriodicBox& box)
{
    const int of_square = spectrum_size(points, dimension),
              largest = dimension == 2 ? largest_spectrum_2d : largest_spectrum_3d;
    // Eighths of a power of two: pictures are made smaller by averages over blocks.
    const int step = std::max(2, of_square / 8);
    const double samples = samples_asked_for(points, dimension) * box.longest();
    int size = of_square;
    while (size < samples && size + step <= largest) size += step;
    return size;
}

int size_asked_for(std::size_t points, int dimension, const PeriodicBox& box)
{
    const double samples = samples_asked_for(points, dimension);
    int size = 2;
    while (size < samples) size *= 2;
    const int step = std::max(2, size / 8);
    while (size < samples * box.longest()) size += step;
    return size;
}

double mean_power(const Spectrum& spectrum, int fx, int fy, int block)
{
    double sum = 0;
    int count = 0;
    for (int y = fy; y < fy + block; ++y)
        for (int x = fx; x < fx + block; ++x)
            if (x != 0 || y != 0) {
                sum += spectrum.at(x, y);
                ++count;
            }
    return count > 0 ? sum / count : 0;
}

Spectrum block_means(const Spectrum& spectrum, int block)
{
    if (spectrum.dimension != 2 || block < 1 || spectrum.size % block != 0)
        throw std::invalid_argument("block_means: needs a 2D spectrum whose size is a multiple of the block");
    Spectrum means = spectrum;
    means.size = spectrum.size / block;
    means.variance.clear();
    means.power.clear();
    const int lowest = -spectrum.size / 2;
    for (int row = 0; row < means.size; ++row)
        for (int column = 0; column < means.size; ++column)
            means.power.push_back(mean_power(spectrum, lowest + column * block, lowest + row * block, block));
    return means;
}

int block_for(int size, int largest)
{
    int block = 1;
    while (size / block > largest && size % (2 * block) == 0) block *= 2;
    return block;
}

SpectrumEstimate::SpectrumEstimate(int dimension, int size, bool sizes_vary, PeriodogramMethod method, double bin_width)
    : dimension_(dimension), size_(size), sizes_vary_(sizes_vary), method_(method), bin_width_(bin_width)
{
    if (dimension != 2 && dimension != 3) throw std::invalid_argument("SpectrumEstimate: dimension must be 2 or 3");
    if (size <= 0 || size % 2 != 0) throw std::invalid_argument("SpectrumEstimate: size must be even and positive");
}

SpectrumEstimate::~SpectrumEstimate() = default;
SpectrumEstimate::SpectrumEstimate(SpectrumEstimate&&) noexcept = default;
SpectrumEstimate& SpectrumEstimate::operator=(SpectrumEstimate&&) noexcept = default;

void SpectrumEstimate::add(const PointSet& points)
{
    check("realization " + std::to_string(power_.count()), points.dimension, points.size());
    if (power_.count() == 0) points_ = points.size();
    compute_periodogram(points);
    add_periodogram();
}

void SpectrumEstimate::add(const PointStrips& points)
{
    check("realization " + std::to_string(power_.count()), points.dimension(), points.size());
    if (method_ == PeriodogramMethod::exact)
        throw InputError("spectrum = \"exact\": sets that are read in pieces have none; must be \"fast\" for them");
    if (power_.count() == 0) points_ = points.size();
    if (!fast_) fast_ = std::make_unique<FastPeriodogram>(dimension_, size_);
    fast_->compute(points, periodogram_);
    add_periodogram();
}

/// Adds what is in periodogram_.
void SpectrumEstimate::add_periodogram()
{
    periodogram_.box = box_;
    radial_curves_.push_back(radial_means(periodogram_));
    if (bin_width_ != 1) wide_curves_.push_back(radial_means(periodogram_, bin_width_));
    power_.add(periodogram_.power);
}

void SpectrumEstimate::check(const std::string& name, int dimension, std::size_t points)
{
    if (dimension != dimension_) {
        throw InputError(name + " has dimension " + std::to_string(dimension) + ", the spectrum " +
                         std::to_string(dimension_));
    }
    if (points == 0) throw InputError(name + " has no points");
    if (!sizes_vary_ && power_.count() > 0 && points != points_) {
        throw InputError(name + " has " + std::to_string(points) + " points where the first has " +
                         std::to_string(points_));
    }
}

void SpectrumEstimate::append(const SpectrumEstimate& other)
{
    if (other.power_.count() == 0) return;
    check("realization " + std::to_string(power_.count()), other.dimension_, other.points_);
    if (power_.count() == 0) points_ = other.points_;
    power_.append(other.power_);
    radial_curves_.insert(radial_curves_.end(), other.radial_curves_.begin(), other.radial_curves_.end());
    wide_curves_.insert(wide_curves_.end(), other.wide_curves_.begin(), other.wide_curves_.end());
}

void SpectrumEstimate::compute_periodogram(const PointSet& points)
{
    if (compute_) return compute_(points, periodogram_);
    if (method_ == PeriodogramMethod::exact) {
        periodogram_ = half_of(exact_periodogram(points, size_), dimension_, size_);
        return;
    }
    if (!fast_) fast_ = std::make_unique<FastPeriodogram>(dimension_, size_);
    fast_->compute(points, periodogram_);
}

Spectrum SpectrumEstimate::mean() const
{
    if (power_.count() == 0) throw std::logic_error("SpectrumEstimate: the mean of no realizations");
    Spectrum mean{dimension_, size_, points_, power_.count(), {}};
    do_side_by_side([&] { mean.power = all_frequencies(power_.mean(), dimension_, size_); },
                    [&] {
                        if (power_.count() == 1) return;
                        mean.variance =
                            all_frequencies(power_.squares(), dimension_, size_, 1.0 / (power_.count() - 1));
                    });
    mean.box = box_;
    if (method_ == PeriodogramMethod::fast) mean.transform_error = FastPeriodogram::default_tolerance;
    return mean;
}

std::vector<double> SpectrumEstimate::radial_errors(const std::vector<std::size_t>& groups) const
{
    return errors_of_mean(bin_width_ == 1 ? radial_curves_ : wide_curves_, groups);
}

}
