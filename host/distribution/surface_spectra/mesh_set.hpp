// Measures points on a mesh, made here or elsewhere: their spectrum by the mesh's eigenfunctions and their distances.
// The measures decide if the points are blue noise.
#pragma once

#include "analysis/surfaces/mesh_eigenfunctions.hpp"
#include "analysis/surfaces/surface_rings.hpp"
#include "host/distribution/classes/class_names.hpp"
#include "host/distribution/surface_spectra/mesh_pairs.hpp"
#include "host/distribution/surfaces/surface_set.hpp"
#include "host/kinds/kind.hpp"
#include "results/blue_noise.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// The keys of kind = "mesh-set".
struct MeshSetSettings
{
    std::filesystem::path set; ///< empty: the points are those of the first method
    std::filesystem::path mesh;
    std::vector<std::string> methods{};  ///< of SurfaceMethod, compared with each other
    std::optional<std::size_t> points{}; ///< of methods, where there is no set
    std::uint32_t eigenfunctions = 5000;
    double normal_angle = 120;
    std::optional<double> tolerance;
    std::string classes; ///< the column or the property with the class of each point; empty: points have none
    std::shared_ptr<const SurfaceMesh> surface{};        ///< the mesh, where it was read already
    std::shared_ptr<const struct MeshWithPoints> read{}; ///< and the points
};

/// A mesh whose triangles share their corners, and points that lie on it.
struct MeshWithPoints
{
    std::shared_ptr<const SurfaceMesh> surface;
    TriangleMesh mesh;                ///< the triangles of the surface
    std::vector<SurfacePoint> points; ///< none where a method is to make them
    ClassNumbers classes;             ///< of the points, where these have some
    double tolerance = 0;             ///< the largest distance from the mesh that is accepted, in its units
    double farthest = 0;              ///< the largest distance of a point from the mesh
};

/// Reads the mesh. Throws InputError.
std::shared_ptr<const SurfaceMesh> surface_of(const MeshSetSettings& settings);

/// Makes the points of a method. Throws InputError.
std::vector<SurfacePoint> points_by_method(const std::string& method, std::size_t count,
                                           const std::shared_ptr<const SurfaceMesh>& mesh,
                                           const MeshSetSettings& settings, std::uint64_t seed);

/// Reads both, unless the settings have them; without a set, there are no points yet. Throws InputError if there are
/// fewer than two points, or if a point is farther off the mesh than the tolerance, which is a tenth of the square root
/// of the area per point by default.
std::shared_ptr<const MeshWithPoints> read_mesh_set(const MeshSetSettings& settings);

/// The measures of one set.
struct MeshSetMeasures
{
    std::vector<RadialBin> rings; ///< one wide
    double least = 0;             ///< distance of points whose normals are near enough, in units of the mesh
    double mean_nearest = 0;
    double relative_radius = 0;
    double nearest_ratio = 0; ///< mean nearest distance over that of the densest packing in the plane
    CountsOverParts counts;
    MeshPairs pairs;
    std::optional<double> low_frequency_mean, effective_nyquist, above_chance;
    BlueNoiseVerdict verdict;
};

/// Spectra end here at the latest, in units of sqrt(N / area): beyond the first peak of Poisson disk sets.
inline constexpr double farthest_spectrum = 1.6;

/// Adds the measures that follow from rings, least and mean_nearest of points on a surface of this area. `reach` is the
/// end of the spectrum in units of sqrt(N / area).
void complete_measures(MeshSetMeasures& set, std::size_t points, double area, double reach);

/// The width of rings as curves show them.
double curve_width(std::size_t points);

/// A method beside the points that are measured: as many of its points.
struct MethodSpectrum
{
    std::string name;
    MeshSetMeasures set;
    std::vector<RadialBin> curve; ///< rings as wide as curves show them
};

struct MeshSpectra
{
    double area = 0;                ///< in squares of the mesh's units
    double reach = 0;               ///< the highest frequency, in units of sqrt(N / area)
    std::size_t eigenfunctions = 0; ///< that were found
    MeshShape shape;                ///< of the mesh
    std::size_t triangles = 0;      ///< of the mesh
    std::size_t elements = 0;       ///< triangles after division
    MeshSetMeasures set, random, darts;
    std::vector<MethodSpectrum> methods;                         ///< the others
    std::vector<RadialBin> set_curve, random_curve, darts_curve; ///< rings as wide as curves show them
};

/// Measures the points, and as many random ones and as many by dart throwing to compare them with.
MeshSpectra measure_mesh_set(const MeshWithPoints& points, const MeshSetSettings& settings, std::uint64_t seed,
                             const std::function<void(const std::string& what)>& on_step);

/// Compares the set, which is called `name`, with other methods, random points and darts; `where` ends the title.
DistributionTable comparison_of(const MeshSpectra& spectra, const std::string& name, const std::string& where);

/// Returns kind = "mesh-set", which measures a file of points.
Kind mesh_set_kind();

}
