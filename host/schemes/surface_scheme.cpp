// kind = "surface": corner tiles on the surface of a polycube. The vertices of its mesh of squares have hashed colours,
// and so every face has a tile: the one with the colours of its corners.
//
// Lagae, Kaplan, Fu, Ostromoukhov and Deussen, Tile-Based Methods for Interactive Applications, 2009 (SIGGRAPH 2008
// class notes), part III, has pictures of tiled surfaces without a text: the rule here is our own. Neighbouring faces
// have the same colours at both ends of their common edge, whatever the surface. Where three or five faces meet,
// nothing that is proved of tilings of the plane holds, and a minimum distance within the faces is none in space.
#include "base/random/random.hpp"
#include "host/schemes/mark_canvas.hpp"
#include "host/schemes/scheme_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <set>

namespace poissonlab {
namespace {

using Cell = std::array<int, 3>;

/// A face of a cube: its corners counterclockwise, seen from outside.
struct SurfaceFace
{
    std::size_t axis = 0;
    bool is_upper = false; ///< at the larger coordinate
    std::array<Cell, 4> corners{};
};

SurfaceFace face_of_cube(const Cell& cube, std::size_t axis, bool is_upper)
{
    SurfaceFace face{axis, is_upper, {}};
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (std::size_t i = 0; i < 4; ++i) {
        Cell& corner = face.corners[i];
        corner = cube;
        if (is_upper) ++corner[axis];
        // Seen from the other side, u and v change places.
        if (i == 1 || i == 2) ++corner[is_upper ? u : v];
        if (i == 2 || i == 3) ++corner[is_upper ? v : u];
    }
    return face;
}

/// The faces of the cubes that no other cube has as well.
std::vector<SurfaceFace> outer_faces(const std::vector<Cell>& cubes)
{
    const std::set<Cell> there(cubes.begin(), cubes.end());
    std::vector<SurfaceFace> faces;
    for (const Cell& cube : there)
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const bool is_upper : {false, true}) {
                Cell beside = cube;
                beside[axis] += is_upper ? 1 : -1;
                if (!there.contains(beside)) faces.push_back(face_of_cube(cube, axis, is_upper));
            }
    return faces;
}

/// The colour of a vertex of the mesh by its place, whatever other cubes there are.
Color vertex_color(const Cell& vertex, Color colors, std::uint64_t seed)
{
    const auto words = philox({static_cast<std::uint32_t>(vertex[0]), static_cast<std::uint32_t>(vertex[1]),
                               static_cast<std::uint32_t>(vertex[2]), 0},
                              stream_key(seed, Purpose::mesh_colors, 0));
    return static_cast<Color>(std::uint64_t{words[0]} * colors >> 32);
}

CornerTile face_tile(const SurfaceFace& face, Color colors, std::uint64_t seed)
{
    const auto color = [&](std::size_t corner) { return vertex_color(face.corners[corner], colors, seed); };
    return {color(2), color(1), color(0), color(3)};
}

/// Isometric projection: a viewer above the south-east, or above the north-west.
struct View
{
    bool is_turned = false;

    MarkPoint at(const Cell& p) const
    {
        const double sign = is_turned ? -1 : 1;
        const double x = sign * p[0], y = sign * p[1];
        return {(x + y) * std::numbers::sqrt3 / 2, (y - x) / 2 + p[2]};
    }
    bool sees(const SurfaceFace& face) const
    {
        if (face.axis == 2) return face.is_upper;
        return face.is_upper == ((face.axis == 0) != is_turned);
    }
    /// A number that grows towards the viewer.
    int nearness(const SurfaceFace& face) const
    {
        int sum = 0;
        for (const Cell& p : face.corners) sum += (is_turned ? -1 : 1) * (p[0] - p[1]) + p[2];
        return sum;
    }
};

MarkPicture surface_picture(std::vector<SurfaceFace> faces, const View& view, Color colors, std::uint64_t seed)
{
    constexpr double margin = 0.3;
    std::erase_if(faces, [&](const SurfaceFace& face) { return !view.sees(face); });
    std::ranges::stable_sort(faces, {}, [&](const SurfaceFace& face) { return view.nearness(face); });
    MarkPoint low{1e9, 1e9}, high{-1e9, -1e9};
    for (const SurfaceFace& face : faces)
        for (const Cell& corner : face.corners)
            for (std::size_t i = 0; i < 2; ++i) {
                low[i] = std::min(low[i], view.at(corner)[i]);
                high[i] = std::max(high[i], view.at(corner)[i]);
            }
    MarkCanvas canvas(high[0] - low[0] + 2 * margin, high[1] - low[1] + 2 * margin, 90);
    const auto place = [&](const Cell& p) {
        const MarkPoint at = view.at(p);
        return MarkPoint{at[0] - low[0] + margin, at[1] - low[1] + margin};
    };
    for (const SurfaceFace& face : faces) {
        const MarkPoint a = place(face.corners[0]), b = place(face.corners[1]), d = place(face.corners[3]);
        const MarkSquare square{a, {b[0] - a[0], b[1] - a[1]}, {d[0] - a[0], d[1] - a[1]}};
        canvas.polygon(face.axis == 2 ? "#ffffff" : face.axis == 1 ? "#e6e8ec" : "#cfd3d9", square.outline());
        canvas.tile(face_tile(face, colors, seed), square, 0.025);
    }
    return canvas.picture();
}

struct SurfaceCounts
{
    std::size_t vertices = 0, edges = 0, mismatches = 0, irregular = 0, crowded = 0;
};

/// Vertices, edges and the tiles that meet there.
SurfaceCounts counts_of(const std::vector<SurfaceFace>& faces, Color colors, std::uint64_t seed)
{
    using EdgeColors = std::pair<Color, Color>;
    std::map<Cell, std::size_t> faces_at;
    std::map<std::pair<Cell, Cell>, std::vector<EdgeColors>> edges;
    for (const SurfaceFace& face : faces) {
        const CornerTile tile = face_tile(face, colors, seed);
        const std::array<Color, 4> shown{tile.south_west, tile.south_east, tile.north_east, tile.north_west};
        for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t next = (i + 1) % 4;
            const Cell &from = face.corners[i], &to = face.corners[next];
            ++faces_at[from];
            if (from < to)
                edges[{from, to}].emplace_back(shown[i], shown[next]);
            else
                edges[{to, from}].emplace_back(shown[next], shown[i]);
        }
    }
    SurfaceCounts counts;
    counts.vertices = faces_at.size();
    counts.edges = edges.size();
    for (const auto& [vertex, count] : faces_at) counts.irregular += count != 4;
    for (const auto& [edge, shown] : edges) {
        counts.crowded += shown.size() != 2;
        counts.mismatches += std::ranges::any_of(shown, [&](const EdgeColors& pair) { return pair != shown.front(); });
    }
    return counts;
}

}

DistributionResult make_surface(const SurfaceSettings& settings, std::uint64_t seed, DistributionFiles& files)
{
    const std::vector<SurfaceFace> faces = outer_faces(settings.cubes);
    const SurfaceCounts counts = counts_of(faces, settings.colors, seed);
    std::set<TileIndex> used;
    for (const SurfaceFace& face : faces)
        used.insert(corner_index(face_tile(face, settings.colors, seed), settings.colors));
    DistributionResult result;
    result.facts = {
        fmt::format("{} cubes, {} faces, {} colours", settings.cubes.size(), faces.size(), settings.colors),
        "a tile fits to its neighbours on any surface, whichever corner of a face counts as its first",
        "no minimum distance is claimed: where other than four faces meet nothing is proved, and faces that "
        "meet at an angle are nearer in space than on the surface"};
    const double euler =
        static_cast<double>(counts.vertices) - static_cast<double>(counts.edges) + static_cast<double>(faces.size());
    result.numbers = {
        {"mismatches", "Edges where tiles do not fit", static_cast<double>(counts.mismatches),
         fmt::format("of {} edges", counts.edges)},
        {"irregular", "Irregular vertices", static_cast<double>(counts.irregular),
         fmt::format("of {}: other than four faces meet there", counts.vertices)},
        {"crowded", "Edges with other than two faces", static_cast<double>(counts.crowded),
         "where cubes touch along an edge only"},
        {"euler", "Vertices less edges plus faces", euler, "2 for a surface without holes"},
        {"tiles", "Tiles used", static_cast<double>(used.size()),
         fmt::format("of the {} of the complete set", TileSet::complete(TileKind::corner, settings.colors).size())}};
    files.add_marks("front.json", surface_picture(faces, {false}, settings.colors, seed), "From above the south-east.",
                    result);
    files.add_marks("back.json", surface_picture(faces, {true}, settings.colors, seed), "From above the north-west.",
                    result);
    return result;
}

}
