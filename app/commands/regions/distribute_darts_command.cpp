// poissonlab distribute darts: points in a region of the plane, in its own units.
#include "app/commands/kind_options.hpp"
#include "app/commands/regions/region_outputs.hpp"
#include "base/errors/errors.hpp"
#include "host/distribution/regions/region_darts.hpp"
#include "host/kinds/kinds.hpp"

namespace poissonlab {
namespace {

constexpr auto distribute_darts_notes =
    R"help(Darts are thrown into a region until there are --points of them, or until no further one fits: then every place of
the region is nearer than --min-distance to a point. Coordinates and distances are in the region's own units. Points may
lie on the boundary; with --boundary disks whole disks of half the distance around points are inside, as trees want it, and
with --boundary on the boundary is sampled first. --min-distance may vary: a formula in the region's x and y, or a picture over its box
with --distance-range for black and white; with --points it is a shape, scaled until so many have room. --distances FILE
writes the distance at each point. A region is
  FILE                         GeoJSON (Polygon, MultiPolygon, Feature, FeatureCollection), or WKT
  "rectangle X0 Y0 X1 Y1"      from the lowest corner to the highest
  "disk X Y RADIUS"            a polygon of 1,024 corners on the circle
  "POLYGON ((...))"            WKT, also MULTIPOLYGON
  PICTURE                      its pixels that are brighter than half, squares of side 1
  "formula X0 Y0 X1 Y1 EXPR"   where an expression in x and y is above 0 in a rectangle
  "path M..."                  the data of a path of SVG; "path evenodd tolerance 0.1 M..." says how it is filled and
                               how far curves may be from their lines (1e-4 of the extent)
or, of space, where points have x, y and z,
  "box X0 Y0 Z0 X1 Y1 Z1", "ball X Y Z RADIUS", a closed mesh (.obj, .ply, .off, .stl, .gltf, .glb),
  "solid X0 Y0 Z0 X1 Y1 Z1 EXPR"   where an expression in x, y and z is above 0 in a box
Longitude and latitude, which GeoJSON without a crs has by its standard, are mapped to a plane of metres around the
region, and points are written in them; --crs EPSG:4326 says so of other files, --planar that coordinates are lengths.
Polygons that overlap or share edges become their union. --buffer 2 makes a region of what lies within 2 of lines,
points and polygons. With --along points lie on its lines, and on the outlines of its polygons, at distances straight
through the plane.
Points keep away from --obstacles, which may lie anywhere and overlap: points, lines and polygons of GeoJSON or WKT, and
points of CSV, NPY and other point files. They are never in polygons, and nearer than --obstacle-distance to none: by
default than --min-distance to points.
  poissonlab distribute darts --region park.geojson --min-distance 4 --boundary disks --out trees.csv --out trees.geojson
  poissonlab distribute darts --region "rectangle 0 0 210 297" --points 2000 --out page.txt
  poissonlab distribute darts --region roads.geojson --along --min-distance 25 --out lamps.geojson
  poissonlab distribute darts --region "ball 0 0 0 10" --min-distance 1 --boundary disks --out grains.ply
  poissonlab distribute darts --region park.wkt --obstacles trees.wkt --min-distance 4 --out new.csv
  poissonlab distribute darts --region "rectangle 0 0 1 1" --min-distance "0.01+0.02*x" --out dots.svg --out dots.npy)help";

void throw_darts(const RegionOptions& o)
{
    const KindSettings read = o.settings();
    const auto& settings = read.as<DartSettings>();
    o.outs.check(o.command(), settings.varies());
    o.finish(throw_region_darts(settings, o.seed(), o.place()));
}

}

Command distribute_darts_command()
{
    const auto o = std::make_shared<RegionOptions>(*find_kind("distribution", "darts"));
    return kind_command(o, o->outs.options(), distribute_darts_notes, throw_darts);
}

}
