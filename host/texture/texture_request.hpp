// A texture tile set as users ask for it.
#pragma once

#include "base/word_table.hpp"
#include "host/texture/seam_cut.hpp"
#include "tiles/texture/marked_tiles.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace poissonlab {

/// The ways to cut the two samples of a quarter of a Wang tile.
enum class QuiltingCut
{
    minimum_cut, ///< any curve (Ng and others 2005, section 5)
    path,        ///< a path with one place a row (Cohen and others 2003; Efros and Freeman 2001)
};
inline constexpr WordTable<QuiltingCut, 2> quilting_cuts{
    {{{QuiltingCut::minimum_cut, "min-cut"}, {QuiltingCut::path, "path"}}}};

/// The way in which windows are found that are cut for a piece.
enum class PieceSearch
{
    area,    ///< the smallest sums of squared differences over all pixels that may be cut
    circle,  ///< the smallest sums of the cut's costs around the circle (Ng and others 2005, section 3.2)
    middles, ///< these costs near the middles of sides, their alternative
};
inline constexpr WordTable<PieceSearch, 3> piece_searches{
    {{{PieceSearch::area, "area"}, {PieceSearch::circle, "circle"}, {PieceSearch::middles, "middles"}}}};

// Largest values of a request.
inline constexpr int most_texture_colors = 32; ///< of compact Wang tiles; of others 8
inline constexpr int most_texture_candidates = 256;
inline constexpr int most_texture_attempts = 100'000;
inline constexpr int most_joint_rounds = 1000;
/// Larger sets are chosen together only on request. 81 tiles of 64 x 64 pixels take 9 to 20 seconds of processor time,
/// and 81 tiles of 128 x 128 pixels take five times as long.
inline constexpr std::size_t most_tiles_together = 256;
inline constexpr std::size_t most_pixels_together = std::size_t{1} << 21;

inline constexpr double default_core = 0.36;

struct TextureRequest
{
    TextureKind kind = TextureKind::corner;
    WangColors colors;
    std::string tiles;       ///< one of texture_tile_names(); empty: the kind's first
    int size = 64;           ///< T
    std::optional<int> ring; ///< w; T / 16 unless given
    int stages = 3;          ///< corner and omega: 3, 1 as Ng and others have it, or 0: no new piece in a tile
    int candidates = 8;      ///< windows that are cut for a piece
    PieceSearch search = PieceSearch::area;
    std::optional<int> diversity; ///< pixels between any two windows; T / 4 or what fits unless given
    SeamWeight weight = SeamWeight::plain;
    QuiltingCut cut = QuiltingCut::minimum_cut; ///< wang
    /// Part of T: half of the width of the band in which two samples overlap and are cut; Wang tiles, and corner tiles
    /// without new pieces. 0.125 is like Cohen's placement, 0.5 Burke's: samples overlap everywhere (D. figure 5.4).
    double overlap = 0.125;
    int attempts = 100; ///< sets of patches or samples that are drawn, of which the best is taken
    /// Part of T: half of the side of a rounded square (with one stage: the radius of a disk) that the middle of a tile
    /// covers in any case; what pieces around the middles of edges do follows from it. A minimum cut likes to be short,
    /// and would leave of a piece no more than what hides the joint. Unless given default_core with three stages, 0
    /// with one.
    std::optional<double> core;
    /// The exemplar's column where that of marked corners begins; 0: no corners are marked. Corner: the second half of
    /// the colours is theirs, and their patches come from there; a new piece comes from the exemplar of most of its
    /// corners, and where there are as many of both, from either. Wang: tiles are multiplied by the marks of their
    /// corners (marked_tiles.hpp).
    int split = 0;
    bool is_joint_open = false; ///< settle_joint() decides if pieces are chosen together
    bool joint = false;         ///< patches and cuts are chosen for the whole set together (joint/joint_texture.cpp)
    bool is_judged = false;     ///< joint: only if that is better than one piece after another (judged_texture.hpp)
    int rounds = 12;            ///< joint: how often a better window is looked for at each corner, edge and tile
    bool smooth = false;        ///< corner and omega: the middles of tiles take on the colours around them
    std::optional<bool> blend;  ///< seams become slopes (seam_blending.hpp); nothing: where the exemplar is smooth
    std::optional<bool> level;  ///< tiles are equally light (joint/tile_levels.hpp); nothing: where they are uneven
    std::uint64_t seed = 1;

    /// Classes of colours: marked or not.
    int classes() const { return split > 0 ? 2 : 1; }
    /// The colours as the set counts them: those of edges with marks, if there are marks.
    WangColors set_colors() const { return classes() == 2 && !has_corners() ? marked_colors(colors) : colors; }
    double core_radius() const { return core.value_or(stages == 3 ? default_core : 0); }
    int ring_pixels() const { return ring.value_or(std::max(1, size / 16)); }
    int band() const { return std::max(2, static_cast<int>(overlap * size)); }
    bool has_corners() const { return kind != TextureKind::wang; }
};

/// The names of the tile sets of a kind, the default first; "random-marks" is for Wang tiles with marked corners.
const std::vector<std::string>& texture_tile_names(TextureKind kind);

/// Checks everything that does not depend on the exemplar. Throws InputError that begins with the parameter's name.
void check(const TextureRequest& request);

/// Decides whether a set is chosen together where nobody says it: if what is asked for goes with that, and the set is
/// not large.
void settle_joint(TextureRequest& request);

/// A sentence that says that a set is too large to be chosen together by default; empty if its size is not the reason.
std::string large_set_note(const TextureRequest& request);

/// The tiles of the set that is asked for.
std::vector<TextureTile> requested_tiles(const TextureRequest& request);

/// The parameters as texture.json has them.
std::map<std::string, std::string> parameters_of(const TextureRequest& request);

}
