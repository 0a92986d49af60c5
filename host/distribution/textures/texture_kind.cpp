// The kind of [[texture]], and what `texture build` makes: tiles from a picture.
#include "base/errors/errors.hpp"
#include "host/distribution/textures/endless_keys.hpp"
#include "host/distribution/textures/texture_run.hpp"
#include "host/kinds/kinds.hpp"
#include "host/settings/distributions/texture_config.hpp"
#include "host/texture/advice/texture_advice.hpp"
#include "host/texture/exemplar_pictures.hpp"
#include "host/texture/synthetic_exemplar.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

namespace poissonlab {
namespace {

constexpr std::int64_t most_sets = 1000, most_window_side = 64;

const std::vector<std::string>& texture_shows()
{
    static const std::vector<std::string> words{"exemplar", "windows", "steps",     "set",          "marks",
                                                "seams",    "pieces",  "tiling",    "tiling-marks", "tiling-pieces",
                                                "levels",   "plane",   "gradients", "gaussian"};
    return words;
}

/// The names of the tile sets of a kind; of all kinds where they are described.
std::vector<std::string> tile_names(const Keys& keys, TextureKind kind)
{
    std::vector<std::string> names = texture_tile_names(kind);
    if (keys.is_read()) return names;
    for (const auto& [other, word] : texture_kinds.entries)
        for (const std::string& name : texture_tile_names(other))
            if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    return names;
}

/// Sets are chosen together, or made both ways and judged, unless they are large, or something is asked for that cannot
/// be combined with it.
void joint_keys(Keys& keys, TextureRequest& r)
{
    std::optional<bool> asked;
    keys.flag("joint", asked,
              "choose patches and cuts for all tiles together, in some twenty times the time; corners of Wang tiles "
              "fit by it")
        .otherwise(fmt::format("auto, which makes corner and omega tiles in both ways and keeps the better set, and "
                               "chooses Wang tiles together; with more than {} tiles or {} pixels, with stages, weight "
                               "or cut other than the default, and with overlap, smooth or marked_exemplar it is false",
                               most_tiles_together, most_pixels_together));
    r.is_joint_open = keys.is_read() && !asked && !keys.is_given("overlap") && !keys.is_given("marked_exemplar");
    r.joint = asked.value_or(false);
    settle_joint(r);
    keys.integer(
        "rounds", r.rounds, 1, most_joint_rounds,
        "of joint: how often a better window is looked for at each corner, edge and tile; 24 and more hide seams "
        "better and take longer");
    if (!r.joint && keys.is_given("rounds"))
        throw keys.invalid("rounds", "is for tiles that are chosen together, see " + keys.name_of("joint"));
    if (r.joint && keys.is_given("overlap"))
        throw keys.invalid("overlap", "cannot be combined with " + keys.name_of("joint"));
}

/// `is_advised`: by the command, which takes numbers that are not given from the picture.
void request_keys(Keys& keys, TextureRequest& r, bool is_advised = false)
{
    constexpr auto pixels = "pixels";
    Color colors = r.kind == TextureKind::omega ? 4 : 3;
    keys.integer("colors", colors, 2, most_texture_colors, "the number of colours")
        .otherwise(is_advised ? "what texture advise says; of omega tiles 4" : "3; of omega tiles 4");
    std::optional<Color> vertical;
    keys.integer("vertical_colors", vertical, 2, most_texture_colors,
                 "of compact Wang tiles: the number of colours of vertical edges")
        .otherwise("as many as colors");
    r.colors = {colors, vertical.value_or(colors)};
    const std::vector<std::string> names = tile_names(keys, r.kind);
    r.tiles = names.front();
    keys.word("tiles", r.tiles, names, "which tiles").otherwise("the first of the kind: complete or 16");
    auto size = keys.integer("size", r.size, least_tile_pixels, most_tile_pixels, "the side T of a tile").unit(pixels);
    if (is_advised) size.otherwise("what texture advise says");
    keys.integer("ring", r.ring, 0, most_tile_pixels,
                 "the border that depends on shared colours alone, up to T / 5 - 1")
        .unit(pixels)
        .otherwise("T / 16");
    keys.integer(
            "diversity", r.diversity, 0, most_tile_pixels,
            "the distance of the middles of any two windows, up to T; with joint of patches and first pieces alone")
        .unit(pixels)
        .otherwise("T / 4, or what is sure to fit");
    keys.integer("stages", r.stages, 0, 3, "3, 1: without pieces around edges, or 0: without new pieces");
    keys.integer("candidates", r.candidates, 1, most_texture_candidates, "windows that are cut for a piece");
    keys.word("search", r.search, piece_searches,
              "with stages = 1: windows that are cut are those that differ least from the patches in all of the area "
              "that may be cut, or whose costs of cuts are least around the circle or near the middles of sides");
    keys.integer("attempts", r.attempts, 1, most_texture_attempts,
                 "sets of patches that are drawn, of which the best is taken; with joint where patches that are chosen "
                 "together do not fit");
    keys.word("weight", r.weight, seam_weights, "of cuts");
    keys.word("cut", r.cut, quilting_cuts, "of Wang tiles");
    keys.number("overlap", r.overlap, {0.03, 0.5},
                "of Wang tiles and of 0 stages: half of the band in which samples overlap, in tiles");
    keys.number("core", r.core, {0, 0.4},
                "half of the side of a rounded square that the middle of a tile covers, in tiles; with one stage the "
                "radius of a disk")
        .otherwise("0.36, with one stage 0");
    keys.flag("smooth", r.smooth, "give new pieces the colours around them; Wang tiles get seams from it");
    joint_keys(keys, r);
    keys.flag("blend", r.blend,
              "give both sides of each seam a part of their difference, over the length at which the picture changes")
        .otherwise("auto: where the picture is smooth");
    keys.flag("level", r.level, "make tiles equally light by smooth fields that fit together, and change no seam")
        .otherwise("auto: where tiles differ more than squares of the picture");
}

void marked_exemplar_key(Keys& keys, TextureSettings& s)
{
    keys.picture("marked_exemplar", s.marked_exemplar,
                 "the picture around marked corners; those of corner tiles have the second half of the colours")
        .otherwise("no corners are marked");
    if (!s.marked_exemplar.empty() && s.exemplar.empty())
        throw keys.invalid("marked_exemplar", "needs " + keys.name_of("exemplar"));
    s.request.split = s.marked_exemplar.empty() ? 0 : 1; // until the pictures are read
}

/// Wrong companions are said before any work: their headers suffice.
void also_key(Keys& keys, TextureSettings& s)
{
    keys.pictures("also", s.also,
                  "pictures of the exemplar's size, such as normals, roughness and heights, that are cut as it is")
        .otherwise("none");
    if (s.also.empty()) return;
    if (s.exemplar.empty()) throw keys.invalid("also", "needs exemplar");
    if (!s.marked_exemplar.empty())
        throw keys.invalid("also", "cannot be combined with " + keys.name_of("marked_exemplar"));
    keys.check("also", [&] { check_companions(s.exemplar, s.also); });
}

void straighten_key(Keys& keys, TextureSettings& s)
{
    keys.flag("straighten", s.is_straightened,
              "make straight what is regular in the picture, such as courses of bricks, and fit whole ones to a tile; "
              "joints run through with joint");
    if (s.is_straightened && !s.marked_exemplar.empty())
        throw keys.invalid("straighten", "cannot be combined with " + keys.name_of("marked_exemplar"));
}

void flatten_key(Keys& keys, TextureSettings& s)
{
    keys.flag("flatten", s.is_flattened,
              "make the light even that differs over more than a tile: subtract what a Gaussian blur of half a tile "
              "shows, and add the mean")
        .otherwise("auto: where that light has more of the picture's variation than chance gives");
    if (s.is_flattened.value_or(false) && !s.marked_exemplar.empty())
        throw keys.invalid("flatten", "cannot be combined with " + keys.name_of("marked_exemplar"));
}

/// Checks what is asked for with any size and colours that may be advised; the command checks it again with those that
/// are.
void check_open(const TextureSettings& s)
{
    constexpr int largest = 256;
    TextureAdvice advice;
    for (advice.size = 64;; advice.size *= 2) {
        TextureRequest request = s.request;
        take_advice(request, advice, s.is_size_open, s.are_colors_open);
        try {
            return check(request);
        } catch (const InputError&) {
            if (advice.size == largest) throw;
        }
    }
}

void texture_set_keys(Keys& keys, TextureSettings& s)
{
    keys.word("kind", s.request.kind, texture_kinds, "the kind of tiles");
    request_keys(keys, s.request, true);
    s.is_size_open = !keys.is_given("size");
    s.are_colors_open = !keys.is_given("colors") && !keys.is_given("vertical_colors");
    keys.picture("exemplar", s.exemplar, "the picture, of any kind that OpenImageIO reads").required();
    marked_exemplar_key(keys, s);
    also_key(keys, s);
    straighten_key(keys, s);
    flatten_key(keys, s);
    if (keys.is_read()) keys.check([&] { check_open(s); });
}

/// The kind of tiles, or the method that endless textures are made by without tiles.
void kind_key(Keys& keys, TextureSettings& s)
{
    std::vector<std::string> words = texture_kinds.all(s.request.kind);
    std::ranges::copy(endless_methods.all(), std::back_inserter(words));
    std::string word = words.front();
    keys.word("kind", word, words, "the kind of tiles, or another method that makes endless textures");
    if (const auto kind = texture_kinds.find(word)) s.request.kind = *kind;
    if (const auto method = endless_methods.find(word)) s.endless.emplace().method = *method;
}

/// Keys of tiles are no keys of other methods, and the other way round.
void check_keys_of_kind(const Keys& keys, const TextureSettings& s)
{
    const auto refuse = [&](std::initializer_list<const char*> names, const char* allowed) {
        for (const char* name : names)
            if (keys.is_given(name)) throw keys.invalid(name, allowed);
    };
    if (s.endless) {
        refuse(
            {"colors",          "vertical_colors", "tiles", "ring",       "diversity", "search", "stages", "candidates",
             "attempts",        "weight",          "cut",   "overlap",    "core",      "joint",  "rounds", "smooth",
             "marked_exemplar", "marks",           "also",  "straighten", "flatten",   "blend",  "level"},
            "is for tiles: kind = \"corner\", \"wang\" or \"omega\"");
        check_keys_of_method(keys, s.endless->method, "kind");
    } else {
        refuse({"cell", "exponent", "falloff", "gain", "restored", "tileable", "block", "tolerance"},
               "is for kind = \"offsets\", \"hexagons\", \"blended\" or \"quilted\"");
    }
}

/// Without tiles there is nothing to show but the texture and what it is made of.
void check_endless_shows(const Keys& keys, TextureSettings& s)
{
    const std::vector<std::string> shown = endless_shows(s.endless->method);
    if (!keys.is_given("show")) s.show = shown;
    for (const std::string& word : s.show)
        if (std::ranges::find(shown, word) == shown.end())
            throw keys.invalid("show", fmt::format("\"{}\" is not of {}: must be some of {}", word,
                                                   endless_methods[s.endless->method], fmt::join(shown, ", ")));
    if (s.has_timing && s.endless->method == EndlessMethod::quilted)
        throw keys.invalid("timing", "is not for quilted pictures, which are there");
}

/// Levels and views are of complete sets whose tiles have whole levels, marks of marked ones.
void check_texture_shows(const Keys& keys, const TextureSettings& s)
{
    const TextureRequest& request = s.request;
    const bool has_places =
        request.kind == TextureKind::corner ||
        (request.kind == TextureKind::wang && request.tiles == "complete" && request.classes() == 1);
    const bool is_power_of_two = (request.size & (request.size - 1)) == 0, is_mapped = has_places && is_power_of_two;
    if (!is_mapped && s.has_timing)
        throw keys.invalid("timing", "is for complete sets of tiles whose size is a power of two");
    if (!keys.is_given("show")) return;
    const auto is_shown = [&](const char* word) { return std::ranges::find(s.show, word) != s.show.end(); };
    for (const char* word : {"marks", "tiling-marks"})
        if (s.marked_exemplar.empty() && is_shown(word))
            throw keys.invalid("show", fmt::format("\"{}\" needs {}", word, keys.name_of("marked_exemplar")));
    if (!is_mapped && is_shown("levels"))
        throw keys.invalid("show", "\"levels\" is for complete sets of tiles whose size is a power of two");
    if (!is_power_of_two && is_shown("plane"))
        throw keys.invalid("show", "\"plane\" is for tiles whose size is a power of two");
}

void texture_keys(Keys& keys, TextureSettings& s)
{
    kind_key(keys, s);
    request_keys(keys, s.request);
    EndlessRequest described;
    endless_keys(keys, s.endless ? *s.endless : described);
    keys.picture("exemplar", s.exemplar, "the picture, of any kind that OpenImageIO reads").otherwise("a pattern");
    s.pattern = exemplar_patterns().front();
    keys.word("pattern", s.pattern, exemplar_patterns(), "a picture that is made instead")
        .otherwise("none")
        .excludes("exemplar");
    if (!s.exemplar.empty()) s.pattern.clear();
    if (keys.is_read() && s.exemplar.empty() && !keys.is_given("pattern"))
        throw keys.problem("needs exemplar, a picture's file, or pattern");
    keys.integer("pattern_size", s.pattern_size, 16, 4096, "the side of a pattern").unit("pixels");
    marked_exemplar_key(keys, s);
    also_key(keys, s);
    straighten_key(keys, s);
    flatten_key(keys, s);
    keys.picture("marks", s.marks, "a picture over the window, whose lighter part is marked")
        .otherwise("corners are marked at random");
    if (!s.marks.empty() && s.marked_exemplar.empty())
        throw keys.invalid("marks", "needs " + keys.name_of("marked_exemplar"));
    if (keys.is_read()) keys.check([&] { check(s.request); });
    keys.integer("sets", s.sets, 1, most_sets, "sets with other patches each, over which measures are averaged");
    std::vector<std::int64_t> window{static_cast<std::int64_t>(s.columns), static_cast<std::int64_t>(s.rows)};
    keys.whole_numbers("window", window, 1, {"width", "height"}, "the tiles of the tiling that is drawn");
    if (std::ranges::max(window) > most_window_side)
        throw keys.invalid("window", "must have at most 64 tiles along each side");
    s.columns = static_cast<std::uint64_t>(window[0]);
    s.rows = static_cast<std::uint64_t>(window[1]);
    s.show = {"exemplar", "set", "seams", "pieces", "tiling", "levels", "plane", "gradients"};
    keys.words("show", s.show, texture_shows(), "the pictures");
    keys.flag("timing", s.has_timing, "whether frames a second, and nanoseconds a pixel, are measured");
    keys.flag("compare", s.is_compared,
              "whether colours, contrast, gradients, structure and repetition are compared with the exemplar's own");
    check_keys_of_kind(keys, s);
    if (s.endless) {
        check_endless_shows(keys, s);
        check_exemplar_size(keys, *s.endless, s.exemplar, s.pattern_size);
    } else {
        check_texture_shows(keys, s);
    }
}

std::string texture_label(const TextureSettings& settings)
{
    const TextureRequest& request = settings.request;
    const std::string picture = settings.pattern.empty() ? settings.exemplar.stem().string() : settings.pattern;
    if (settings.endless) return endless_label(*settings.endless, printable(picture));
    const char* const kind = request.kind == TextureKind::corner ? "corner tiles"
                             : request.kind == TextureKind::wang ? "Wang tiles"
                                                                 : "omega tiles";
    std::string label = fmt::format("{}: {} {}", printable(picture), requested_tiles(request).size(), kind);
    label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])));
    if (request.has_corners() && request.stages == 1) label += ", one stage";
    if (request.has_corners() && request.stages == 0) label += ", no new pieces";
    if (!settings.marked_exemplar.empty())
        label += fmt::format(", {} at marked corners", printable(settings.marked_exemplar.stem().string()));
    if (settings.is_straightened) label += ", straightened";
    if (settings.is_flattened) label += *settings.is_flattened ? ", flattened" : ", light as it is";
    if (request.joint && !request.is_judged) label += ", chosen together";
    if (request.smooth) label += ", smoothed";
    if (request.blend) label += *request.blend ? ", blended" : ", not blended";
    if (request.weight == SeamWeight::gradient) label += ", gradient weights";
    if (!request.has_corners() && request.cut == QuiltingCut::path) label += ", paths";
    return label;
}

}

Kind texture_kind()
{
    return make_kind<TextureSettings>(
        {"texture", "", "", "Texture tiles", "Make texture tiles, and measure their seams"}, texture_keys,
        texture_label, make_texture);
}

Kind texture_set_kind()
{
    return make_kind<TextureSettings>(
        {"", "texture build", "texture build", "Texture tile set", "Make texture tiles from a picture"},
        texture_set_keys, texture_label, make_texture);
}

}
