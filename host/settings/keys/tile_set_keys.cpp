#include "host/settings/keys/tile_set_keys.hpp"

#include "host/tile_sampling/tile_samplers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <utility>

namespace poissonlab {
namespace {

const ParameterSpec* find_spec(const std::vector<ParameterSpec>& specs, const std::string& key)
{
    const auto found = std::ranges::find(specs, key, &ParameterSpec::key);
    return found == specs.end() ? nullptr : &*found;
}

/// The families whose sets have a parameter: "corner and template tiles".
std::string owners_of(const std::string& key)
{
    std::vector<std::string> owners;
    for (const auto& [family, word] : poisson_tile_families.entries)
        if (find_spec(tile_set_parameters(family), key)) owners.emplace_back(word);
    const std::string last = owners.back();
    owners.pop_back();
    return owners.empty() ? last + " tiles" : fmt::format("{} and {} tiles", fmt::join(owners, ", "), last);
}

/// Names that are long in a config are short where they are typed.
void call_by_short_name(Keys::Said said, const std::string& key)
{
    if (key == "points_per_tile") said.called("points");
    if (key == "lloyd_iterations") said.called("lloyd");
}

/// Parameters of other families, which are known in order to be refused by name.
void name_foreign_keys(Keys& keys, const std::vector<ParameterSpec>& own)
{
    std::set<std::string> named;
    for (const auto& [family, word] : poisson_tile_families.entries)
        for (const ParameterSpec& spec : tile_set_parameters(family)) {
            if (find_spec(own, spec.key) || !named.insert(spec.key).second) continue;
            Parameters unused;
            const auto said = keys.parameter(spec, unused);
            Keys::Said(said).only_if(false, owners_of(spec.key)).otherwise("needed by tiles that have it");
        }
}

}

PoissonTileParameters AskedTileSet::parameters(std::uint64_t seed) const
{
    return tile_set_parameters_of(family, values, seed);
}

void tile_set_keys(Keys& keys, AskedTileSet& set, const TileSetDefaults& defaults, bool has_all)
{
    std::vector<ParameterSpec> specs = tile_set_parameters(set.family);
    for (ParameterSpec& spec : specs)
        if (const auto other = defaults.find(spec.key); other != defaults.end()) spec.otherwise = other->second;
    set.values = Parameters(specs);
    if (has_all) name_foreign_keys(keys, specs);
    for (const ParameterSpec& spec : specs) {
        Keys::Said said = keys.parameter(spec, set.values);
        call_by_short_name(said, spec.key);
        if (has_all && owners_of(spec.key) != owners_of("points_per_tile")) said.only_if(true, owners_of(spec.key));
        const bool needs = !spec.otherwise && spec.unless_given.empty();
        if (needs && (!has_all || keys.is_read())) said.required();
        if (needs && has_all && !keys.is_read()) said.otherwise("needed by tiles that have it");
        if (has_all && spec.key == "points_per_tile") said.required();
    }
    if (keys.is_read()) keys.check([&] { check(set.parameters(1)); });
}

}
