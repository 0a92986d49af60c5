// Smoothing of seams in the gradient domain: a piece keeps its gradients and takes on the colours around it.
//
// Perez, Gangnet, Blake, Poisson image editing, SIGGRAPH 2003; Ng and others, Generating an omega-Tile Set for Texture
// Synthesis, 2005, section 3.3. Inside of the cut the piece O becomes O + r with r harmonic (5-point Laplacian), and r
// = I - O on the pixels of the surroundings I beside it. Channels are separate, in encoded values as in the article,
// and clamped at the end. The region stays inside of the ring, so that tiles still fit.
#pragma once

#include "host/texture/corner_texture.hpp"
#include "host/texture/piece_fitting.hpp"

#include <cstdint>
#include <vector>

namespace poissonlab {

class Device;

/// Regions of so many tiles, and for each of their channels the function that is known around the region.
struct GradientDomain
{
    int size = 0; ///< pixels along a side
    int channels = 1;
    std::vector<std::uint8_t> inside; ///< T^2 a tile: 1 where the function is unknown; never at a tile's border
    std::vector<double> values;       ///< T^2 a channel of a tile, tile after tile

    /// Sweeps, and the factor of their steps: the best one for a full square of this size, which makes errors smaller
    /// by exp(-2 pi / size) a sweep, and 4e-17 times as large in all.
    int sweeps() const { return 6 * size; }
    double relaxation() const;
};

/// Makes the functions harmonic inside, on the device: a work-group a channel of a tile, bits independent of its size.
void relax_on(Device& device, GradientDomain& domain, std::size_t work_group_size);

/// Makes the functions harmonic inside, in plain C++.
void relax_reference(GradientDomain& domain);

/// The known pixels of tiles with these pieces in their middles: `tiles` have the pieces in them. All have one size.
GradientDomain gradient_domain(const PngPixels& exemplar, const std::vector<PngPixels>& tiles,
                               const std::vector<FittedPiece>& pieces);

/// The known pixels of Wang tiles in the manner of Ng's figure 6b: the bow tie of the samples of vertical edges takes
/// on the colours of the horizontal edges' samples around it, and at the western and eastern sides their colours there.
/// Tiles that share a vertical edge then differ beside it: only the outermost pixels are left alone.
GradientDomain bow_tie_domain(const PngPixels& exemplar, int size, const BowTies& ties);

/// Adds the functions to the taken pixels of the tiles.
void add_to_tiles(const GradientDomain& domain, std::vector<PngPixels>& tiles);

}
