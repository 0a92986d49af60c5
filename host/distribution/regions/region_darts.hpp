// Dart throwing in a region of the plane, in the region's own units.
//
// The region lies on a quarter of the unit torus (see base/regions/fixed_region.hpp), and so do the darts, which dart
// throwing drops where they fall outside: the law is that of darts that are thrown into the region alone, which has no
// neighbours beyond its boundary.
//
// Obstacles that are polygons are taken out of the region. Besides, points keep away from edges of polygons, from lines
// and from points, wherever these lie, by margins of the region's grid.
#pragma once

#include "base/geometry/point_set.hpp"
#include "base/regions/fixed_region.hpp"
#include "base/regions/fixed_space.hpp"
#include "base/regions/obstacles.hpp"
#include "base/regions/region_source.hpp"
#include "host/kinds/distribution_place.hpp"
#include "host/sampling/dart_throwing.hpp"
#include "host/settings/distributions/distribution_config.hpp"
#include "results/pictures/distribution_result.hpp"

#include <memory>

namespace poissonlab {

/// A region as it is read, and what obstacles leave of it.
struct RegionLand
{
    PlaneRegion whole;
    Obstacles obstacles;
    PlaneRegion rest; ///< without polygons among the obstacles
};

/// Reads both, unless the settings have them. Throws InputError, also where nothing is left or the distance from
/// obstacles is too large.
std::shared_ptr<const RegionLand> region_land(const DartSettings& settings);

/// Points keep so far away from obstacles, in units of the region: from lines and edges of polygons, and from points.
struct ObstacleDistances
{
    double lines = 0;
    double points = 0;
};

ObstacleDistances obstacle_distances(const DartSettings& settings, double min_distance);

/// The request for points, in units of the torus and in those of the region.
struct RegionDartRequest
{
    std::shared_ptr<const RegionLand> land;
    std::vector<TorusPoint<2>> on_boundary; ///< points that are there first
    std::size_t near_obstacles = 0; ///< lines, edges of polygons and points that are near enough to matter, nearly
    KeptAway kept;                  ///< what the region keeps away from besides its boundary
    std::shared_ptr<const FixedRegion> region;
    double min_distance = 0; ///< in the region's units
    DartThrowingRequest darts;
};

/// See host/distribution/regions/varied_points.hpp.
struct VariedSet;

struct RegionDarts
{
    RegionDartRequest request;
    PointSet points;           ///< in the region's units, in dart order
    bool is_saturated = false; ///< no further point fits
    double sure_distance = 0;  ///< that any two points have at least, in the region's units; 0: nothing is said
    std::shared_ptr<const VariedSet> varied{}; ///< where the distance varies
    std::shared_ptr<const FixedSpace> space{}; ///< the region where it is one of space: see space_points.hpp
    double length = 0; ///< of the lines that points lie on, without obstacles; 0: they lie in a region
    std::vector<std::string>
        features{}; ///< of points on lines: the id of each one's feature, as JSON, if there are any

    /// The points as files have them: in longitude and latitude where the region was mapped from there.
    PointSet file_points() const { return request.land ? as_in_files(request.land->whole, points) : points; }

    /// Returns sentences on what was made of the files of region and obstacles, and on obstacles that do not matter.
    std::vector<std::string> notes() const;

    std::size_t obstacle_count() const { return request.land ? request.land->obstacles.count() : 0; }
};

/// Checks that the distance suits the region. Throws InputError. Realizations of one seed are independent sets.
RegionDartRequest region_dart_request(const DartSettings& settings, std::uint64_t seed,
                                      std::shared_ptr<const RegionLand> land, std::uint32_t realization = 0);

/// Throws the darts. The distances of points, computed from their coordinates, are never below the one that was asked
/// for. Throws InputError where there is no room for as many points as are asked for, or no memory.
RegionDarts throw_region_darts(const DartSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                               std::uint32_t realization = 0);

/// The numbers of points in a region: results have them, and commands print them with --json.
DistributionNumbers dart_numbers(const RegionDarts& darts);

/// A point set in the region's fixed-point coordinates, in its units.
PointSet in_units_of(const FixedRegion& region, const PointSet& fixed);

/// Throws InputError, which says that there is no room for a single point.
[[noreturn]] void fail_without_room(const RegionDartRequest& request, const DartSettings& settings);

}
