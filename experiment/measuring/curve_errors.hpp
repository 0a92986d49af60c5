// Standard errors of statistics of a mean radial curve.
#pragma once

#include <functional>
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

}
