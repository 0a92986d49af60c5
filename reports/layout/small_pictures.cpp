#include "reports/layout/small_pictures.hpp"

namespace poissonlab {

std::vector<SmallPicture> small_pictures(const ReportSeries& series)
{
    std::vector<SmallPicture> result;
    if (!series.stored->spectrum_file.empty())
        result.push_back({"spectrum", "Spectrum", "spectrum-thumbnail.png", "framed"});
    if (series.stored->zone_plate) result.push_back({"plate", "Zone plate", "zone-plate-thumbnail.png", "framed"});
    if (series.stored->has_spectrum())
        result.push_back({"radial", "Radial power", "radial-thumbnail.svg", "ink framed"});
    result.push_back({"points", "Points", "points-thumbnail.png", "ink framed"});
    return result;
}

}
