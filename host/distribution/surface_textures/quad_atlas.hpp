// Pictures on the quads of a surface are cells of an atlas, which quads show turned by quarters.
#pragma once

#include "base/images/png_file.hpp"
#include "tiles/quads/quad_mesh.hpp"

#include <filesystem>
#include <vector>

namespace poissonlab {

/// Cells of side x side pixels with a gutter around each, whose pixels continue it, so that filters see no border.
struct QuadAtlas
{
    int side = 0;
    int gutter = 0;
    int columns = 0; ///< cells beside each other
    PngPixels color;
    PngPixels normal{}; ///< of tangent space, y upwards; without pixels: there is none

    struct Cell
    {
        std::uint32_t number = 0;
        std::uint32_t first = 0; ///< the quad's corner that is the cell's lower left one
    };
    std::vector<Cell> cells; ///< of each quad

    /// Makes an atlas for so many cells, all of them black.
    static QuadAtlas with(std::size_t count, int side, int gutter, int channels);

    /// Returns the upper left pixel of a cell's gutter.
    std::array<int, 2> corner_of(std::uint32_t cell) const;

    /// Returns where a place of a quad is, in pixels of the atlas from its upper left corner.
    std::array<double, 2> place_of(std::uint32_t quad, double u, double v) const;
};

/// Steps of colours from one pixel to the next, means over a surface of sums over channels.
struct AtlasSteps
{
    double across = 0;                               ///< from a quad to the next one, over their edge
    double inside = 0;                               ///< over the lines beside edges, in the same direction
    double greatest_across = 0, greatest_inside = 0; ///< means of one edge, and of one such line
};
AtlasSteps atlas_steps(const QuadAtlas& atlas, const QuadMesh& mesh, const QuadTopology& topology);

/// Makes normals of a map of heights, right in gutters as well but for their outermost pixels. `relief` is the height
/// of the full range in pixels.
PngPixels normals_of_heights(const PngPixels& heights, double relief);

/// Writes the surface as binary glTF 2.0, four triangles of each quad, y upwards. Throws StorageError.
void write_glb(const std::filesystem::path& file, const QuadMesh& mesh, const QuadTopology& topology,
               const QuadAtlas& atlas);

/// Draws the surface in the sun on a plane, from the front above and, to the right of that, from behind; z is up.
PngPixels quad_picture(const QuadMesh& mesh, const QuadTopology& topology, const QuadAtlas& atlas, int pixels);

/// Returns normals of quads' corners: means over the quads around, but for those beyond a crease of more than 40
/// degrees.
std::vector<std::array<MeshPoint, 4>> corner_normals(const QuadMesh& mesh, const QuadTopology& topology);

}
