// Models that stand on the points of a surface, upright along its normals, in glTF.
#pragma once

#include "host/distribution/surfaces/surface_files.hpp"
#include "host/settings/keys/keys.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// The keys `instances` and `instance_scale`.
struct SurfaceModels
{
    std::vector<std::string> names;   ///< files of meshes, or `cone`: one for all points, or one of each class
    std::optional<double> scale;      ///< none: see write_surface_instances()
    std::vector<TriangleMesh> read{}; ///< of each name

    bool are_given() const { return !names.empty(); }
};

/// Visits the keys, of at most so many classes.
void surface_model_keys(Keys& keys, SurfaceModels& models, std::size_t most_models);

/// Reads the models. Throws InputError for what is no mesh, and where they are neither one nor one of each class.
void read_surface_models(const Keys& keys, SurfaceModels& models, std::size_t classes);

/// Throws InputError for a key that asks for more instances than glTF has: before points are made.
void check_instance_count(const Keys& keys, const std::string& key, const SurfaceModels& models, double points);

/// Ids are floats, which hold whole numbers up to that many exactly.
inline constexpr std::size_t most_surface_instances = std::size_t{1} << 24;

/// Writes glTF with a node for each class (or one node for points without classes) that repeats its model at each
/// point. The model's y axis lies along the normal of the point's triangle, around which the model is turned by an
/// angle that follows from the seed and the number of the point. All copies of a class have one scale: without
/// `models.scale` that at which the model is as far from its y axis as 0.35 of the mean spacing of the N points of its
/// class, sqrt(area / N). Then copies do not overlap on flat ground where points have a relative radius of
/// 0.7 / sqrt(2 / sqrt 3) = 0.652 or more. Throws StorageError, and InputError for more than most_surface_instances
/// points.
void write_surface_instances(const std::filesystem::path& file, const FixedSurface& surface,
                             const std::vector<SurfacePoint>& points, const SurfaceClasses& classes,
                             const SurfaceModels& models, std::uint64_t seed);

/// Throws InputError where models are given, but no file of `outs` is glTF.
void check_instance_files(const SurfaceModels& models, const std::vector<std::filesystem::path>& outs);

}
