// Where nodes of glTF put what is below them.
#pragma once

#include "base/files/stored_object.hpp"
#include "base/surfaces/triangle_mesh.hpp"

namespace poissonlab {

/// Rows of a movement of space, which may stretch and mirror it: the last column moves.
using Movement = std::array<std::array<double, 4>, 3>;

/// The movement of a node by its `matrix`, or by `scale`, `rotation` and `translation`. Throws InputError.
Movement movement_of_node(const StoredObject& node);

/// That of `inside` and then `outside`.
Movement movement_of_both(const Movement& outside, const Movement& inside);

MeshPoint moved_by(const Movement& movement, const MeshPoint& point);

bool is_mirroring(const Movement& movement);

}
