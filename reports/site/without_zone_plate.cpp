// These functions stand in for pictures of the zone plate where a program lacks them: results that have some ask for
// the module.
#include "analysis/zone_plate/zone_plate_reference.hpp"
#include "base/errors/missing_module.hpp"
#include "reports/claims/claim_series.hpp"
#include "reports/images/zone_plate_image.hpp"
#include "reports/layout/series_panels.hpp"

#include <algorithm>

namespace poissonlab {

SquareImage zone_plate_reference(int /*size*/) { throw MissingModule("zone_plate"); }

GreyImage draw_zone_plate(const SquareImage& /*image*/) { throw MissingModule("zone_plate"); }

Plot zone_plate_plot(const std::vector<ZonePlateCurve>& /*curves*/) { throw MissingModule("zone_plate"); }

void add_zone_plate_panels(const ReportRun& run, std::size_t index, const RunPlots& /*plots*/,
                           std::vector<Panel>& /*panels*/)
{
    if (run.series[index].stored->zone_plate) throw MissingModule("zone_plate");
}

std::map<const ReportSeries*, ClaimSeries::Rings> rings_in_plates(const std::vector<const ReportSeries*>& series)
{
    if (std::ranges::any_of(series, [](const ReportSeries* one) { return one->stored->zone_plate.has_value(); }))
        throw MissingModule("zone_plate");
    return {};
}

}
