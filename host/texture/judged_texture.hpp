// The judge of texture sets chooses the better of two constructions, by measures that neither of them optimises.
//
// Pieces that are chosen for all tiles together have better seams and repeat less; where what the picture shows is
// large beside a tile, they can fuse or break it, which measures of seams do not see.
#pragma once

#include "tiles/texture/tiling_judge.hpp"

#include <string>

namespace poissonlab {

struct TextureChoice
{
    bool is_together = true;
    std::string words; ///< the sentence that says which one is kept, and why
};

/// Chooses between a set that is chosen together and one whose pieces are fitted one after another. It keeps the latter
/// in two cases. In the first, the set that is chosen together has more new patches, and its edges, `edge` pixels wide,
/// are narrower than features, which break there; features larger than half of a tile of `size` pixels break in both
/// sets and do not count. In the second, it has more uneven light than the exemplar, and much more than the other set.
TextureChoice better_texture(const TilingJudgement& together, const TilingJudgement& apart, int edge, int size);

}
