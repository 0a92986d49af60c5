// Files of points on a surface: tables by columns, and glTF.
#include "host/distribution/surfaces/surface_files.hpp"

#include "base/files/whole_file.hpp"
#include "base/points/point_file.hpp"
#include "host/distribution/gltf_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <string_view>
#include <utility>

namespace poissonlab {
namespace {

constexpr std::size_t rows_a_piece = 4096;

template <typename Value>
void append_value(std::string& to, Value value)
{
    to.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

enum class ColumnType
{
    real,  ///< double
    brief, ///< float
    whole, ///< uint32
    byte   ///< uint8
};

/// A table whose rows are points: the columns, and the numbers of a row.
class SurfaceTable
{
public:
    SurfaceTable(const FixedSurface& surface, const std::vector<SurfacePoint>& points, const SurfaceClasses* classes,
                 const TriangleMesh* mesh)
        : surface_(surface), points_(points), classes_(classes), mesh_(mesh)
    {
        add({"x", "y", "z"}, ColumnType::real);
        add({"nx", "ny", "nz"}, ColumnType::brief);
        if (classes) add({"class"}, ColumnType::whole);
        if (!mesh) return;
        add({"face", "vertex_0", "vertex_1", "vertex_2"}, ColumnType::whole);
        add({"bary_0", "bary_1", "bary_2"}, ColumnType::real);
        if (!mesh->normal_triangles.empty()) add({"shading_nx", "shading_ny", "shading_nz"}, ColumnType::brief);
        if (!mesh->texture_triangles.empty()) add({"u", "v"}, ColumnType::real);
        for (std::size_t c = 0; c < mesh->columns.names.size(); ++c)
            add({mesh->columns.names[c]}, mesh->columns.are_bytes[c] ? ColumnType::byte : ColumnType::real);
    }

    const std::vector<std::pair<std::string, ColumnType>>& columns() const { return columns_; }
    std::size_t rows() const { return points_.size(); }

    void read_row(std::size_t i, std::vector<double>& row) const
    {
        const SurfacePoint& point = points_[i];
        row.clear();
        for (std::size_t k = 0; k < 3; ++k) row.push_back(surface_.origin[k] + point.place[k] * surface_.unit);
        append(row, normal_of(surface_.triangles[point.triangle]));
        if (classes_) row.push_back((*classes_)[i]);
        if (mesh_) read_mesh(point, row);
    }

private:
    /// Adds columns. A column of the mesh whose name is taken is called mesh_NAME.
    void add(const std::vector<std::string>& names, ColumnType type)
    {
        for (std::string name : names) {
            std::ranges::replace_if(
                name, [](char c) { return c == ',' || c == '"' || c == ' '; }, '_');
            while (std::ranges::find(columns_, name, &std::pair<std::string, ColumnType>::first) != columns_.end())
                name = "mesh_" + name;
            columns_.emplace_back(name, type);
        }
    }

    static void append(std::vector<double>& row, const MeshPoint& numbers)
    {
        row.insert(row.end(), numbers.begin(), numbers.end());
    }

    void read_mesh(const SurfacePoint& point, std::vector<double>& row) const
    {
        const std::uint32_t face = surface_.faces[point.triangle];
        const MeshTriangle& corners = mesh_->triangles[face];
        const MeshPoint shares = barycentrics_of(point);
        row.push_back(mesh_->faces[face]);
        for (const std::uint32_t corner : corners) row.push_back(corner);
        append(row, shares);
        // Numbers are interpolated linearly; corners whose share is 0 are left out, since they may lack the number.
        const auto between = [&shares](const MeshTriangle& at, const auto& number_at) {
            double sum = 0;
            for (std::size_t k = 0; k < 3; ++k)
                if (shares[k] > 0) sum += at[k] == no_texture_point ? NAN : shares[k] * number_at(at[k]);
            return sum;
        };
        if (!mesh_->normal_triangles.empty()) {
            MeshPoint normal{};
            for (std::size_t k = 0; k < 3; ++k)
                normal[k] = between(mesh_->normal_triangles[face], [&](std::size_t n) { return mesh_->normals[n][k]; });
            const double length = std::hypot(normal[0], normal[1], normal[2]);
            for (const double c : normal) row.push_back(length > 0 && std::isfinite(length) ? c / length : NAN);
        }
        if (!mesh_->texture_triangles.empty())
            for (std::size_t k = 0; k < 2; ++k)
                row.push_back(between(mesh_->texture_triangles[face],
                                      [&](std::size_t n) { return mesh_->texture_points[n][k]; }));
        for (std::size_t c = 0; c < mesh_->columns.names.size(); ++c)
            row.push_back(between(corners, [&](std::size_t vertex) { return mesh_->columns.at(vertex, c); }));
    }

    const FixedSurface& surface_;
    const std::vector<SurfacePoint>& points_;
    const SurfaceClasses* classes_; ///< null: points have none
    const TriangleMesh* mesh_;
    std::vector<std::pair<std::string, ColumnType>> columns_;
};

/// Writes a head and then blocks of rows; `append_row` makes the bytes of a row.
void write_rows(const std::filesystem::path& file, const SurfaceTable& table, const std::string& head,
                const std::function<void(const std::vector<double>& row, std::string& to)>& append_row)
{
    write_whole_file_in_pieces(file, [&](const FileSink& sink) {
        sink(head);
        std::vector<double> row;
        for (std::size_t begin = 0; begin < table.rows(); begin += rows_a_piece) {
            std::string piece;
            for (std::size_t i = begin; i < std::min(table.rows(), begin + rows_a_piece); ++i) {
                table.read_row(i, row);
                append_row(row, piece);
            }
            sink(piece);
        }
    });
}

std::uint8_t rounded_byte(double value) { return static_cast<std::uint8_t>(std::lround(value)); }

void write_surface_ply(const std::filesystem::path& file, const SurfaceTable& table, const std::string& comment)
{
    std::string head = fmt::format("ply\nformat binary_{}_endian 1.0\n{}element vertex {}\n",
                                   std::endian::native == std::endian::little ? "little" : "big",
                                   comment.empty() ? "" : fmt::format("comment {}\n", comment), table.rows());
    constexpr std::array types{"double", "float", "uint", "uchar"};
    for (const auto& [name, type] : table.columns())
        head += fmt::format("property {} {}\n", types[static_cast<std::size_t>(type)], name);
    write_rows(file, table, head + "end_header\n", [&](const std::vector<double>& row, std::string& to) {
        for (std::size_t c = 0; c < row.size(); ++c) switch (table.columns()[c].second) {
            case ColumnType::real:
                append_value(to, row[c]);
                break;
            case ColumnType::brief:
                append_value(to, static_cast<float>(row[c]));
                break;
            case ColumnType::whole:
                append_value(to, static_cast<std::uint32_t>(row[c]));
                break;
            case ColumnType::byte:
                append_value(to, rounded_byte(row[c]));
                break;
            }
    });
}

/// 17 significant digits tell every double from its neighbours.
void write_surface_csv(const std::filesystem::path& file, const SurfaceTable& table)
{
    std::vector<std::string> names;
    for (const auto& column : table.columns()) names.push_back(column.first);
    write_rows(
        file, table, fmt::format("{}\n", fmt::join(names, ",")),
        [](const std::vector<double>& row, std::string& to) { to += fmt::format("{:.17g}\n", fmt::join(row, ",")); });
}

/// A group for each class, or one without a name.
std::vector<GltfGroup> groups_of(const PointSet& places, const PointSet& normals, const SurfaceClasses* classes)
{
    std::vector<GltfGroup> groups(1);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::size_t own = classes ? (*classes)[i] : 0;
        groups.resize(std::max(groups.size(), own + 1));
        groups[own].places.insert(groups[own].places.end(), places[i].begin(), places[i].end());
        groups[own].normals.insert(groups[own].normals.end(), normals[i].begin(), normals[i].end());
    }
    for (std::size_t i = 0; classes && i < groups.size(); ++i) groups[i].name = fmt::format("class_{}", i);
    return groups;
}

void write_points_of(const std::filesystem::path& file, const FixedSurface& surface,
                     const std::vector<SurfacePoint>& points, const SurfaceClasses* classes, const std::string& comment,
                     const TriangleMesh* mesh)
{
    if (file.extension() == ".ply")
        return write_surface_ply(file, SurfaceTable(surface, points, classes, mesh), comment);
    if (file.extension() == ".csv") return write_surface_csv(file, SurfaceTable(surface, points, classes, mesh));
    const PointSet places = points_of(surface, points);
    if (file.extension() == ".glb")
        return write_surface_glb(file, groups_of(places, normals_of(surface, points), classes));
    write_points(file, places, comment);
}

}

void write_surface_points(const std::filesystem::path& file, const FixedSurface& surface,
                          const std::vector<SurfacePoint>& points, const std::string& comment, const TriangleMesh* mesh)
{
    write_points_of(file, surface, points, nullptr, comment, mesh);
}

void write_surface_points(const std::filesystem::path& file, const FixedSurface& surface,
                          const std::vector<SurfacePoint>& points, const SurfaceClasses& classes,
                          const std::string& comment, const TriangleMesh* mesh)
{
    write_points_of(file, surface, points, &classes, comment, mesh);
}

bool has_surface_columns(const std::filesystem::path& file)
{
    return file.extension() == ".ply" || file.extension() == ".csv";
}

MeshPoint barycentrics_of(const SurfacePoint& point)
{
    const double second = std::ldexp(point.shares[0], -contract::surface::BARYCENTRIC_BITS),
                 third = std::ldexp(point.shares[1], -contract::surface::BARYCENTRIC_BITS);
    return {1 - second - third, second, third};
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
