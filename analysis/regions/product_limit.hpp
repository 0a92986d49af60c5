// The distribution function of lengths of which some are known to be at least so long only: the product-limit estimator
// (Kaplan, Meier, Nonparametric estimation from incomplete observations, Journal of the American Statistical
// Association 53, 1958). Distances of points in a region are such lengths: beyond the boundary there may have been a
// nearer one (Baddeley, Gill, Kaplan-Meier estimators of distance distributions for spatial point processes, Annals of
// Statistics 25(1), 1997).
#pragma once

#include <vector>

namespace poissonlab {

/// A length, and the length up to which it can be seen.
struct CensoredLength
{
    double length = 0;
    double seen = 0;
};

/// The share of lengths up to `step`, 2 `step`, ..., `count` of these. Beyond the last length that is seen it stays as
/// it is.
std::vector<double> product_limit(std::vector<CensoredLength> lengths, double step, std::size_t count);

}
