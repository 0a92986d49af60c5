// These functions stand in for points in regions where a program lacks them: a region asks for the module when it is
// read.
#include "base/errors/missing_module.hpp"
#include "experiment/series/region_points.hpp"

namespace poissonlab {

/// No config has been read that has a region.
std::vector<std::string> region_notes(const Experiment& /*experiment*/) { return {}; }

Experiment import_region_points(const std::vector<std::filesystem::path>& /*files*/, const std::string& /*label*/,
                                const FramedRegion& /*region*/, const PointReading& /*how*/)
{
    throw MissingModule("regions");
}

}
