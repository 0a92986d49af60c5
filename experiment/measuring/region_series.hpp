// Measures a series of sets in a region, where measures of the torus are not defined: nearest distances, the spectrum
// and its errors, and the curves of region_curves.hpp.
//
// Standard errors of statistics of a mean radial curve.
#pragma once

#include "analysis/measures/distance_statistics.hpp"
#include "analysis/measures/pair_correlation.hpp"
#include "analysis/regions/region_curve_row.hpp"
#include "analysis/spectra/radial_statistics.hpp"
#include "analysis/spectra/spectrum.hpp"
#include "base/files/byte_archive.hpp"
#include "experiment/config/analysis_options.hpp"
#include "results/series.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace poissonlab {

class CurveErrors
{
public:
    using Statistic = std::function<double(const std::vector<double>& curve)>;

    /// Takes errors from the spread of independent curves, whose mean the curve is, by the jackknife.
    explicit CurveErrors(std::vector<std::vector<double>> curves) : curves_(std::move(curves)) {}

    /// Takes errors of one curve from a function of it and of a statistic.
    using ErrorOf = std::function<double(const std::vector<double>& curve, const Statistic& statistic)>;
    CurveErrors(std::vector<double> curve, ErrorOf error_of) : curves_{std::move(curve)}, error_of_(std::move(error_of))
    {}

    /// False for one curve, of which nothing else is known.
    bool are_known() const { return curves_.size() > 1 || error_of_; }

    double of(const Statistic& statistic) const;

    /// The error of a statistic to which the squares of deviations from a value add, so that noise adds to it as well.
    /// Only independent curves have it.
    double of_squares(const Statistic& statistic) const;

private:
    std::vector<std::vector<double>> curves_;
    ErrorOf error_of_; ///< empty: the jackknife
};

/// Points lie in the frame. A program without regions has none of these.
class RegionSeries
{
public:
    virtual ~RegionSeries() = default;

    /// The least and the mean distance of points from their nearest ones, in roots of the region's area.
    virtual NearestDistances nearest(const PointSet& points) const = 0;

    /// Prepares the estimate, whose spectrum has `size` frequencies along each axis, for periodograms of the region.
    virtual void start_spectrum(SpectrumEstimate& estimate, int size, PeriodogramMethod method) = 0;

    /// Adds a set to the estimate. With the tapers of a region, each taper counts as a set of its own.
    virtual void add_to(SpectrumEstimate& estimate, const PointSet& points) const = 0;

    /// The number of tapers of the spectrum; 0: it has none.
    virtual std::size_t tapers() const = 0;

    /// The errors of the rings of one set's mean over tapers, and those of statistics of it.
    virtual std::vector<double> ring_errors(const std::vector<RadialBin>& curve, int size, double bin_width) const = 0;
    virtual CurveErrors curve_errors(const std::vector<RadialBin>& curve, int size) const = 0;

    /// Begins curves of sets of so many points, two or more; without them there are no rows and no pair correlation.
    virtual void start_curves(std::size_t points) = 0;
    virtual void leave_out_curves() = 0;
    virtual bool has_curves() const = 0;

    // Without curves, the following functions do nothing; with curves, they do what the functions of RegionCurves do.
    virtual void add(const PointSet& points, const std::string& name) = 0;
    virtual void append(const RegionSeries& next) = 0;
    virtual std::vector<RegionCurveRow> rows() const = 0;
    virtual std::vector<PairCorrelationBin> pair_correlation(const std::vector<std::size_t>& groups) const = 0;

    /// The region, and what its curves are; without the picture.
    virtual RegionResult result() const = 0;

    /// The picture of a set, see mark_picture.hpp.
    virtual std::string picture(const PointSet& points) const = 0;

    virtual void write(ByteWriter& archive) const = 0;
    virtual void read(ByteReader& archive) = 0;
};

/// Throws MissingModule in a program without regions.
std::unique_ptr<RegionSeries> make_region_series(const RegionOptions& options);

}
