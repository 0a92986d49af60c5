// The word that files of OFF begin with.
#pragma once

#include "base/surfaces/triangle_mesh.hpp"

#include <optional>
#include <string_view>

namespace poissonlab {

/// [ST][C][N][4][n]OFF: what vertices have besides x, y and z, after them but for the weight.
struct OffKeyword
{
    bool has_texture = false, has_colors = false, has_normals = false, has_weights = false, has_dimension = false;
    std::string_view glued; ///< digits that follow without a blank, as in "OFF8 6 0"
};

/// Reads a keyword of OFF; returns nothing where the word is none.
std::optional<OffKeyword> off_keyword(std::string_view word);

/// Divides homogeneous coordinates by their weight. False where no finite numbers come out.
bool is_divided(MeshPoint& point, double weight);

}
