#include "host/distribution/surfaces/surface_files.hpp"

#include "base/files/whole_file.hpp"
#include "base/points/point_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace poissonlab {
namespace {

constexpr std::size_t vertices_a_piece = 4096;

std::string surface_ply_header(std::size_t points, const std::string& comment)
{
    return fmt::format("ply\nformat binary_{}_endian 1.0\n{}element vertex {}\n"
                       "property double x\nproperty double y\nproperty double z\n"
                       "property float nx\nproperty float ny\nproperty float nz\nend_header\n",
                       std::endian::native == std::endian::little ? "little" : "big",
                       comment.empty() ? "" : fmt::format("comment {}\n", comment), points);
}

template <typename Value>
void append_value(std::string& to, Value value)
{
    to.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

void write_surface_ply(const std::filesystem::path& file, const PointSet& places, const PointSet& normals,
                       const std::string& comment)
{
    write_whole_file_in_pieces(file, [&](const FileSink& sink) {
        sink(surface_ply_header(places.size(), comment));
        for (std::size_t begin = 0; begin < places.size(); begin += vertices_a_piece) {
            std::string piece;
            for (std::size_t i = begin; i < std::min(places.size(), begin + vertices_a_piece); ++i) {
                for (const double c : places[i]) append_value(piece, c);
                for (const double c : normals[i]) append_value(piece, static_cast<float>(c));
            }
            sink(piece);
        }
    });
}

}

void write_surface_points(const std::filesystem::path& file, const FixedSurface& surface,
                          const std::vector<SurfacePoint>& points, const std::string& comment)
{
    const PointSet places = points_of(surface, points);
    if (file.extension() == ".ply") return write_surface_ply(file, places, normals_of(surface, points), comment);
    write_points(file, places, comment);
}

PointSet normals_of(const FixedSurface& surface, const std::vector<SurfacePoint>& points)
{
    PointSet normals{3, {}};
    normals.coordinates.reserve(3 * points.size());
    for (const SurfacePoint& point : points)
        for (const double c : normal_of(surface.triangles[point.triangle])) normals.coordinates.push_back(c);
    return normals;
}

}
