// Small meshes that tests make.
#pragma once

#include "base/surfaces/triangle_mesh.hpp"

#include <cmath>
#include <numbers>

namespace poissonlab {

/// A square of side 1 in the plane z = height, as `rows` x `rows` squares of two triangles; open at its edges.
inline TriangleMesh square_mesh(std::uint32_t rows = 1, double height = 0)
{
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i <= rows; ++i)
        for (std::uint32_t j = 0; j <= rows; ++j) mesh.vertices.push_back({double(j) / rows, double(i) / rows, height});
    for (std::uint32_t i = 0; i < rows; ++i)
        for (std::uint32_t j = 0; j < rows; ++j) {
            const std::uint32_t a = i * (rows + 1) + j, b = a + 1, c = b + rows + 1, d = c - 1;
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
        }
    return mesh;
}

/// A surface over texture coordinates (u, v) in the unit square, which `place` puts into space: `columns` x `rows`
/// squares of two triangles.
template <class Place>
TriangleMesh textured_mesh(std::uint32_t columns, std::uint32_t rows, const Place& place)
{
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i <= rows; ++i)
        for (std::uint32_t j = 0; j <= columns; ++j) {
            const TexturePoint at{double(j) / columns, double(i) / rows};
            mesh.texture_points.push_back(at);
            mesh.vertices.push_back(place(at[0], at[1]));
        }
    for (std::uint32_t i = 0; i < rows; ++i)
        for (std::uint32_t j = 0; j < columns; ++j) {
            const std::uint32_t a = i * (columns + 1) + j, b = a + 1, c = b + columns + 1, d = c - 1;
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
        }
    mesh.texture_triangles = mesh.triangles;
    return mesh;
}

/// Squares at heights 0 and `thickness`, whose normals point away from each other.
inline TriangleMesh sheet_mesh(double thickness)
{
    TriangleMesh mesh = square_mesh(1, thickness);
    const TriangleMesh below = square_mesh(1, 0);
    mesh.vertices.insert(mesh.vertices.end(), below.vertices.begin(), below.vertices.end());
    for (const auto& [a, b, c] : below.triangles) mesh.triangles.push_back({a + 4, c + 4, b + 4});
    return mesh;
}

/// A sphere of radius 1 by angles: triangles near its poles are small and narrow.
inline TriangleMesh sphere_mesh(std::uint32_t rows)
{
    TriangleMesh mesh;
    const std::uint32_t columns = 2 * rows;
    for (std::uint32_t i = 0; i <= rows; ++i)
        for (std::uint32_t j = 0; j < columns; ++j) {
            const double polar = std::numbers::pi * i / rows, turn = 2 * std::numbers::pi * j / columns;
            mesh.vertices.push_back(
                {std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar)});
        }
    for (std::uint32_t i = 0; i < rows; ++i)
        for (std::uint32_t j = 0; j < columns; ++j) {
            const std::uint32_t a = i * columns + j, b = i * columns + (j + 1) % columns;
            if (i > 0) mesh.triangles.push_back({a, a + columns, b});
            if (i + 1 < rows) mesh.triangles.push_back({b, a + columns, b + columns});
        }
    return mesh;
}

}
