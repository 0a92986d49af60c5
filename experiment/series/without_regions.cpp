// These functions stand in for regions where a program lacks them: a region in a config asks for the module.
#include "base/errors/missing_module.hpp"
#include "experiment/measuring/region_series.hpp"
#include "experiment/series/region_points.hpp"

namespace poissonlab {

/// No config has been read that has a region.
std::vector<std::string> region_notes(const Experiment& /*experiment*/) { return {}; }

Experiment import_region_points(const std::vector<std::filesystem::path>& /*files*/, const std::string& /*label*/,
                                const FramedRegion& /*region*/, const PointReading& /*how*/)
{
    throw MissingModule("regions");
}

RegionOptions read_region_options(Keys& /*keys*/, const TypedRegion& /*typed*/, const RegionMeasures& /*measures*/,
                                  const DensityChoice& /*density*/)
{
    throw MissingModule("regions");
}

std::unique_ptr<RegionSeries> make_region_series(const RegionOptions& /*options*/) { throw MissingModule("regions"); }

}
