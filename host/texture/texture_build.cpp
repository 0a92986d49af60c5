#include "host/texture/texture_build.hpp"

#include "base/errors/errors.hpp"
#include "base/random/random.hpp"
#include "host/texture/corner_texture.hpp"
#include "host/texture/judged_texture.hpp"
#include "host/texture/seam_blending.hpp"
#include "host/texture/tile_levels.hpp"
#include "host/texture/wang_texture.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace poissonlab {
namespace {

// Corner tiles in the manner of Cohen's Wang tiles: four overlapping patches and cuts between them, no new piece.
//
// D. = Lagae, Tile-Based Methods in Computer Graphics, 2007, figure 5.5a, "a straightforward extension of the method of
// Cohen et al.", which has no text. Here each of the four joints from the middle of an edge to the middle of the tile
// is a minimum cut in a band around the straight line, within a quarter of the tile that the diagonals bound; in the
// ring it is straight.

/// A joint from the middle of an edge to the middle of the tile. Its two patches are those of the edge's corners:
/// western and eastern, or northern and southern.
enum class Arm : std::size_t
{
    north,
    south,
    west,
    east,
};
constexpr std::array arms{Arm::north, Arm::south, Arm::west, Arm::east};

/// Corners of a tile in the order north-west, north-east, south-west, south-east.
constexpr std::array<std::array<std::size_t, 2>, 4> arm_corners{{{0, 1}, {2, 3}, {0, 2}, {1, 3}}};

std::array<Color, 4> corners_of(const CornerTile& t)
{
    return {t.north_west, t.north_east, t.south_west, t.south_east};
}

/// The place of a pixel of an arm in the tile: `from_edge` pixels from its edge, `beside` the straight joint.
std::pair<int, int> arm_pixel(Arm arm, int from_edge, int beside, int size)
{
    const int across = size / 2 + beside, far = size - 1 - from_edge;
    switch (arm) {
    case Arm::north:
        return {across, from_edge};
    case Arm::south:
        return {across, far};
    case Arm::west:
        return {from_edge, across};
    case Arm::east:
        break;
    }
    return {far, across};
}

class CrossTexture
{
public:
    CrossTexture(const PngPixels& exemplar, const TextureRequest& request, const std::vector<TextureTile>& tiles,
                 const PieceProgress& progress)
        : exemplar_(exemplar), request_(request), tiles_(tiles), progress_(progress), half_(request.size / 2),
          band_(request.band())
    {}

    TextureSources make()
    {
        const int window = request_.size + 2 * band_;
        if (window > std::min(exemplar_.width, exemplar_.height))
            throw invalid_value({}, "overlap", std::to_string(request_.overlap),
                                "patches with it are larger than the exemplar");
        const int distance = window_distance(exemplar_, window, request_.colors.horizontal, request_.diversity);
        const auto patches = best_patches(window, distance);
        return finished(patches, cuts_of(patches));
    }

private:
    using Windows = std::vector<ExemplarWindow>;

    Windows random_patches(int window, int distance, std::uint32_t attempt) const
    {
        RandomWords words(stream_key(request_.seed, Purpose::texture_windows, 3, attempt), 0);
        UsedWindows used(distance);
        for (Color color = 0; color < request_.colors.horizontal; ++color)
            used.add(used.draw(exemplar_, window, words));
        return used.windows();
    }

    Windows best_patches(int window, int distance) const
    {
        const auto attempts = static_cast<std::size_t>(request_.attempts);
        std::vector<std::int64_t> costs(attempts);
        constexpr std::size_t at_once = 16;
        for (std::size_t first = 0; first < attempts; first += at_once) {
            const std::size_t end = std::min(first + at_once, attempts);
            tbb::parallel_for(first, end, [&](std::size_t i) {
                for (const SeamCut& cut : cuts_of(random_patches(window, distance, static_cast<std::uint32_t>(i))))
                    costs[i] += cut.cost;
            });
            progress_("sets of patches", end, attempts);
        }
        const auto best = std::ranges::min_element(costs) - costs.begin();
        return random_patches(window, distance, static_cast<std::uint32_t>(best));
    }

    /// The pixel of the patch of a corner (0 or 1 along each axis) that a pixel of a tile would show.
    SourcePixel source_of(const ExemplarWindow& patch, std::size_t corner, int x, int y) const
    {
        const int dx = x - (corner % 2 == 0 ? 0 : request_.size), dy = y - (corner / 2 == 0 ? 0 : request_.size);
        return {static_cast<std::uint16_t>(patch.x + patch.size / 2 + dx),
                static_cast<std::uint16_t>(patch.y + patch.size / 2 + dy)};
    }

    /// An arm as it would be of one patch: rows from the edge to the middle.
    PngPixels arm_pixels(const ExemplarWindow& patch, std::size_t corner, Arm arm) const
    {
        PngPixels pixels{2 * band_, half_, exemplar_.channels, {}};
        for (int k = 0; k < half_; ++k)
            for (int beside = -band_; beside < band_; ++beside) {
                const auto [x, y] = arm_pixel(arm, k, beside, request_.size);
                const SourcePixel source = source_of(patch, corner, x, y);
                for (int c = 0; c < exemplar_.channels; ++c)
                    pixels.values.push_back(exemplar_.values[exemplar_.at(source.x, source.y, c)]);
            }
        return pixels;
    }

    std::vector<PixelRole> arm_roles() const
    {
        std::vector<PixelRole> roles;
        for (int k = 0; k < half_; ++k)
            for (int beside = -band_; beside < band_; ++beside) {
                // The outermost columns and what lies beyond the diagonals stay on their sides.
                const int reach = std::min(band_ - 1, half_ - 1 - k);
                const bool is_free = k >= request_.ring_pixels() && beside >= -reach && beside < reach;
                roles.push_back(is_free ? PixelRole::free : beside < 0 ? PixelRole::kept : PixelRole::taken);
            }
        return roles;
    }

    std::size_t cut_number(Arm arm, Color first, Color second) const
    {
        return (static_cast<std::size_t>(arm) * request_.colors.horizontal + first) * request_.colors.horizontal +
               second;
    }

    /// The cuts of all arms and pairs of colours.
    std::vector<SeamCut> cuts_of(const Windows& patches) const
    {
        const std::vector<PixelRole> roles = arm_roles();
        std::vector<SeamCut> cuts(arms.size() * patches.size() * patches.size());
        for (const Arm arm : arms)
            for (Color first = 0; first < patches.size(); ++first)
                for (Color second = 0; second < patches.size(); ++second) {
                    const auto& corners = arm_corners[static_cast<std::size_t>(arm)];
                    cuts[cut_number(arm, first, second)] =
                        minimum_cut(arm_pixels(patches[first], corners[0], arm),
                                    arm_pixels(patches[second], corners[1], arm), roles, request_.weight);
                }
        return cuts;
    }

    /// The corner whose patch a pixel shows.
    std::size_t corner_at(const std::vector<SeamCut>& cuts, const std::array<Color, 4>& colors, int x, int y) const
    {
        const int dx = 2 * x + 1 - request_.size, dy = 2 * y + 1 - request_.size;
        const bool is_horizontal = std::abs(dx) > std::abs(dy);
        const Arm arm = is_horizontal ? (dx < 0 ? Arm::west : Arm::east) : (dy < 0 ? Arm::north : Arm::south);
        const int along = is_horizontal ? x : y, beside = (is_horizontal ? y : x) - half_;
        const auto& [first, second] = arm_corners[static_cast<std::size_t>(arm)];
        if (beside < -band_ || beside >= band_) return beside < 0 ? first : second;
        const int from_edge = std::min(along, request_.size - 1 - along);
        const SeamCut& cut = cuts[cut_number(arm, colors[first], colors[second])];
        return cut.taken[static_cast<std::size_t>(from_edge * 2 * band_ + beside + band_)] ? second : first;
    }

    TextureSources finished(const Windows& patches, const std::vector<SeamCut>& cuts) const
    {
        TextureSources result{{}, 0, patches, patches.size()};
        for (const SeamCut& cut : cuts) result.cost += cut.cost;
        for (const TextureTile& tile : tiles_) {
            const auto colors = corners_of(corner_tile(tile.index, request_.colors.horizontal));
            for (int y = 0; y < request_.size; ++y)
                for (int x = 0; x < request_.size; ++x) {
                    const std::size_t corner = corner_at(cuts, colors, x, y);
                    result.sources.push_back(source_of(patches[colors[corner]], corner, x, y));
                }
        }
        return result;
    }

    const PngPixels& exemplar_;
    const TextureRequest& request_;
    const std::vector<TextureTile>& tiles_;
    const PieceProgress& progress_;
    int half_, band_; ///< pixels: half of a tile's side, half of the width of the overlap
};

/// The arguments and errors are those of make_corner_texture().
TextureSources make_cross_texture(const PngPixels& exemplar, const TextureRequest& request,
                                  const std::vector<TextureTile>& tiles, const PieceProgress& progress)
{
    return CrossTexture(exemplar, request, tiles, progress).make();
}

/// The pixels of each tile by its sources.
std::vector<PngPixels> tiles_of_sources(const PngPixels& exemplar, const TextureSet& set)
{
    std::vector<PngPixels> tiles;
    for (std::size_t i = 0; i < set.tiles.size(); ++i) {
        const auto sources = set.sources_of(i);
        tiles.push_back(canvas_pixels(exemplar, {set.size, {sources.begin(), sources.end()}}));
    }
    return tiles;
}

void smooth(const PngPixels& exemplar, const TextureSources& made, const HarmonicSolver& solve,
            std::vector<PngPixels>& tiles)
{
    GradientDomain domain = made.bow_ties.shown.empty() ? gradient_domain(exemplar, tiles, made.middles)
                                                        : bow_tie_domain(exemplar, tiles[0].width, made.bow_ties);
    solve(domain);
    add_to_tiles(domain, tiles);
}

/// Makes the set in the way that is asked for.
BuiltTexture texture_in_one_way(const TextureRequest& request, const PngPixels& exemplar, const PieceProgress& progress,
                                const HarmonicSolver& solve)
{
    const int width = narrowest_columns(exemplar, request.split);
    if (width < request.size || exemplar.height < request.size)
        throw invalid_value({}, "size", fmt::format("{}", request.size),
                            fmt::format("must be at most the exemplar's, {} x {} pixels", width, exemplar.height));
    BuiltTexture built;
    TextureSet& set = built.set;
    set.kind = request.kind;
    set.colors = request.set_colors();
    set.size = request.size;
    set.ring = request.ring_pixels();
    set.classes = request.classes();
    set.marked_column = request.split;
    set.is_smoothed = request.smooth;
    if (request.smooth && !request.has_corners()) set.ring = 1; // which is all that smoothing leaves alone there
    set.exemplar = exemplar;
    set.tiles = requested_tiles(request);
    set.parameters = parameters_of(request);

    const auto make = request.joint            ? make_joint_texture
                      : !request.has_corners() ? make_wang_texture
                      : request.stages == 0    ? make_cross_texture
                                               : make_corner_texture;
    TextureSources made = make(exemplar, request, set.tiles, progress);
    built.cost = made.cost;
    built.windows = std::move(made.windows);
    built.patches = made.patches;
    built.notes = std::move(made.notes);
    built.is_joint = request.joint;
    set.sources = std::move(made.sources);
    std::vector<PngPixels> tiles = tiles_of_sources(exemplar, set);
    if (request.smooth) smooth(exemplar, made, solve, tiles);
    for (const PngPixels& tile : tiles) set.values.insert(set.values.end(), tile.values.begin(), tile.values.end());
    return built;
}

/// Makes the set; of both ways, where the request says so, the better one.
BuiltTexture chosen_texture(const TextureRequest& request, const PngPixels& exemplar, const PieceProgress& progress,
                            const HarmonicSolver& solve)
{
    BuiltTexture together = texture_in_one_way(request, exemplar, progress, solve);
    together.choice = large_set_note(request);
    if (!request.joint || !request.is_judged) return together;
    TextureRequest one_by_one = request;
    one_by_one.joint = false;
    BuiltTexture apart = texture_in_one_way(one_by_one, exemplar, progress, solve);
    const TilingJudge judge(exemplar, request.size, false);
    const TextureChoice choice =
        better_texture(judge.judge(together.set, request.seed), judge.judge(apart.set, request.seed),
                       2 * request.ring_pixels(), request.size);
    BuiltTexture& kept = choice.is_together ? together : apart;
    kept.choice = choice.words;
    return std::move(kept);
}

void blend_where_asked(const TextureRequest& request, const PngPixels& exemplar, BuiltTexture& built)
{
    if (request.blend ? *request.blend : is_smooth(exemplar) && can_blend(request)) {
        blend_seams(built.set);
        built.set.parameters["blend"] = "true";
        built.notes.push_back(
            fmt::format("seams are blended over {:.0f} pixels{}", fading_length(exemplar, request.size),
                        request.blend ? "" : ", since the picture is smooth (--blend off leaves them)"));
    } else if (!request.blend && !request.smooth && is_smooth(exemplar)) {
        built.notes.push_back(fmt::format("the picture is smooth, but seams are not blended: that {}", blended_sets()));
    }
}

void level_where_asked(const TextureRequest& request, BuiltTexture& built)
{
    if (!request.level.value_or(can_blend(request))) return;
    const SquareVariances before = square_variances(built.set);
    if (!request.level && !before.is_uneven()) return;
    level_tiles(built.set);
    built.set.parameters["level"] = "true";
    built.notes.push_back(fmt::format(
        "the light of tiles is levelled: means over squares of {} pixels had {:.1f} % of the variance, in the picture "
        "{:.1f} %, and have {:.1f} % now{}",
        request.size, 100 * before.tiling, 100 * before.exemplar, 100 * square_variances(built.set).tiling,
        request.level ? "" : " (--level off keeps it)"));
}

}

BuiltTexture build_texture(const TextureRequest& request, const PngPixels& exemplar, const PieceProgress& progress,
                           const HarmonicSolver& solve)
{
    check(request);
    BuiltTexture built = chosen_texture(request, exemplar, progress, solve);
    blend_where_asked(request, exemplar, built);
    level_where_asked(request, built);
    return built;
}

void add_companions(BuiltTexture& built, std::vector<CompanionMap> companions)
{
    built.set.companions = std::move(companions);
    if (built.set.companions.empty()) return;
    if (built.set.is_blended)
        built.notes.emplace_back("seams of companions, and of the exemplar's own numbers, are not blended");
    if (built.set.is_levelled) built.notes.emplace_back("companions, and the exemplar's own numbers, are not levelled");
}

}
