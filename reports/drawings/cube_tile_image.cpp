#include "reports/drawings/cube_tile_image.hpp"

#include "base/errors/errors.hpp"
#include "reports/drawings/square_regions.hpp"
#include "tiles/tilings/tile_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace poissonlab {
namespace {

constexpr double edge_length = 32;
constexpr double gap_size = 16; // more than two disks
constexpr double cube_margin = 8;
constexpr double disk_radius = 5;
constexpr double ring_width = 2;
const double half_sqrt3 = std::numbers::sqrt3 / 2;

using Place = std::array<std::size_t, 3>; ///< x, y, z

/// One of the three orientations of faces in sight. Corners are in the order of a DrawnSquare.
struct Side
{
    double shade;                 ///< the share of black in its colours
    std::array<Place, 4> corners; ///< in the unit cube
};

const std::array<Side, 3> sides{{
    {0.0, {{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}}},  // top
    {0.08, {{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}}}, // south
    {0.16, {{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}}}, // east
}};

/// A face in sight: where in the drawing, its corners' colours and lattice points; of a Wang cube its own colour and
/// that of the face behind it.
struct Face
{
    const Side* side = nullptr;
    DrawnSquare square{};
    std::array<Color, 4> colors{};
    std::array<Place, 4> lattice{};
    Color own = 0, behind = 0;
};

/// A tile or a block, drawn on its own: its lattice point (0, 0, 0) is at `origin`.
struct Block
{
    Place size{1, 1, 1};
    DrawingPoint origin{};
    const TileIndex* cubes = nullptr;
    TileKind kind = TileKind::cube;
};

DrawingPoint project(const DrawingPoint& origin, const Place& place)
{
    const auto x = static_cast<double>(place[0]), y = static_cast<double>(place[1]), z = static_cast<double>(place[2]);
    return {origin[0] + (x + y) * half_sqrt3 * edge_length, origin[1] + ((x - y) / 2 - z) * edge_length};
}

DrawingPoint difference(const DrawingPoint& a, const DrawingPoint& b) { return {a[0] - b[0], a[1] - b[1]}; }

/// The width and height of a block's projection, and how far its lattice point (0, 0, 0) is below the top.
struct Extent
{
    double width, height, ascent;
};

Extent extent_of(const Place& size)
{
    const auto x = static_cast<double>(size[0]), y = static_cast<double>(size[1]), z = static_cast<double>(size[2]);
    return {(x + y) * half_sqrt3 * edge_length, ((x + y) / 2 + z) * edge_length, (y / 2 + z) * edge_length};
}

Color color_at(const CornerCube& cube, const Place& corner)
{
    return corner_colors(corner[2] == 1 ? cube.top : cube.bottom)[corner[1] == 0 ? corner[0] : 3 - corner[0]];
}

void color_face(Face& face, const WangCube& cube)
{
    const bool is_top = face.side == &sides[0], is_south = face.side == &sides[1];
    face.own = is_top ? cube.top : is_south ? cube.south : cube.east;
    face.behind = is_top ? cube.bottom : is_south ? cube.north : cube.west;
}

Face face_of(const Block& block, const Side& side, const Place& cube, Color colors)
{
    const TileIndex index = block.cubes[(cube[2] * block.size[1] + cube[1]) * block.size[0] + cube[0]];
    Face face;
    face.side = &side;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis) face.lattice[i][axis] = cube[axis] + side.corners[i][axis];
    if (block.kind == TileKind::wang_cube)
        color_face(face, wang_cube(index, colors));
    else
        for (std::size_t i = 0; i < 4; ++i) face.colors[i] = color_at(cube_tile(index, colors), side.corners[i]);
    const DrawingPoint corner = project(block.origin, face.lattice[0]);
    face.square = {corner, difference(project(block.origin, face.lattice[1]), corner),
                   difference(project(block.origin, face.lattice[3]), corner)};
    return face;
}

/// The faces of a block that a viewer in the south-east and above sees.
std::vector<Face> faces_of(const Block& block, Color colors)
{
    const auto& [nx, ny, nz] = block.size;
    std::vector<Face> faces;
    for (std::size_t y = 0; y < ny; ++y)
        for (std::size_t x = 0; x < nx; ++x) faces.push_back(face_of(block, sides[0], {x, y, nz - 1}, colors));
    for (std::size_t z = 0; z < nz; ++z)
        for (std::size_t x = 0; x < nx; ++x) faces.push_back(face_of(block, sides[1], {x, 0, z}, colors));
    for (std::size_t z = 0; z < nz; ++z)
        for (std::size_t y = 0; y < ny; ++y) faces.push_back(face_of(block, sides[2], {nx - 1, y, z}, colors));
    return faces;
}

/// The blocks that are drawn on their own: the whole block of a tiling, each cube of a set. Gives the drawing its size.
std::vector<Block> blocks_of(const CubeGrid& grid, Drawing& drawing)
{
    const auto& [nx, ny, nz] = grid.size;
    if (nx == 0 || ny == 0 || nz == 0 || grid.cubes.size() > nx * ny * nz ||
        (!grid.has_gaps && grid.cubes.size() < nx * ny * nz))
        throw std::logic_error(fmt::format("{} cubes in a block of {} x {} x {}", grid.cubes.size(), nx, ny, nz));
    const Extent extent = extent_of(grid.has_gaps ? Place{1, 1, 1} : grid.size);
    const std::size_t columns = grid.has_gaps ? nx : 1;
    const std::size_t count = grid.has_gaps ? grid.cubes.size() : 1;
    const std::size_t rows = std::max<std::size_t>(1, (count + columns - 1) / columns);
    drawing.width = 2 * cube_margin + static_cast<double>(columns) * (extent.width + gap_size) - gap_size;
    drawing.height = 2 * cube_margin + static_cast<double>(rows) * (extent.height + gap_size) - gap_size;
    std::vector<Block> blocks;
    for (std::size_t i = 0; i < count; ++i) {
        const auto column = static_cast<double>(i % columns), row = static_cast<double>(i / columns);
        blocks.push_back({grid.has_gaps ? Place{1, 1, 1} : grid.size,
                          {cube_margin + column * (extent.width + gap_size),
                           cube_margin + row * (extent.height + gap_size) + extent.ascent},
                          grid.cubes.data() + i,
                          grid.kind});
    }
    return blocks;
}

std::string shaded(const std::string& color, const Side& side) { return mixed_color(color, "#000000", side.shade); }

/// Disks that do not overlap, with thin outlines.
class Disks
{
public:
    void add(const DrawingPoint& center, double radius, const std::string& color)
    {
        fills_.push_back({Disk{center, radius}, color, {}});
        outlines_.push_back({Disk{center, radius}, {}, "#000000", 0.6});
    }

    void draw(std::vector<Shape>& shapes)
    {
        group_by_fill(fills_);
        shapes.insert(shapes.end(), fills_.begin(), fills_.end());
        shapes.insert(shapes.end(), outlines_.begin(), outlines_.end());
    }

private:
    std::vector<Shape> fills_;
    std::vector<Shape> outlines_;
};

void add_plain_faces(std::vector<Shape>& shapes, const std::vector<Face>& faces)
{
    std::vector<Shape> plain;
    plain.reserve(faces.size());
    for (const Face& face : faces) plain.push_back({face.square.outline(), shaded("#ffffff", *face.side), {}});
    group_by_fill(plain);
    shapes.insert(shapes.end(), plain.begin(), plain.end());
}

void add_face_outlines(std::vector<Shape>& shapes, const std::vector<Face>& faces, double width)
{
    for (const Face& face : faces) shapes.push_back({face.square.outline(), {}, "#000000", width});
}

/// A parallelogram in the middle of a face, of this part of its sides.
Polygon middle_of(const DrawnSquare& square, double part)
{
    const double low = (1 - part) / 2, high = (1 + part) / 2;
    return {square.at(low, low), square.at(high, low), square.at(high, high), square.at(low, high)};
}

Drawing draw_wang_cubes(const CubeGrid& grid)
{
    constexpr double behind_part = 0.4;
    Drawing drawing;
    std::vector<Shape> fills, outlines;
    for (const Block& block : blocks_of(grid, drawing))
        for (const Face& face : faces_of(block, grid.colors)) {
            fills.push_back({face.square.outline(), shaded(tile_color(face.own), *face.side), {}});
            outlines.push_back({face.square.outline(), {}, "#000000", 1});
            if (!grid.has_gaps) continue;
            const Polygon middle = middle_of(face.square, behind_part);
            outlines.push_back({middle, shaded(tile_color(face.behind), *face.side), {}});
            outlines.push_back({middle, {}, "#000000", 0.6});
        }
    group_by_fill(fills);
    drawing.shapes = std::move(fills);
    drawing.shapes.insert(drawing.shapes.end(), outlines.begin(), outlines.end());
    return drawing;
}

}

Drawing draw_cubes(const CubeGrid& grid)
{
    if (grid.kind == TileKind::wang_cube) return draw_wang_cubes(grid);
    Drawing drawing;
    std::vector<Face> faces;
    Disks rings, disks;
    for (const Block& block : blocks_of(grid, drawing)) {
        const std::vector<Face> block_faces = faces_of(block, grid.colors);
        faces.insert(faces.end(), block_faces.begin(), block_faces.end());

        // Neighbouring faces share lattice points.
        std::map<Place, Color> lattice;
        for (const Face& face : block_faces)
            for (std::size_t i = 0; i < 4; ++i) lattice[face.lattice[i]] = face.colors[i];
        for (const auto& [place, color] : lattice)
            disks.add(project(block.origin, place), disk_radius, tile_color(color));

        // The corner of a set's cube that is farthest from the viewer, behind the one that is nearest.
        if (grid.has_gaps)
            rings.add(project(block.origin, {1, 0, 1}), disk_radius + ring_width,
                      tile_color(color_at(cube_tile(*block.cubes, grid.colors), {0, 1, 0})));
    }

    // Neither faces nor blocks overlap, so that all of a kind can be drawn together.
    add_plain_faces(drawing.shapes, faces);
    add_face_outlines(drawing.shapes, faces, 1);
    rings.draw(drawing.shapes);
    disks.draw(drawing.shapes);
    return drawing;
}

Drawing draw_cube_regions(const CubeGrid& grid, double radius)
{
    if (!(radius > 0 && radius <= max_sphere_region_radius))
        throw InputError(fmt::format("tile regions for the Poisson sphere radius {}: must be above 0 and at "
                                     "most {:.4f} of the cube's side",
                                     radius, max_sphere_region_radius));
    const RegionSizes sizes{std::min(0.5, radius * (1 + 2 * std::numbers::sqrt2)), radius * (1 + std::numbers::sqrt2)};
    Drawing drawing;
    std::vector<Face> faces;
    for (const Block& block : blocks_of(grid, drawing))
        for (const Face& face : faces_of(block, grid.colors)) faces.push_back(face);

    // Neither faces nor blocks overlap: all fills first, then all lines.
    add_plain_faces(drawing.shapes, faces);
    std::vector<Shape> regions;
    for (const Face& face : faces)
        for (std::size_t i = 0; i < 4; ++i) {
            const std::string color = tile_color(face.colors[i]);
            const std::string tint = shaded(edge_tint(color), *face.side);
            regions.push_back(corner_region(face.square, sizes, i, shaded(color, *face.side)));
            regions.push_back(half_edge_region(face.square, sizes, i, false, tint));
            regions.push_back(half_edge_region(face.square, sizes, (i + 3) % 4, true, tint));
        }
    group_by_fill(regions);
    drawing.shapes.insert(drawing.shapes.end(), regions.begin(), regions.end());
    for (const Face& face : faces) add_region_outlines(drawing.shapes, face.square, sizes);
    add_face_outlines(drawing.shapes, faces, 0.6);
    return drawing;
}

}
