// Small pictures for tables and lists of series: which there are of a series, and how they are called.
#pragma once

#include "reports/layout/report_layout.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// One small picture of a series, beside its others.
struct SmallPicture
{
    std::string kind; ///< as in Thumbnail
    std::string name;
    std::string file;        ///< in the series' folder
    std::string image_class; ///< how the style sheet shows it
};

/// The small pictures of a series, the most telling first. Every series has at least that of its points.
std::vector<SmallPicture> small_pictures(const ReportSeries& series);

}
