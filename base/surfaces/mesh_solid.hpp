// The inside of a closed mesh as a region of space.
//
// Nodes of a lattice are inside where the surface winds around them once, which is counted along lines in the direction
// of z: exactly, since each edge decides alike for both of its faces. Nodes beside the surface have their distance from
// it, so that the region ends between them, off the surface by parts of a cell where it is smooth. Edges and corners
// are rounded by less than a cell, and parts that are thinner than a cell may be lost.
#pragma once

#include "base/regions/space_region.hpp"

#include <filesystem>

namespace poissonlab {

/// Reads a mesh, whose vertices at one place count as one. Throws InputError, a line that begins with the file's name:
/// it is not a mesh, or it is open, has edges of more than two faces, or faces that are oriented differently from their
/// neighbours. The region's reading throws where the surface overlaps itself around a node, or no node is inside.
SpaceRegion solid_of_mesh(const std::filesystem::path& file);

}
