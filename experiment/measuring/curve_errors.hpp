// Standard errors of statistics of a mean radial curve.
#pragma once

#include "analysis/regions/taper_covariance.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace poissonlab {

class CurveErrors
{
public:
    using Statistic = std::function<double(const std::vector<double>& curve)>;

    /// Takes errors from the spread of independent curves, whose mean the curve is, by the jackknife.
    explicit CurveErrors(std::vector<std::vector<double>> curves) : curves_(std::move(curves)) {}

    /// Takes errors from the covariance of the rings of one set's mean over tapers.
    CurveErrors(std::vector<double> curve, RingCovariance covariance)
        : curves_{std::move(curve)}, covariance_(std::move(covariance))
    {}

    /// False for one curve, of which nothing else is known.
    bool are_known() const { return curves_.size() > 1 || covariance_; }

    double of(const Statistic& statistic) const;

    /// The error of a statistic to which the squares of deviations from a value add, so that noise adds to it as well.
    /// Only independent curves have it.
    double of_squares(const Statistic& statistic) const;

private:
    std::vector<std::vector<double>> curves_;
    std::optional<RingCovariance> covariance_;
};

}
