// A judgement of a texture set by what its cuts do not optimise: patches that are like nothing in the exemplar, light
// that changes over more than a tile, and fragments smaller than what the exemplar shows.
#pragma once

#include "tiles/texture/patch_novelty.hpp"
#include "tiles/texture/tiling_measures.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace poissonlab {

/// The side in pixels of the smallest squares whose means have at most half of the variance of pixels: about the size
/// of what a picture shows. The mean over channels is what counts. At most half of the shorter side.
int feature_side(const PngPixels& exemplar);

/// The side of the patches that are compared in all exemplars, where it fits.
inline constexpr int judged_patch = 27;

/// The keys of the shares of new patches: small ones, judged_patch, large ones.
inline constexpr std::array judged_keys{"novelty_small", "novelty", "novelty_large"};

struct TilingJudgement
{
    std::array<std::optional<double>, 3> novelty; ///< shares of patches that are new, by judged_keys
    std::array<int, 3> sides{};                   ///< of those patches
    std::optional<SlowPower> slow;
    int feature = 1; ///< feature_side() of the exemplar
    /// A tile: what is whole in the exemplar, and smaller than a square of that side; nothing for features larger than
    /// half of a tile, which no tile can have whole.
    std::optional<double> fragments;
};

class TilingJudge
{
public:
    /// For tiles of size x size pixels from one exemplar; with patches of all sides, or of judged_patch alone.
    TilingJudge(const PngPixels& exemplar, int size, bool has_all_sides = true);

    /// Judges the tiling by a seed. Patches of smoothed sets are looked for as those of any picture.
    TilingJudgement judge(const TextureSet& set, std::uint64_t seed) const;

private:
    const PngPixels& exemplar_;
    int size_, feature_;
    std::array<int, 3> sides_; ///< of patches: small ones, judged_patch, and large ones, by feature_side()
    std::array<std::optional<PatchNovelty>, 3> patches_;
};

/// Judges a set by its own exemplar. Nothing for sets of several exemplars side by side, whose halves differ.
std::optional<TilingJudgement> judged_tiling(const TextureSet& set, std::uint64_t seed);

/// Counts the fragments of a picture that have fewer than `pixels` pixels and do not touch its border. A fragment is a
/// connected set of pixels whose neighbours are neighbours in the exemplar as well. `sources` lists pixels row by row.
std::size_t small_fragments(std::span<const SourcePixel> sources, int width, std::size_t pixels);

}
