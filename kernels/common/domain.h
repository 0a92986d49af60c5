// The contract of domain.clh and its host code, host/sampling/cells/domain.cpp and domain_buffers.cpp.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(domain)

/// A region as doubles: centre, then first and end of its half-spaces.
DERIVED(REGION_WORDS, (size_t DIMENSION), DIMENSION + 2)

/// A half-space as doubles: normal, offset.
DERIVED(HALF_SPACE_WORDS, (size_t DIMENSION), DIMENSION + 1)

enum
{
    MAX_CONTACTS = 4 ///< of one movement with boundaries; what is left after so many is given up
};

/// A point that is no deeper than this in a region is on its boundary, so that rounding, of coordinates and at the
/// region's corners, decides nothing.
REAL(BOUNDARY_DEPTH, 0x1p-46)

/// Sliding leads away from the boundary by these: a part of the movement, and a distance. More than rounding, which
/// thus neither leads back into the region nor, over many movements, deeper.
REAL(LIFT_PART, 0x1p-48)
REAL(LIFT_DISTANCE, 0x1p-51)

END_CONTRACT
