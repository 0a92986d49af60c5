// The patches of corners, chosen together: those that pieces around all edges fit best, and that leave little of
// themselves in the mean of all tiles.
//
// For two patches at the ends of an edge, the piece between them has to go on with both: how well that can be done is
// the least sum, over all windows of the exemplar, of the squared differences of the window's halves from them. That
// takes one map of sums a patch and direction, at a quarter of the exemplar's resolution, and no cut, so that all pairs
// of many patches are compared; of all sets of patches one is taken whose pairs cost least together.
#pragma once

#include "host/texture/corner_patches.hpp"
#include "host/texture/joint/phase_rule.hpp"
#include "host/texture/joint/set_cover.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// The patches of a set, and where other windows may lie beside them.
struct JointPatches
{
    Patches patches;
    PhaseRule rule;
    std::string
        note; ///< a line that says that the exemplar has too few windows of one phase; empty where it has enough
};

/// A patch for each corner of the parts, T x T, their middles `distance` pixels apart along an axis; with waves all of
/// one phase, and where there are too few windows of one phase for that, nearer to each other.
JointPatches joint_patches(const PngPixels& exemplar, const PngPixels& features, const TextureRequest& request,
                           const SetParts& parts, int distance, const std::vector<RegularWave>& waves);

}
