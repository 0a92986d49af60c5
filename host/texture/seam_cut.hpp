// Minimum cuts find where to cut from one picture to another that lies over it, so that the cut is seen least.
//
// Kwatra and others, Graphcut textures, SIGGRAPH 2003; Ng and others, Generating an omega-Tile Set for Texture
// Synthesis, 2005, section 3.2; Efros and Freeman, Image quilting, SIGGRAPH 2001. Costs are integers, so that cuts are
// exact and the same everywhere; of several minimum cuts, the one whose kept side is the smallest is taken. Ng leave
// open the norm over channels (here the sum of absolute differences), the difference quotient (central), and what
// happens where there is no gradient (2 levels are added).
#pragma once

#include "base/images/png_file.hpp"
#include "base/word_table.hpp"

#include <cstdint>
#include <vector>

namespace poissonlab {

enum class SeamWeight
{
    gradient, ///< differences over gradients: cuts go where much changes anyway
    plain,    ///< differences
};
inline constexpr WordTable<SeamWeight, 2> seam_weights{
    {{{SeamWeight::gradient, "gradient"}, {SeamWeight::plain, "plain"}}}};

/// The choices of a cut for a pixel.
enum class PixelRole : std::uint8_t
{
    kept,  ///< shows the picture below
    free,  ///< either
    taken, ///< shows the picture above
};

struct SeamCut
{
    std::vector<std::uint8_t> taken; ///< 1 where the picture above is shown, row by row
    std::int64_t cost = 0;           ///< the sum over all pairs of neighbours of which one is taken
};

/// The cost of a pair of neighbouring pixels of which one shows each picture: at least 1, at most 2^17.
std::int64_t pair_cost(const PngPixels& below, const PngPixels& above, int x, int y, bool is_vertical,
                       SeamWeight weight);

/// The minimum cut. Pictures and roles have the same size, at least 2 x 2. By libmaxflow; the flow is compared with the
/// cost of the labels.
SeamCut minimum_cut(const PngPixels& below, const PngPixels& above, const std::vector<PixelRole>& roles,
                    SeamWeight weight);

}
