// These functions stand in for regions where a program lacks them: a region in a config asks for the module.
#include "base/errors/missing_module.hpp"
#include "base/regions/region_text.hpp"
#include "base/regions/region_words.hpp"
#include "base/regions/solid_lattice.hpp"

namespace poissonlab {

bool is_region_text(std::string_view /*text*/) { throw MissingModule("regions"); }

PlaneRegion read_region(const std::string& /*text*/, const RegionReading& /*reading*/)
{
    throw MissingModule("regions");
}

void check_map_system(const std::string& /*name*/) { throw MissingModule("regions"); }

SolidLattice inset_solid(const SolidLattice& /*solid*/, double /*distance*/, const std::string& /*name*/)
{
    throw MissingModule("regions");
}

}
