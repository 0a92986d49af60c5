#include "host/config/distributions/texture_table.hpp"

#include "base/files/file_kind.hpp"
#include "host/config/config_values.hpp"
#include "host/config/nearest_key.hpp"
#include "host/texture/synthetic_exemplar.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

namespace poissonlab {
namespace {

constexpr std::int64_t most_sets = 1000, most_window_side = 64;

Color read_texture_colors(const ConfigTable& table, const std::string& key, Color otherwise)
{
    return static_cast<Color>(read_integer(table, key, 2, most_texture_colors, otherwise));
}

int read_texture_pixels(const ConfigTable& table, const std::string& key, int otherwise)
{
    return static_cast<int>(read_integer(table, key, 0, most_exemplar_pixels, otherwise));
}

TextureRequest read_request(const ConfigTable& table, std::uint64_t seed)
{
    TextureRequest request;
    request.kind = read_word(table, "kind", texture_kinds, request.kind);
    const Color colors = read_texture_colors(table, "colors", request.kind == TextureKind::omega ? 4 : 3);
    request.colors = {colors, read_texture_colors(table, "vertical_colors", colors)};
    request.tiles = texture_tile_names(request.kind)[read_word(table, "tiles", texture_tile_names(request.kind))];
    request.size = read_texture_pixels(table, "size", request.size);
    if (find(table, "ring")) request.ring = read_texture_pixels(table, "ring", 0);
    if (find(table, "diversity")) request.diversity = read_texture_pixels(table, "diversity", 0);
    request.stages = static_cast<int>(read_integer(table, "stages", 0, 3, request.stages));
    request.candidates =
        static_cast<int>(read_integer(table, "candidates", 1, most_texture_candidates, request.candidates));
    request.attempts = static_cast<int>(read_integer(table, "attempts", 1, most_texture_attempts, request.attempts));
    request.weight = read_word(table, "weight", seam_weights, request.weight);
    request.cut = read_word(table, "cut", quilting_cuts, request.cut);
    request.overlap = read_number(table, "overlap", 0.03, 0.5, request.overlap);
    if (find(table, "core")) request.core = read_number(table, "core", 0, 0.4, 0);
    request.smooth = read_flag(table, "smooth", false);
    request.seed = seed;
    return request;
}

/// A picture by its path from the config's folder; empty where the table lacks the key.
std::filesystem::path read_picture(const ConfigTable& table, const std::string& key, DistributionConfig& config)
{
    const ConfigNode* const node = find(table, key);
    if (!node) return {};
    const std::filesystem::path file =
        std::filesystem::path(config.where.file).parent_path() / read_text(table, key, "");
    if (const std::string lack = lack_of_file(file); !lack.empty())
        throw invalid_node(key, *node,
                           fmt::format("{}: must be a picture's file, by its path from the config's folder", lack));
    config.inputs.push_back(file);
    return file;
}

/// The exemplar of marked corners, and which ones are.
void read_marks(const ConfigTable& table, DistributionConfig& config, TextureSettings& settings)
{
    settings.marked_exemplar = read_picture(table, "marked_exemplar", config);
    settings.marks = read_picture(table, "marks", config);
    if (!settings.marks.empty() && settings.marked_exemplar.empty())
        throw invalid_node("marks", *find(table, "marks"), "needs marked_exemplar");
    if (!settings.marked_exemplar.empty() && settings.exemplar.empty())
        throw invalid_node("marked_exemplar", *find(table, "marked_exemplar"), "needs exemplar");
}

void read_exemplar_choice(const ConfigTable& table, DistributionConfig& config, TextureSettings& settings)
{
    const ConfigNode* const pattern = find(table, "pattern");
    if (!find(table, "exemplar") == !pattern)
        throw InputError::at(config.where, "[[texture]]: needs exemplar, a picture's file, or pattern");
    settings.pattern_size = static_cast<int>(read_integer(table, "pattern_size", 16, 4096, settings.pattern_size));
    if (pattern) {
        settings.pattern = exemplar_patterns()[read_word(table, "pattern", exemplar_patterns())];
        return;
    }
    settings.exemplar = read_picture(table, "exemplar", config);
}

std::vector<std::string> read_shows(const ConfigTable& table)
{
    const ConfigNode* const node = find(table, "show");
    if (!node) return {"exemplar", "set", "seams", "pieces", "tiling", "levels", "gradients"};
    const auto* const list = node->get_if<ConfigList>();
    std::vector<std::string> shows;
    if (list)
        for (const ConfigNode& item : *list)
            if (const auto* word = item.get_if<std::string>();
                word && std::ranges::find(texture_shows(), *word) != texture_shows().end())
                shows.push_back(*word);
    if (!list || list->empty() || shows.size() != list->size())
        throw invalid_node("show", *node, fmt::format("must be a list of {}", fmt::join(texture_shows(), ", ")));
    return shows;
}

/// Levels and views are of complete sets whose tiles have whole levels, marks of marked ones.
void check_shows(const ConfigTable& table, const TextureSettings& settings)
{
    const TextureRequest& request = settings.request;
    const bool has_places =
        request.kind == TextureKind::corner ||
        (request.kind == TextureKind::wang && request.tiles == "complete" && request.classes() == 1);
    const bool is_mapped = has_places && (request.size & (request.size - 1)) == 0;
    if (!is_mapped && settings.has_timing)
        throw invalid_node("timing", *find(table, "timing"),
                           "is for complete sets of tiles whose size is a power of two");
    if (!find(table, "show")) return;
    for (const char* word : {"marks", "tiling-marks"})
        if (settings.marked_exemplar.empty() && std::ranges::find(settings.show, word) != settings.show.end())
            throw invalid_node("show", *find(table, "show"), fmt::format("\"{}\" needs marked_exemplar", word));
    for (const char* word : {"levels", "plane"})
        if (!is_mapped && std::ranges::find(settings.show, word) != settings.show.end())
            throw invalid_node("show", *find(table, "show"),
                               fmt::format("\"{}\" is for complete sets of tiles whose size is a power of two", word));
}

std::string texture_label(const TextureSettings& settings)
{
    const TextureRequest& request = settings.request;
    const std::string picture = settings.pattern.empty() ? settings.exemplar.stem().string() : settings.pattern;
    const char* const kind = request.kind == TextureKind::corner ? "corner tiles"
                             : request.kind == TextureKind::wang ? "Wang tiles"
                                                                 : "omega tiles";
    std::string label = fmt::format("{}: {} {}", printable(picture), requested_tiles(request).size(), kind);
    label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])));
    if (request.has_corners() && request.stages == 1) label += ", one stage";
    if (request.has_corners() && request.stages == 0) label += ", no new pieces";
    if (!settings.marked_exemplar.empty())
        label += fmt::format(", {} at marked corners", printable(settings.marked_exemplar.stem().string()));
    if (request.smooth) label += ", smoothed";
    if (request.weight == SeamWeight::plain) label += ", plain weights";
    if (!request.has_corners() && request.cut == QuiltingCut::path) label += ", paths";
    return label;
}

DistributionConfig read_texture_table(const ConfigNode& node, std::uint64_t seed)
{
    const ConfigTable& table = *node.get_if<ConfigTable>();
    check_keys(table, {"kind",     "colors",     "vertical_colors",
                       "tiles",    "exemplar",   "marked_exemplar",
                       "marks",    "pattern",    "pattern_size",
                       "size",     "ring",       "diversity",
                       "stages",   "weight",     "cut",
                       "core",     "smooth",     "overlap",
                       "attempts", "candidates", "sets",
                       "window",   "show",       "timing",
                       "label"});
    DistributionConfig config;
    config.kind = "texture";
    config.where = node.location;
    config.seed = seed;
    config.text = text_of(table);
    TextureSettings settings;
    settings.request = read_request(table, seed);
    read_exemplar_choice(table, config, settings);
    read_marks(table, config, settings);
    if (!settings.marked_exemplar.empty()) settings.request.split = 1; // until the pictures are read
    try {
        check(settings.request);
    } catch (const InputError& error) {
        throw error.moved_to(node.location);
    }
    settings.sets = static_cast<int>(read_integer(table, "sets", 1, most_sets, settings.sets));
    const auto window =
        read_integers(table, "window", 2, 2, 1, "[width, height], in tiles, at most 64 along each side");
    if (!window.empty()) {
        if (std::ranges::max(window) > most_window_side)
            throw invalid_node("window", *find(table, "window"), "must have at most 64 tiles along each side");
        settings.columns = static_cast<std::uint64_t>(window[0]);
        settings.rows = static_cast<std::uint64_t>(window[1]);
    }
    settings.show = read_shows(table);
    settings.has_timing = read_flag(table, "timing", false);
    check_shows(table, settings);
    config.label = read_text(table, "label", texture_label(settings));
    config.settings = std::move(settings);
    return config;
}

}

const std::vector<std::string>& texture_shows()
{
    static const std::vector<std::string> words{"exemplar", "windows", "steps",    "set",          "marks",
                                                "seams",    "pieces",  "tiling",   "tiling-marks", "tiling-pieces",
                                                "levels",   "plane",   "gradients"};
    return words;
}

std::vector<DistributionConfig> read_textures(const std::vector<ConfigNode>& tables, std::uint64_t seed)
{
    std::vector<DistributionConfig> textures;
    for (const ConfigNode& node : tables) textures.push_back(read_texture_table(node, seed));
    return textures;
}

}
