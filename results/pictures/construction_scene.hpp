// The scene of a picture of the construction of Poisson tiles, panel by panel: regions and points. It is stored as
// construction.json, see docs/output-folder.md; reports draw it.
#pragma once

#include "tiles/poisson/region_shapes.hpp"
#include "tiles/poisson/tile_regions.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// Positions as shapes have them.
ShapeVector shape_vector(const TilePosition& position);
std::vector<ShapeVector> shape_vectors(const std::vector<TilePosition>& positions);

/// A piece whose region is drawn.
struct ScenePiece
{
    std::uint8_t axes = 0;
    std::array<std::int32_t, 3> base{}; ///< lattice point
    std::vector<std::uint32_t> colors;  ///< of its corners, of the edges at it, or its own; none: grey
    bool is_made = false;               ///< what the picture is about; others are there already

    bool operator==(const ScenePiece&) const = default;
};

/// A box from `low`, `size` units along each axis.
struct SceneBox
{
    TilePosition low{};
    TilePosition size{};

    bool operator==(const SceneBox&) const = default;

    ShapeVector low_corner() const { return shape_vector(low); }
    ShapeVector high_corner() const;
    bool holds(const TilePosition& position, int dimension) const;
};

/// The meaning of points in a panel, in the order in which they are drawn.
enum class PointClass : std::size_t
{
    surroundings, ///< around a tile while its interior is relaxed
    outer,        ///< elsewhere on the torus
    held,         ///< of a piece that is there already
    inner,        ///< in the piece or tile that is made
};

/// All classes of points, in the order in which they are stored.
inline constexpr std::array stored_point_classes{PointClass::held, PointClass::inner, PointClass::outer,
                                                 PointClass::surroundings};

/// Something for each class, by its number.
template <class T>
using ByPointClass = std::array<T, stored_point_classes.size()>;

const char* name_of(PointClass kind);

struct ScenePanel
{
    std::string caption;  ///< empty: a panel without a letter
    bool modified = true; ///< regions
    double radius = 0;    ///< of the disks of this panel, units; 0: that of the scene
    SceneBox window;
    SceneBox part; ///< regions are drawn as far as they are in here
    std::vector<ScenePiece> pieces;
    std::vector<std::array<std::int32_t, 3>> tiles; ///< lattice points of tiles whose borders are drawn
    ByPointClass<std::vector<TilePosition>> points;

    bool operator==(const ScenePanel&) const = default;

    std::vector<TilePosition>& of(PointClass kind) { return points[static_cast<std::size_t>(kind)]; }
    bool has_points() const;
};

struct Scene
{
    int dimension = 2;
    std::int32_t width = 0; ///< of regions
    double radius = 0;      ///< of the disks around points, units
    bool is_solid = false;  ///< 3D: regions as bodies, not as wires
    std::size_t columns = 1;
    std::vector<ScenePanel> panels; ///< at least one

    bool operator==(const Scene&) const = default;
};

/// The members of results.json about a scene.
struct SceneSummary
{
    std::size_t panels = 0;
    ByPointClass<std::size_t> points{}; ///< of each class, in all panels together

    bool operator==(const SceneSummary&) const = default;
};

SceneSummary summary_of(const Scene& scene);

/// The text of construction.json.
std::string scene_json(const Scene& scene);

/// A file construction.json. Throws InputError that names the file and the member.
Scene read_scene(const std::filesystem::path& file);

}
