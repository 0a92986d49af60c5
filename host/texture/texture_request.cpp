#include "host/texture/texture_request.hpp"

#include "base/errors/errors.hpp"
#include "host/texture/seam_blending.hpp"
#include "tiles/tilings/tile_set.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace poissonlab {
namespace {

/// The name of the half of marked compact Wang tiles that suffices for marks at random.
constexpr auto random_marks = "random-marks";

// Ng and others 2005, figures 8a and 8b: corners top-left, bottom-left, top-right, bottom-right.
constexpr std::array<std::string_view, 16> figure_8a{"BRYG", "BYRG", "BRRB", "BYYR", "RBGY", "RGBY", "RBBR", "RGGB",
                                                     "YGRB", "YRGB", "YGGY", "YRRG", "GYBR", "GBYR", "GYYG", "GBBY"};
constexpr std::array<std::string_view, 16> figure_8b{"BYRG", "BRYG", "BRRB", "BYYB", "GYRB", "GRYB", "GRRG", "GYYG",
                                                     "RBBY", "RGBR", "RGGY", "RBGR", "YBGY", "YGBY", "YGGR", "YBBR"};

// Figure 7 draws sets of 4 and 8 without listing them. These are the periodic pattern RG over BY, and rows of RG and BY
// by turns, each beginning with either colour.
constexpr std::array<std::string_view, 4> four_tiles{"RBGY", "GYRB", "BRYG", "YGBR"};
constexpr std::array<std::string_view, 8> eight_tiles{"RBGY", "GYRB", "BRYG", "YGBR", "RYGB", "GBRY", "BGYR", "YRBG"};

Color color_of_letter(char letter) { return static_cast<Color>(std::string_view("RGBY").find(letter)); }

/// Tiles of one set, `variants` of each.
std::vector<TextureTile> tiles_of_letters(std::span<const std::string_view> letters, std::uint32_t variants)
{
    std::vector<TextureTile> tiles;
    for (const std::string_view corners : letters)
        for (std::uint32_t variant = 0; variant < variants; ++variant)
            tiles.push_back({corner_index({color_of_letter(corners[2]), color_of_letter(corners[3]),
                                           color_of_letter(corners[1]), color_of_letter(corners[0])},
                                          4),
                             variant});
    return tiles;
}

std::vector<TextureTile> omega_tiles(const std::string& name)
{
    const std::uint32_t variants = name == "32" || name.ends_with("-doubled") ? 2 : 1;
    if (name.starts_with("4")) return tiles_of_letters(four_tiles, variants);
    if (name.starts_with("8")) return tiles_of_letters(eight_tiles, variants);
    return tiles_of_letters(name.starts_with("16b") ? figure_8b : figure_8a, variants);
}

/// Cohen's sets of 8, 12 and 18 tiles: two for each pair of northern and western colours (Cohen and others 2003,
/// section 2, who leave open which).
std::vector<TextureTile> compact_tiles(WangColors colors)
{
    std::vector<TextureTile> tiles;
    if (colors.horizontal != colors.vertical) {
        const TileSet set = compact_wang_set(colors);
        for (std::uint64_t i = 0; i < set.size(); ++i) tiles.push_back({set.index(i), 0});
        return tiles;
    }
    const Color c = colors.horizontal;
    for (Color north = 0; north < c; ++north)
        for (Color west = 0; west < c; ++west)
            for (Color k = 0; k < 2; ++k)
                tiles.push_back({wang_index({north, (north + k) % c, (west + k) % c, west}, colors), 0});
    return tiles;
}

std::vector<TextureTile> complete_tiles(const TextureRequest& r)
{
    const TileSet all = TileSet::complete(r.kind == TextureKind::corner ? TileKind::corner : TileKind::wang, r.colors);
    std::vector<TextureTile> tiles;
    for (std::uint64_t i = 0; i < all.size(); ++i) tiles.push_back({all.index(i), 0});
    return tiles;
}

void refuse(const std::string& key, const std::string& value, const std::string& allowed)
{
    throw invalid_value({}, key, value, allowed);
}

void check_range(const std::string& key, int value, int lowest, int highest)
{
    if (value >= lowest && value <= highest) return;
    const std::string allowed = highest == lowest       ? fmt::format("{}", lowest)
                                : highest == lowest + 1 ? fmt::format("{} or {}", lowest, highest)
                                                        : fmt::format("an integer from {} to {}", lowest, highest);
    refuse(key, std::to_string(value), "must be " + allowed);
}

/// Joint sets are made in stages of their own, by moves that need a distance of windows.
void check_joint(const TextureRequest& r)
{
    if (!r.joint) return;
    check_range("rounds", r.rounds, 1, most_joint_rounds);
    if (r.split > 0) refuse("joint", "true", "is for sets without marked corners");
    if (r.stages != 3) refuse("joint", "true", "needs stages = 3");
    if (r.weight != SeamWeight::plain) refuse("joint", "true", "needs weight = plain");
    if (r.cut != QuiltingCut::minimum_cut) refuse("joint", "true", "needs cut = min-cut");
    if (r.smooth) refuse("joint", "true", "cannot be combined with smooth");
}

/// All pixels of a set.
std::size_t pixels_of(const TextureRequest& r)
{
    return requested_tiles(r).size() * static_cast<std::size_t>(r.size) * static_cast<std::size_t>(r.size);
}

bool is_compact(const TextureRequest& r)
{
    return r.kind == TextureKind::wang && (r.tiles == "compact" || r.tiles == random_marks);
}

/// True if nothing is asked for that cannot be combined with pieces that are chosen together.
bool goes_with_joint(const TextureRequest& r)
{
    if (r.colors.horizontal != r.colors.vertical && !is_compact(r)) return false; // check() refuses these
    return r.split == 0 && r.stages == 3 && r.weight == SeamWeight::plain && r.cut == QuiltingCut::minimum_cut &&
           !r.smooth;
}

bool is_large(const TextureRequest& r)
{
    return requested_tiles(r).size() > most_tiles_together || pixels_of(r) > most_pixels_together;
}

void check_marks(const TextureRequest& r)
{
    if (r.tiles == random_marks && r.split == 0) refuse("tiles", r.tiles, "needs an exemplar for marked corners");
    if (r.split == 0) return;
    if (r.kind == TextureKind::omega)
        refuse("kind", texture_kinds[r.kind], "has no marked corners: must be corner or wang");
    if (r.kind == TextureKind::corner && (r.stages == 0 || r.colors.horizontal % 2 != 0))
        refuse("colors", std::to_string(r.colors.horizontal),
               "with marked corners there are corner tiles over an even number, made with stages 1 or 3");
    if (r.kind == TextureKind::wang && r.smooth) refuse("smooth", "true", "is for Wang tiles without marked corners");
}

void check_colors_of(const TextureRequest& r)
{
    const bool is_square = r.colors.horizontal == r.colors.vertical;
    const bool is_marked_wang = r.kind == TextureKind::wang && r.classes() == 2;
    const Color most = is_compact(r) && !is_marked_wang ? most_texture_colors : 8;
    for (const Color colors : {r.colors.horizontal, r.colors.vertical})
        check_range("colors", static_cast<int>(colors), 2, static_cast<int>(most));
    if (r.kind == TextureKind::omega && (r.colors.horizontal != 4 || !is_square))
        refuse("colors", std::to_string(r.colors.horizontal), "must be 4 for omega tiles");
    if (!is_square && !is_compact(r))
        refuse("vertical_colors", std::to_string(r.colors.vertical), "is for compact Wang tiles");
}

}

const std::vector<std::string>& texture_tile_names(TextureKind kind)
{
    static const std::vector<std::string> corner{"complete"}, wang{"complete", "compact", random_marks},
        omega{"16", "4", "8", "16b", "32", "4-doubled", "8-doubled", "16b-doubled"};
    return kind == TextureKind::corner ? corner : kind == TextureKind::wang ? wang : omega;
}

void check(const TextureRequest& r)
{
    const std::vector<std::string>& names = texture_tile_names(r.kind);
    if (!r.tiles.empty() && std::ranges::find(names, r.tiles) == names.end())
        refuse("tiles", r.tiles, fmt::format("must be one of {}", fmt::join(names, ", ")));
    check_colors_of(r);
    if (r.size % 2 != 0) refuse("size", std::to_string(r.size), "must be even");
    check_range("size", r.size, least_tile_pixels, most_tile_pixels);
    // The disks around the middles of edges reach to 0.3 T, those around the middle up to the ring.
    const int most_ring = std::max(1, r.size / 5 - 1);
    check_range("ring", r.ring_pixels(), r.has_corners() && r.stages == 1 ? 0 : 1, most_ring);
    if (r.stages != 0 && r.stages != 1 && r.stages != 3)
        refuse("stages", std::to_string(r.stages), "must be 0, 1 or 3");
    if (!(r.overlap >= 0.03 && r.overlap <= 0.5))
        refuse("overlap", fmt::format("{}", r.overlap), "must be a number from 0.03 to 0.5");
    if (r.search != PieceSearch::area && !(r.has_corners() && r.stages == 1))
        refuse("search", piece_searches[r.search], "is for corner and omega tiles with stages = 1");
    check_range("candidates", r.candidates, 1, most_texture_candidates);
    if (r.diversity) check_range("diversity", *r.diversity, 0, r.size);
    check_range("attempts", r.attempts, 1, most_texture_attempts);
    if (!(r.core_radius() >= 0 && r.core_radius() <= 0.4))
        refuse("core", fmt::format("{}", r.core_radius()), "must be a number from 0 to 0.4");
    check_marks(r);
    check_joint(r);
    if (r.smooth && r.stages == 0) refuse("smooth", "true", "needs new pieces: stages 1 or 3");
    if (r.smooth && r.ring_pixels() == 0) refuse("smooth", "true", "needs a ring of at least 1 pixel");
    if (r.blend.value_or(false) && !can_blend(r)) refuse("blend", "true", blended_sets());
    if (r.level.value_or(false) && !can_blend(r)) refuse("level", "true", blended_sets());
    const std::size_t pixels = pixels_of(r);
    if (pixels > most_atlas_pixels)
        refuse("size", std::to_string(r.size),
               fmt::format("all tiles have {} pixels: must be at most {}", pixels, most_atlas_pixels));
}

void settle_joint(TextureRequest& r)
{
    if (!r.is_joint_open) return;
    r.joint = goes_with_joint(r) && !is_large(r);
    r.is_judged = r.joint && r.has_corners(); // the corners of Wang tiles fit by joint choice alone
}

std::string large_set_note(const TextureRequest& r)
{
    if (!r.is_joint_open || !goes_with_joint(r) || !is_large(r)) return "";
    return fmt::format("Fitted one after another: by default {} tiles of {} x {} pixels are too many to be chosen "
                       "together",
                       requested_tiles(r).size(), r.size, r.size);
}

std::vector<TextureTile> requested_tiles(const TextureRequest& r)
{
    if (r.kind == TextureKind::omega) return omega_tiles(r.tiles.empty() ? "16" : r.tiles);
    const std::vector<TextureTile> tiles = is_compact(r) ? compact_tiles(r.colors) : complete_tiles(r);
    if (r.classes() == 1 || r.kind != TextureKind::wang) return tiles;
    return r.tiles == random_marks ? randomly_marked_wang_tiles(tiles, r.colors) : marked_wang_tiles(tiles, r.colors);
}

std::map<std::string, std::string> parameters_of(const TextureRequest& r)
{
    std::map<std::string, std::string> parameters{
        {"tiles", r.tiles.empty() ? texture_tile_names(r.kind).front() : r.tiles},
        {"weight", seam_weights[r.weight]},
        {"attempts", std::to_string(r.attempts)},
        {"diversity", r.diversity ? std::to_string(*r.diversity) : "automatic"},
        {"seed", std::to_string(r.seed)},
    };
    if (r.joint) {
        parameters["joint"] = "true";
        parameters["rounds"] = std::to_string(r.rounds);
    }
    if (r.kind == TextureKind::wang && !r.joint) {
        parameters["cut"] = quilting_cuts[r.cut];
        parameters["overlap"] = fmt::format("{}", r.overlap);
    } else {
        if (r.has_corners()) parameters["stages"] = std::to_string(r.stages);
        parameters["candidates"] = std::to_string(r.candidates);
        if (r.search != PieceSearch::area) parameters["search"] = piece_searches[r.search];
        if (r.stages == 0) parameters["overlap"] = fmt::format("{}", r.overlap);
        parameters["core"] = fmt::format("{}", r.core_radius());
    }
    return parameters;
}

}
