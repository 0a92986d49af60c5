// These functions stand in for the zone plate where a program lacks it: a run that samples it asks for the module.
#include "base/errors/missing_module.hpp"
#include "experiment/measuring/zone_plate_analysis.hpp"

namespace poissonlab {

void need_zone_plate() { throw MissingModule("zone_plate"); }

void ZonePlateAnalysis::add(const PointSet& /*points*/) { throw MissingModule("zone_plate"); }

void ZonePlateAnalysis::append(const ZonePlateAnalysis& /*other*/) { throw MissingModule("zone_plate"); }

std::vector<ErrorBin> ZonePlateError::curve() const { throw MissingModule("zone_plate"); }

ZonePlateResult ZonePlateAnalysis::result() const { throw MissingModule("zone_plate"); }

}
