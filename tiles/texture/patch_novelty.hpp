// Novelty is the share of a picture's patches that are like nothing in its exemplar: fused shapes, mosaics and broken
// outlines, which measures of single seams do not see, and which no cut makes fewer on purpose.
//
// Patches are squares in orthonormal opponent colours (with one channel: grey). The distance of two patches compares
// those coefficients of their orthonormal cosine transform that vary most in the exemplar. No other choice of as many
// numbers keeps much more of the distance, because principal components of natural pictures are close to these cosines
// (Ahmed, Natarajan, Rao, Discrete Cosine Transform, 1974). Non-parametric samplers search for the nearest
// neighbourhood in the same way (Efros and Leung 1999). The exemplar itself defines which distances are small: those
// that 90 % of the patches of one of its halves have from the other half.
#pragma once

#include "base/images/png_file.hpp"
#include "tiles/texture/texture_set.hpp"

#include <memory>
#include <span>

namespace poissonlab {

/// Coefficients of a patch that are compared, and the largest frequency of each direction among them.
inline constexpr std::size_t patch_coefficients = 40;
inline constexpr int patch_frequencies = 9;

/// The part of the exemplar's patches that are new in its other half.
inline constexpr double natural_novelty = 0.1;

/// Exemplars with more patches than this are compared with every second one of each row and column, every third one
/// and so on.
inline constexpr std::size_t most_known_patches = std::size_t{1} << 16;

class PatchNovelty
{
public:
    /// Patches of side x side pixels; the exemplar must be patch_fits().
    PatchNovelty(const PngPixels& exemplar, int side);
    ~PatchNovelty();
    PatchNovelty(PatchNovelty&&) noexcept;

    /// The squared distance above which a patch is new: 10 % of the patches in halves of the exemplar, at every few
    /// pixels, are farther from all of the other half. Halves are those of the longer side; of a square, west and east.
    double threshold() const;

    /// The share of new patches, of those whose upper left pixels are at multiples of `step`. Given the source of each
    /// pixel in the exemplar, patches that are whole in it count as known wherever they are. The picture has the
    /// exemplar's channels. On any number of threads the same number.
    double share(const PngPixels& picture, int step, std::span<const SourcePixel> sources = {}) const;

private:
    struct Parts;
    std::unique_ptr<const Parts> parts_;
};

/// True if 4 x 4 patches fit into the picture side by side, and so half of them into each of its halves.
bool patch_fits(const PngPixels& exemplar, int side);

}
