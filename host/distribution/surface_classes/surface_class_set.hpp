// Points of several classes on the triangles of a mesh: what settings ask for, and what is measured.
//
// Wei, Multi-class blue noise sampling, SIGGRAPH 2010; see host/sampling/surfaces/class_surface_darts.hpp.
#pragma once

#include "base/errors/errors.hpp"
#include "host/distribution/classes/class_points.hpp"
#include "host/distribution/surfaces/surface_pairs.hpp"
#include "host/distribution/surfaces/surface_set.hpp"
#include "host/sampling/surfaces/class_surface_darts.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace poissonlab {

/// kind = "surface-classes". Lists have a value for each class.
struct SurfaceClassSettings
{
    std::filesystem::path mesh;
    ClassSettings classes; ///< points, distances, matrix, relative_radius, factor and densities
    double normal_angle = 120;
    SurfaceMetric metric = SurfaceMetric::space; ///< by which distances are measured
    bool faces = false;      ///< files have faces, barycentric coordinates and numbers of the mesh's vertices
    SurfaceModels instances; ///< models that glTF has instead of points
    std::shared_ptr<const SurfaceMesh> read{}; ///< the mesh, where it was read already
};

/// Reads the mesh, unless the settings have it. Throws InputError.
std::shared_ptr<const SurfaceMesh> surface_class_mesh(const SurfaceClassSettings& settings);

/// The mesh, the distances and the request that darts are thrown for.
struct SurfaceClassWork
{
    std::shared_ptr<const SurfaceMesh> mesh;
    ClassSurfaceRequest request;
};

/// A text is no density of a class on the mesh.
class SurfaceDensityError : public InputError
{
public:
    using InputError::InputError;
};

/// Prepares a set. Throws InputError if the mesh has no room for the distances, and SurfaceDensityError.
SurfaceClassWork surface_class_work(const SurfaceClassSettings& settings, std::uint64_t seed);

struct SurfaceClassSet
{
    SurfaceClassWork work;
    SurfaceMetric metric = SurfaceMetric::space;
    ClassSurfaceDarts darts{};

    ClassDistances kept() const { return work.request.distances.scaled(darts.scale); }
    const FixedSurface& surface() const { return work.mesh->surface; }
};

/// Throws the darts. Throws InputError where a class is full before it has the points that are asked for, or they need
/// more memory than there is.
SurfaceClassSet throw_surface_classes(const SurfaceClassSettings& settings, std::uint64_t seed,
                                      const DistributionPlace& place);

/// Says how pictures show its points.
SurfaceDots dots_of(const SurfaceClassSet& set);

/// Measures all pairs of classes. Throws std::logic_error where one is nearer than it may be.
std::vector<SurfacePair> pairs_of(const SurfaceClassSet& set);

/// The numbers of all classes, of each, and of each pair.
std::vector<DistributionNumber> surface_class_numbers(const SurfaceClassSet& set,
                                                      const std::vector<SurfacePair>& pairs);

/// Returns "0", "1", ...
std::vector<std::string> class_numbers_as_names(const SurfaceClassSet& set);

}
