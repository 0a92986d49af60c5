// Texture tile sets from an exemplar, whatever their kind.
#pragma once

#include "host/texture/gradient_domain.hpp"
#include "host/texture/piece_fitting.hpp"
#include "host/texture/texture_request.hpp"
#include "tiles/texture/texture_set.hpp"

namespace poissonlab {

struct BuiltTexture
{
    TextureSet set;
    std::int64_t cost = 0;               ///< of all cuts, by their own weight
    std::vector<ExemplarWindow> windows; ///< all patches or samples, then pieces that are shown
    std::size_t patches = 0;             ///< how many of them are patches or samples
    std::vector<std::string> notes;      ///< lines that a person should read
    std::string choice{};                ///< which construction is kept, and why, where nobody asks for one
    bool is_joint = false;               ///< patches and cuts were chosen together
};

/// Makes the functions of a domain harmonic, on a device or not: the same bits.
using HarmonicSolver = std::function<void(GradientDomain& domain)>;

/// Makes the set; where the request says so in both ways, of which the better one is kept. The same request and
/// exemplar make the same bytes on any number of threads. Throws InputError as check() does, for exemplars that are
/// smaller than a tile, and for a diversity that does not fit; Interrupted from `progress`.
BuiltTexture build_texture(const TextureRequest& request, const PngPixels& exemplar, const PieceProgress& progress,
                           const HarmonicSolver& solve = relax_reference);

/// Gives the set its companions, which show their sources as they are, and says so where seams of the set are blended.
void add_companions(BuiltTexture& built, std::vector<CompanionMap> companions);

}
