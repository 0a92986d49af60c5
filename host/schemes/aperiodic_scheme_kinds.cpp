// The kinds of [[scheme]] that are about aperiodic sets and surfaces.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, chapter 8.
#include "host/kinds/kinds.hpp"
#include "host/schemes/scheme_run.hpp"
#include "tiles/tilings/scanline_tiling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// A tiling with Wang or corner tiles by the word of its algorithm, if it is one.
std::optional<TilingRequest> request_of_word(const std::string& word, Color colors)
{
    TilingRequest request;
    request.algorithm = word;
    for (const TileKind kind : {TileKind::wang, TileKind::corner}) {
        const auto& known = tiling_algorithms(kind);
        if (std::ranges::find(known, word) == known.end()) continue;
        request.kind = kind;
        const Color own = own_colors(kind, word);
        request.colors = own > 0 ? own : colors;
        return request;
    }
    return std::nullopt;
}

void lattice_keys(Keys& keys, ConstructionSettings& s)
{
    keys.word("set", s.set, {"ammann", "culik", "kari"}, "the Wang tiles");
    keys.word("construction", s.construction, corner_constructions, "what makes corner tiles of them");
    std::array<std::uint32_t, 2> size{static_cast<std::uint32_t>(s.width), static_cast<std::uint32_t>(s.height)};
    keys.integers("window", size, {1, 8}, {"width", "height"}, "Wang tiles that are drawn");
    s.width = size[0];
    s.height = size[1];
}

void aperiodic_table_keys(Keys& keys, AperiodicTableSettings& s)
{
    constexpr std::int64_t widest = 8; // 214 tiles take seconds there, and several times as long for each one more
    keys.integer("width", s.width, 1, widest, "the widest cylinder of the search for periods");
}

/// The tilings by their words, which are different ones.
void read_words_of_tilings(const Keys& keys, const ConfigNode& node, std::vector<std::string>& words)
{
    constexpr auto allowed = "must be a list of different algorithms of Wang or corner tiles";
    words.clear();
    const auto* items = node.get_if<ConfigList>();
    if (!items || items->empty()) throw keys.invalid("tilings", allowed);
    for (const ConfigNode& item : *items) {
        const auto* word = item.get_if<std::string>();
        if (!word || std::ranges::find(words, *word) != words.end()) throw keys.invalid("tilings", allowed);
        if (!request_of_word(*word, 2))
            throw keys.invalid("tilings", fmt::format("{}; \"{}\" is none", allowed, *word));
        words.push_back(*word);
    }
}

void diffraction_keys(Keys& keys, DiffractionSettings& s)
{
    constexpr std::int64_t least_size = 256, most_size = 1024; // the pictures show 256 tiles along each side
    std::vector<std::string> words{"scanline-compact", "ammann"};
    keys.value("tilings", "a list of algorithms of Wang or corner tiles", "what is compared",
               [&](const ConfigNode& node) { read_words_of_tilings(keys, node, words); })
        .otherwise("scanline-compact, ammann");
    Color colors = 2;
    keys.integer("colors", colors, 2, max_scanline_colors, "of those that can have several");
    keys.integer("size", s.size, least_size, most_size, "tiles along each axis");
    Color fewest = max_colors;
    s.tilings.clear();
    for (const std::string& word : words) {
        s.tilings.push_back(*request_of_word(word, colors));
        fewest = std::min(fewest, s.tilings.back().colors);
    }
    keys.integer("color", s.color, 0, fewest - 1, "whose power is shown");
}

void surface_keys(Keys& keys, SurfaceSettings& s)
{
    constexpr auto allowed = "a list of different cubes [x, y, z], at most 1000, from -50 to 50";
    constexpr double farthest = 50;
    constexpr std::size_t most_cubes = 1000;
    keys.integer("colors", s.colors, 2, 8, "of the surface's vertices");
    s.cubes = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 1}};
    const auto read = [&](const ConfigNode& node) {
        const auto refused = [&] { return keys.invalid("cubes", std::string("must be ") + allowed); };
        const auto* cubes = node.get_if<ConfigList>();
        if (!cubes || cubes->empty() || cubes->size() > most_cubes) throw refused();
        s.cubes.clear();
        for (const ConfigNode& cube : *cubes) {
            const auto place = numbers_of_list(cube);
            const auto is_wrong = [](double c) { return c != std::floor(c) || std::abs(c) > farthest; };
            if (!place || place->size() != 3 || std::ranges::any_of(*place, is_wrong)) throw refused();
            s.cubes.push_back(
                {static_cast<int>((*place)[0]), static_cast<int>((*place)[1]), static_cast<int>((*place)[2])});
        }
        std::ranges::sort(s.cubes);
        if (std::ranges::adjacent_find(s.cubes) != s.cubes.end()) throw refused();
    };
    keys.value("cubes", allowed, "the polycube", read).otherwise("six of them");
}

}

Kind lattice_construction_kind()
{
    return make_kind<ConstructionSettings>(
        {"scheme", "construction", "", "Lattices of constructions",
         "Draw Wang tiles, and the corner tiles that are made of them", false},
        lattice_keys,
        [](const ConstructionSettings& s) {
            return fmt::format("The {} construction", corner_constructions[s.construction]);
        },
        make_construction);
}

Kind aperiodic_table_kind()
{
    return make_kind<AperiodicTableSettings>(
        {"scheme", "aperiodic-tables", "", "Aperiodic sets",
         "Compare printed tables of aperiodic sets with computed ones", false},
        aperiodic_table_keys,
        [](const AperiodicTableSettings&) { return std::string("Sets of corner tiles made of aperiodic sets"); },
        [](const AperiodicTableSettings& s, std::uint64_t, DistributionFiles& files) {
            return make_aperiodic_tables(s, files);
        });
}

Kind diffraction_kind()
{
    return make_kind<DiffractionSettings>(
        {"scheme", "diffraction", "", "Diffraction", "Measure how much tilings repeat", false}, diffraction_keys,
        [](const DiffractionSettings&) { return std::string("Aperiodic and stochastic tilings"); },
        [](const DiffractionSettings& s, std::uint64_t seed, DistributionFiles& files) {
            DiffractionSettings own = s;
            for (TilingRequest& request : own.tilings) request.seed = seed;
            return make_diffraction(own, files);
        });
}

Kind surface_kind()
{
    return make_kind<SurfaceSettings>(
        {"scheme", "surface", "", "Tiled surface", "Draw corner tiles on the faces of a polycube", false}, surface_keys,
        [](const SurfaceSettings&) { return std::string("Corner tiles on a polycube"); },
        [](const SurfaceSettings& s, std::uint64_t seed, DistributionFiles& files) {
            return make_surface(s, seed, files);
        });
}

}
