// What a picture of the construction of Poisson tiles shows, panel by panel: regions and points. Stored as
// construction.json, see docs/output-folder.md; reports draw it.
#pragma once

#include "tiles/poisson/tile_position.hpp"
#include "tiles/poisson/tile_regions.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace poissonlab {

/// A piece whose region is drawn.
struct ScenePiece
{
    std::uint8_t axes = 0;
    std::array<std::int32_t, 3> base{}; ///< lattice point
    std::vector<std::uint32_t> colors;  ///< of its corners, of the edges at it, or its own; none: grey
    bool is_made = false;               ///< what the picture is about; others are there already

    bool operator==(const ScenePiece&) const = default;
};

/// From `low`, `size` units along each axis.
struct SceneBox
{
    TilePosition low{};
    TilePosition size{};

    bool holds(const TilePosition& position, int dimension) const;
};

/// What a point is in a panel.
enum class PointClass : std::size_t
{
    held,         ///< of a piece that is there already
    inner,        ///< in the piece or tile that is made
    outer,        ///< elsewhere on the torus
    surroundings, ///< around a tile while its interior is relaxed
};

inline constexpr std::array<const char*, 4> point_class_names{"held", "inner", "outer", "surroundings"};

struct ScenePanel
{
    std::string caption;  ///< empty: a panel without a letter
    bool modified = true; ///< regions
    SceneBox window;
    SceneBox part; ///< regions are drawn as far as they are in here
    std::vector<ScenePiece> pieces;
    std::vector<std::array<std::int32_t, 3>> tiles; ///< lattice points of tiles whose borders are drawn
    std::array<std::vector<TilePosition>, point_class_names.size()> points;

    std::vector<TilePosition>& of(PointClass kind) { return points[static_cast<std::size_t>(kind)]; }
};

struct Scene
{
    int dimension = 2;
    std::int32_t width = 0; ///< of regions
    double radius = 0;      ///< of the disks around points, units
    bool is_solid = false;  ///< 3D: regions as bodies, not as wires
    std::size_t columns = 1;
    std::vector<ScenePanel> panels;
};

/// What results.json says of a scene.
struct SceneSummary
{
    std::size_t panels = 0;
    std::array<std::size_t, point_class_names.size()> points{}; ///< of each class, in all panels together
};

SceneSummary summary_of(const Scene& scene);

/// The text of construction.json.
std::string scene_json(const Scene& scene);

}
