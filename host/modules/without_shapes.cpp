// These functions stand in for the shapes of regions where a program has neither regions nor tiles. None is called
// before a region is read, which asks for the module.
#include "analysis/regions/framed_region.hpp"
#include "base/errors/missing_module.hpp"
#include "base/regions/fixed_space.hpp"
#include "base/regions/region_source.hpp"

namespace poissonlab {

std::string degrees_sentence(const PlaneRegion& /*region*/) { throw MissingModule("regions"); }

const std::vector<std::string>& notes_of(const PlaneRegion& /*region*/) { throw MissingModule("regions"); }

PointSet FramedRegion::framed(const PointSet& /*points*/, const std::string& /*name*/) const
{
    throw MissingModule("regions");
}

bool FixedRegion::contains(const TorusPoint<2>& /*position*/, bool /*has_margins*/) const
{
    throw MissingModule("regions");
}

RegionSide FixedRegion::side_of(const FixedBox& /*box*/) const { throw MissingModule("regions"); }

bool FixedSpace::contains(const TorusPoint<3>& /*position*/) const { throw MissingModule("regions"); }

RegionSide FixedSpace::side_of(const FixedSpaceBox& /*box*/) const { throw MissingModule("regions"); }

}
