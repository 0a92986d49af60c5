// poissonlab distribute points: points in a region of the plane by several methods, in its own units.
#include "app/commands/kind_options.hpp"
#include "app/commands/regions/region_outputs.hpp"
#include "base/errors/errors.hpp"
#include "host/distribution/regions/region_points.hpp"
#include "host/kinds/kinds.hpp"

namespace poissonlab {
namespace {

constexpr auto distribute_points_notes =
    R"help(Regions and obstacles are those of distribute darts. --method is one of
  darts         the same as distribute darts: --points, --min-distance, or both
  relaxation    --points by darts whose radius is reduced where they keep failing: the file says the distance that all
                points have at least; every prefix is well spread
  elimination   --points of --candidates times as many random points, in an order whose every prefix is well spread;
                neighbours that the boundary cuts off are made up for
  lloyd         --points moved to the centroids of their cells in the region, --iterations times
  gaussian      --points that Gaussians of a mean distance push apart, from darts on, --iterations times, and that the
                region itself attracts, so that none crowd at the boundary
  bridson       darts around points, until none finds room at --min-distance
Elimination, Lloyd's method and gaussian promise no distance; --json and reports have the one that was found.
--min-distance may vary for darts, relaxation and elimination: a formula in the region's x and y, or a picture over its
box with --distance-range for black and white. Two points keep the smaller of their distances or, with --between mean,
the mean of both, which is proven of all pairs afterwards. With --points it is a shape, scaled until so many have room.
  poissonlab distribute points --region park.geojson --method elimination --points 500 --out trees.csv
  poissonlab distribute points --region "disk 0 0 1" --method lloyd --points 1000 --iterations 100 --out disk.npy
  poissonlab distribute points --region "disk 0 0 1" --method relaxation --points 2000 --min-distance "1+4*(x*x+y*y)" \
      --between mean --out disks.svg --out disks.csv --distances diameters.npy)help";

void make_points_of_region(const RegionOptions& o)
{
    const KindSettings read = o.settings();
    const auto& settings = read.as<RegionPointSettings>();
    o.outs.check(o.command(), settings.place.varies());
    o.finish(make_region_points(settings, o.seed(), o.place()));
}

}

Command distribute_points_command()
{
    const auto o = std::make_shared<RegionOptions>(*find_kind("distribution", "points"));
    return kind_command(o, o->outs.options(), distribute_points_notes, make_points_of_region);
}

}
