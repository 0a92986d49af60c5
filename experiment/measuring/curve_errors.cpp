#include "experiment/measuring/curve_errors.hpp"

#include "analysis/statistics/jackknife.hpp"

namespace poissonlab {

double CurveErrors::of(const Statistic& statistic) const
{
    return error_of_ ? error_of_(curves_.front(), statistic) : jackknife_error(curves_, statistic);
}

double CurveErrors::of_squares(const Statistic& statistic) const
{
    return jackknife_error_of_squares(curves_, statistic);
}

}
