// These functions stand in for regions where a program lacks them: a region in a config asks for the module.
#include "base/errors/missing_module.hpp"
#include "experiment/measuring/region_series.hpp"

namespace poissonlab {

RegionOptions read_region_options(Keys& /*keys*/, const TypedRegion& /*typed*/, const RegionMeasures& /*measures*/,
                                  const DensityChoice& /*density*/)
{
    throw MissingModule("regions");
}

std::unique_ptr<RegionSeries> make_region_series(const RegionOptions& /*options*/) { throw MissingModule("regions"); }

}
