#include "host/config/distributions/packing_table.hpp"

#include "host/config/config_values.hpp"

#include <fmt/format.h>

#include <cctype>

namespace poissonlab {
namespace {

constexpr std::int64_t most_packed_colors = 8;

/// Methods that have not every kind and number of colours.
void check_packing_method(const ConfigTable& table, const PackingSettings& settings)
{
    const ConfigNode* const method = find(table, "method");
    const auto refuse = [&](const char* allowed) { throw invalid_node("method", *method, allowed); };
    const bool is_corner = settings.kind == TileKind::corner;
    if (settings.method == "printed" && settings.colors > 4) refuse("has at most 4 colours");
    if (settings.method == "product" && (is_corner || settings.colors != 3)) refuse("is for wang tiles of 3 colours");
    if (settings.method == "eulerian" && is_corner) refuse("is for wang tiles");
    if (settings.method == "search" && settings.colors > 3) refuse("takes years for more than 3 colours");
    if (settings.method == "grown" && (!is_corner || settings.colors != 3)) refuse("is for corner tiles of 3 colours");
}

std::string packing_label(const PackingSettings& settings)
{
    const char* const kind = settings.kind == TileKind::corner ? "corner tiles" : "Wang tiles";
    if (settings.show == "puzzle") return fmt::format("Puzzle of {}, {} colours", kind, settings.colors);
    if (settings.show == "dominoes") return fmt::format("Dominoes of {} colours", settings.colors);
    if (settings.show == "graph") return fmt::format("Graph of the dominoes of {} colours", settings.colors);
    if (settings.show == "row") return fmt::format("Packing of the dominoes of {} colours", settings.colors);
    std::string label = fmt::format("{} packing of {}, {} colours", settings.method, kind, settings.colors);
    label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])));
    return label;
}

DistributionConfig read_packing_table(const ConfigNode& node, std::uint64_t seed)
{
    const ConfigTable& table = *node.get_if<ConfigTable>();
    check_keys(table, {"kind", "colors", "method", "show", "label"});
    DistributionConfig config;
    config.kind = "packing";
    config.where = node.location;
    config.seed = seed;
    config.text = text_of(table);
    PackingSettings settings;
    static const std::vector<std::string> kinds{"corner", "wang"};
    settings.kind = read_word(table, "kind", kinds) == 0 ? TileKind::corner : TileKind::wang;
    settings.colors = static_cast<Color>(read_integer(table, "colors", 2, most_packed_colors, 2));
    settings.method = packing_words()[read_word(table, "method", packing_words())];
    settings.show = packing_shows()[read_word(table, "show", packing_shows())];
    settings.seed = seed;
    check_packing_method(table, settings);
    config.label = read_text(table, "label", packing_label(settings));
    config.settings = std::move(settings);
    return config;
}

}

const std::vector<std::string>& packing_words()
{
    static const std::vector<std::string> words{"closed", "printed", "product", "eulerian", "search", "grown"};
    return words;
}

const std::vector<std::string>& packing_shows()
{
    static const std::vector<std::string> words{"tiles", "puzzle", "dominoes", "graph", "row"};
    return words;
}

std::vector<DistributionConfig> read_packings(const std::vector<ConfigNode>& tables, std::uint64_t seed)
{
    std::vector<DistributionConfig> packings;
    for (const ConfigNode& node : tables) packings.push_back(read_packing_table(node, seed));
    return packings;
}

}
