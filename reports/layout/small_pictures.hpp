// Small pictures for tables and lists of series: which there are of a series, and how they are called.
#pragma once

#include "reports/layout/report_layout.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// One small picture of a series, beside its others.
struct SmallPicture
{
    const char* kind;        ///< "spectrum", "plate", "radial" or "points"
    const char* name;        ///< for readers
    const char* file;        ///< in the series' folder
    const char* image_class; ///< how the style sheet shows it
};

/// Those that a series has, the most telling first. A series has points at least.
std::vector<SmallPicture> small_pictures(const ReportSeries& series);

}
