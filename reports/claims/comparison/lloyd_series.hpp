// The series of a report that are made by Lloyd relaxation.
#pragma once

#include "reports/claims/claim_series.hpp"

namespace poissonlab {

/// Lloyd series from dart throwing, without repulsion afterwards.
std::vector<const ReportSeries*> lloyd_of_darts(const ClaimSeries& report, SeriesQuery::Needs needs, int dimension = 2);

}
