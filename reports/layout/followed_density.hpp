// Series whose points follow a density.
#pragma once

#include "reports/layout/report_layout.hpp"

namespace poissonlab {

/// True where points follow a density that is not the same everywhere: their distances, their spectrum and their
/// directions are those of the density, and say nothing of how even they are.
bool follows_density(const ReportSeries& series);

}
