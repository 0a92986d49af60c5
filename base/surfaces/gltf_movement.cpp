#include "base/surfaces/gltf_movement.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

std::vector<double> numbers_of_node(const StoredObject& node, const std::string& member,
                                    const std::vector<double>& otherwise)
{
    if (!node.has(member)) return otherwise;
    std::vector<double> numbers = node.numbers(member);
    if (numbers.size() != otherwise.size())
        throw node.error(member, fmt::format("must have {} numbers", otherwise.size()));
    return numbers;
}

}

Movement movement_of_node(const StoredObject& node)
{
    Movement movement{};
    if (node.has("matrix")) {
        const std::vector<double> m = numbers_of_node(node, "matrix", std::vector<double>(16));
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t column = 0; column < 4; ++column) movement[row][column] = m[4 * column + row];
        return movement;
    }
    const auto scale = numbers_of_node(node, "scale", {1, 1, 1}),
               moved = numbers_of_node(node, "translation", {0, 0, 0});
    const auto turn = numbers_of_node(node, "rotation", {0, 0, 0, 1}); // a quaternion of length 1
    const double x = turn[0], y = turn[1], z = turn[2], w = turn[3];
    const std::array<std::array<double, 3>, 3> turned{
        {{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
         {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
         {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}}};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) movement[row][column] = turned[row][column] * scale[column];
        movement[row][3] = moved[row];
    }
    return movement;
}

Movement movement_of_both(const Movement& outside, const Movement& inside)
{
    Movement result{};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 4; ++column)
            for (std::size_t k = 0; k < 3; ++k) result[row][column] += outside[row][k] * inside[k][column];
        result[row][3] += outside[row][3];
    }
    return result;
}

MeshPoint moved_by(const Movement& movement, const MeshPoint& point)
{
    MeshPoint moved{};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto& row = movement[k];
        moved[k] = row[0] * point[0] + row[1] * point[1] + row[2] * point[2] + row[3];
    }
    return moved;
}

bool is_mirroring(const Movement& m)
{
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]) <
           0;
}

}
