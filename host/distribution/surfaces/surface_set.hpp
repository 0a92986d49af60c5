// Points on the surface of a mesh: what settings ask for, and what is measured.
//
// Relative radii are those of the plane: a distance over sqrt(2 A / (sqrt(3) N)), that of the densest packing of N
// points in a plane area A. Curved surfaces can have a little more, as distances are straight through space.
#pragma once

#include "base/geometry/point_set.hpp"
#include "base/word_table.hpp"
#include "host/distribution/surfaces/surface_instances.hpp"
#include "host/distribution/surfaces/surface_view.hpp"
#include "host/kinds/distribution_place.hpp"
#include "host/sampling/surfaces/surface_darts.hpp"
#include "host/settings/distributions/quad_config.hpp"
#include "results/pictures/distribution_result.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

// The settings of [[distribution]] kind = "surface".

enum class SurfaceMethod
{
    darts,
    elimination,
    lloyd,
    gaussian,
    tiles,
    quads
};

inline constexpr WordTable<SurfaceMethod, 6> surface_methods{{{{SurfaceMethod::darts, "darts"},
                                                               {SurfaceMethod::elimination, "elimination"},
                                                               {SurfaceMethod::lloyd, "lloyd"},
                                                               {SurfaceMethod::gaussian, "gaussian"},
                                                               {SurfaceMethod::tiles, "tiles"},
                                                               {SurfaceMethod::quads, "quads"}}}};

/// The order of points: as they were made, or one whose first parts are well spread.
enum class SurfaceOrder
{
    own,
    elimination
};

inline constexpr WordTable<SurfaceOrder, 2> surface_orders{
    {{{SurfaceOrder::own, "own"}, {SurfaceOrder::elimination, "sample-elimination"}}}};

/// The measure of the distances between points.
enum class SurfaceMetric
{
    space,  ///< straight through space, between points that see each other
    surface ///< along the surface: the lengths of the shortest paths
};

inline constexpr WordTable<SurfaceMetric, 2> surface_metrics{
    {{{SurfaceMetric::space, "space"}, {SurfaceMetric::surface, "surface"}}}};

inline constexpr auto surface_metric_help = "how distances of points are measured: straight through space, or along "
                                            "the surface, where the two sides of a sheet "
                                            "and places on both sides of a gap are far apart";

/// The longest distance that can be measured along a surface, in units of its grid: squares have 62 bits.
inline constexpr double measured_units = 0x1p31 * (1 - 0x1p-20);

struct SurfaceMesh;

struct PoissonTileSet;

/// Points with which darts begin, and points from which they keep away.
struct SurfaceBeginning
{
    std::vector<SurfacePoint> start, obstacles;
    double least = 0; ///< the least distance of points of the start that see each other; infinite where none do
    std::vector<std::string> notes; ///< on files whose points lie off the surface, to which they are moved
};

/// kind = "surface": points on the triangles of a mesh, also those of tiles over its texture coordinates.
struct MeshPointSettings
{
    std::filesystem::path mesh;
    SurfaceMethod method = SurfaceMethod::darts;
    std::optional<std::size_t> points;
    std::optional<double> min_distance;
    std::optional<double> relative_radius;
    bool is_closed = false; ///< the tiling repeats after a unit
    SurfaceMetric metric = SurfaceMetric::space;
    double normal_angle = 120;
    double factor = 0.99;
    std::uint32_t candidates = 5;
    std::optional<std::uint32_t> iterations;     ///< of methods that move points; see iterations_of()
    std::filesystem::path start, obstacles;      ///< files of points; empty: there are none
    SurfaceOrder order = SurfaceOrder::own;      ///< the order of darts
    std::string density, density_from = "light"; ///< density for elimination; empty: it is uniform
    bool faces = false;          ///< files have faces, barycentric coordinates and numbers of the mesh's vertices
    SurfaceModels instances;     ///< models that glTF has instead of points
    std::filesystem::path tiles; ///< empty: corner tiles of 3 colours, 32 points
    std::optional<double> tiles_per_unit;                ///< tiles along a unit of texture coordinates
    QuadSettings quads;                                  ///< settings of method quads
    std::uint32_t colors = 1;                            ///< colours of the vertices of quads
    std::shared_ptr<const SurfaceMesh> read{};           ///< the mesh, where it was read already
    std::shared_ptr<const PoissonTileSet> read_tiles{};  ///< the tiles, where they were read already
    std::shared_ptr<const SurfaceBeginning> beginning{}; ///< start and obstacles, where they were read already
};

/// Do the points of darts move then?
inline bool moves_points(SurfaceMethod method)
{
    return method == SurfaceMethod::lloyd || method == SurfaceMethod::gaussian;
}

/// Returns the number of steps that points make.
inline std::size_t iterations_of(const MeshPointSettings& settings)
{
    return settings.iterations.value_or(settings.method == SurfaceMethod::gaussian ? 100 : 50);
}

/// A mesh, and the same in whole numbers.
struct SurfaceMesh
{
    TriangleMesh mesh;
    FixedSurface surface;

    /// Returns what a person should know of it, a line each: faces that were dropped or divided, open boundaries.
    std::vector<std::string> notes() const;
};

/// Reads the mesh, unless the settings have it. Throws InputError.
std::shared_ptr<const SurfaceMesh> surface_mesh(const MeshPointSettings& settings);

/// See host/distribution/surfaces/tiled_surface.hpp.
struct SurfaceTiling;

struct SurfaceSet
{
    std::shared_ptr<const SurfaceMesh> mesh;
    std::vector<SurfacePoint> points; ///< in the order in which they came, or of elimination
    double min_distance = 0;          ///< that they are sure to keep; 0: nothing is said
    double angle = 180;
    bool is_saturated = false;
    double small_area = 0;                         ///< see SurfaceDarts
    std::uint64_t darts = 0;                       ///< random points of which these are; 0: of tilings
    std::shared_ptr<const SurfaceTiling> tiling{}; ///< of tilings
    std::vector<DistributionNumber> of_method{};   ///< numbers that its method alone has
    bool follows_density = false;
    double dart_distance = 0; ///< that darts keep: more than min_distance where points of the start are nearer
    std::vector<SurfacePoint> obstacles{};       ///< points from which darts keep away
    std::vector<std::string> notes{};            ///< sentences on the set for users; those on its mesh are separate
    SurfaceMetric metric = SurfaceMetric::space; ///< of all its distances

    PointSet places() const { return points_of(mesh->surface, points); }
};

/// The distance that settings ask for, or that darts begin with where it shrinks. Throws InputError where the surface
/// has no room, or places too few digits, for it.
double surface_distance(const MeshPointSettings& settings, const SurfaceMesh& mesh);

/// Reads the files of start and obstacles, whose points are moved to the surface from at most a tenth of the distance
/// away. Throws InputError, also where points of the start are nearer to each other than a distance that is to be kept.
std::shared_ptr<const SurfaceBeginning> surface_beginning(const MeshPointSettings& settings, const SurfaceMesh& mesh);

/// Makes the points. Throws InputError where there is no room for as many, or no memory.
SurfaceSet make_surface_set(const MeshPointSettings& settings, std::uint64_t seed, const DistributionPlace& place);

/// Says in a few words how the set was made.
std::string surface_fact(const SurfaceSet& set, const MeshPointSettings& settings);

/// Says how pictures show its points.
SurfaceDots dots_of(const SurfaceSet& set);

/// Numbers of the set. `seed` is that of places at which it is looked whether points are near.
std::vector<DistributionNumber> surface_numbers(const SurfaceSet& set, std::uint64_t seed);

}
