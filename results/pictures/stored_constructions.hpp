// The member "constructions" of results.json, and the files construction.json that it names: pictures of how
// Poisson tile sets come into being.
#pragma once

#include "base/files/stored_object.hpp"
#include "tiles/poisson/region_shapes.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// What points are in a panel, in the order in which they are drawn, see docs/output-folder.md.
enum class StoredPointClass : std::size_t
{
    surroundings,
    outer,
    held,
    inner,
};

inline constexpr std::array<const char*, 4> stored_point_classes{"surroundings", "outer", "held", "inner"};

struct ConstructionResult
{
    std::string name; ///< its folder
    std::string label;
    std::string kind; ///< "corner", "edge", "template" or "sphere"
    std::string show;
    std::size_t colors = 0;
    std::size_t tiles = 0;
    std::size_t points_per_tile = 0;
    double relative_radius = 0;
    int lloyd_iterations = 0;
    bool repulsion = false;
    std::string filling;
    std::string file;                                              ///< relative to the result folder
    std::array<std::size_t, stored_point_classes.size()> points{}; ///< of each class
};

/// A piece whose region is drawn.
struct StoredPiece
{
    std::uint8_t axes = 0; ///< see TileCell
    std::array<std::int32_t, 3> base{};
    std::vector<std::uint32_t> colors; ///< none, one, one for each corner of the cell, or of a corner one for each edge
    bool is_made = false;              ///< what the picture is about
};

/// Units of tile_regions.hpp.
struct StoredBox
{
    ShapeVector low{};
    ShapeVector size{};

    ShapeVector high() const { return {low[0] + size[0], low[1] + size[1], low[2] + size[2]}; }
};

struct StoredPanel
{
    std::string caption; ///< empty: a panel without a letter
    bool modified = true;
    StoredBox window;
    StoredBox part; ///< regions are drawn as far as they are in here
    std::vector<StoredPiece> pieces;
    std::vector<ShapeVector> tiles; ///< lattice points of tiles whose borders are drawn
    std::array<std::vector<ShapeVector>, stored_point_classes.size()> points;

    bool has_points() const;
};

struct StoredScene
{
    int dimension = 2;
    std::int32_t width = 0; ///< of regions
    double radius = 0;      ///< of disks (spheres) around points
    bool is_solid = false;
    std::size_t columns = 1;
    std::vector<StoredPanel> panels; ///< at least one
};

/// Throws InputError for members of another kind.
std::vector<ConstructionResult> read_constructions(const StoredObject& root);

/// A file construction.json. Throws InputError that names the file and the member.
StoredScene read_scene(const std::filesystem::path& file);

}
