#include "experiment/config/region_options.hpp"

#include "base/densities/density_text.hpp"
#include "base/files/xxh64_bytes.hpp"
#include "base/regions/region_text.hpp"
#include "host/settings/config_values.hpp"
#include "host/settings/keys/keys.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace poissonlab {
namespace {

constexpr std::int64_t most_random_sets = 9999;

/// The file's name from the folder of the config in which it was typed.
std::string from_folder_of(const ConfigNode& node, const std::string& text)
{
    if (node.location.is_argument) return text;
    return (std::filesystem::path(node.location.file).parent_path() / text).string();
}

/// Does what may throw InputError because of a value, and says where that was typed.
template <class Work>
auto said_at(const char* key, const ConfigNode& node, const Work& work)
{
    try {
        return work();
    } catch (const InputError& error) {
        throw InputError::at(node.location, node.location.is_argument ? std::string(error.what())
                                                                      : fmt::format("{}: {}", key, error.what()));
    }
}

void read_density(const ConfigTable& analysis, RegionOptions& options, Xxh64& hash)
{
    const std::string from = read_text(analysis, "density_from", "light");
    const ConfigNode* node = find(analysis, "density");
    if (!node) {
        if (const ConfigNode* alone = find(analysis, "density_from"))
            throw invalid_node("density_from", *alone, "goes with density");
        return;
    }
    std::string text = read_text(analysis, "density", "");
    if (is_file_name(text)) text = from_folder_of(*node, text);
    const RegionBox box = box_of(options.region->polygons());
    options.density = said_at("density", *node, [&] {
        Density density = density_of_text(text, from, box.width(), box.height());
        hash.add(
            {reinterpret_cast<const char*>(density.weights.data()), density.weights.size() * sizeof(std::uint64_t)});
        hash.add(fmt::format("{} columns", density.width));
        return std::make_shared<const RegionDensity>(std::move(density), *options.region);
    });
}

}

std::optional<RegionOptions> read_region_options(const ConfigTable& analysis, int dimension)
{
    const ConfigNode* node = find(analysis, "region");
    if (!node) {
        for (const char* key : {"planar", "density", "density_from", "envelope"})
            if (const ConfigNode* alone = find(analysis, key)) throw invalid_node(key, *alone, "goes with region");
        return {};
    }
    if (dimension != 2) throw invalid_node("region", *node, "needs dimension = 2: regions are of the plane");
    for (const char* key : {"window", "tiles", "zone_plate"})
        if (const ConfigNode* other = find(analysis, key))
            throw invalid_node(key, *other, "does not go with region: it is about sets in a square");
    std::string text = read_text(analysis, "region", "");
    const std::string name = name_of_input(text);
    if (!is_region_text(text)) text = from_folder_of(*node, text);
    RegionOptions options;
    options.where = node->location;
    const bool is_planar = read_flag(analysis, "planar", false);
    options.region = said_at("region", *node,
                             [&] { return std::make_shared<const FramedRegion>(read_region(text, is_planar), name); });
    options.envelope = static_cast<std::uint32_t>(
        read_integer(analysis, "envelope", 0, most_random_sets, static_cast<std::int64_t>(options.envelope)));
    Xxh64 hash;
    hash.add(fmt::format("{} ", options.region->hash()));
    read_density(analysis, options, hash);
    options.hash = hash.value();
    return options;
}

}
