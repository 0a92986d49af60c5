#include "host/settings/tile_sets/tile_set_keys.hpp"

#include "host/settings/keys/class_keys.hpp"
#include "host/tile_sampling/tile_samplers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace poissonlab {
namespace {

const ParameterSpec* find_spec(const std::vector<ParameterSpec>& specs, const std::string& key)
{
    const auto found = std::ranges::find(specs, key, &ParameterSpec::key);
    return found == specs.end() ? nullptr : &*found;
}

/// The kinds of sets by their words, and the parameters of each.
std::vector<std::pair<std::string, std::vector<ParameterSpec>>> parameters_of_all()
{
    std::vector<std::pair<std::string, std::vector<ParameterSpec>>> all;
    for (const auto& [family, word] : poisson_tile_families.entries)
        all.emplace_back(word, tile_set_parameters(family));
    for (const char* word : {"hat", "spectre"}) all.emplace_back(word, monotile_parameters());
    return all;
}

/// The kinds whose sets have a parameter: "corner and template tiles".
std::string owners_of(const std::string& key)
{
    std::vector<std::string> owners;
    for (const auto& [word, specs] : parameters_of_all())
        if (find_spec(specs, key)) owners.emplace_back(word);
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

/// Parameters of other kinds, which are known in order to be refused by name.
void name_foreign_keys(Keys& keys, const std::vector<ParameterSpec>& own)
{
    std::set<std::string> named;
    for (const auto& [word, specs] : parameters_of_all())
        for (const ParameterSpec& spec : specs) {
            if (find_spec(own, spec.key) || !named.insert(spec.key).second) continue;
            Parameters unused;
            const auto said = keys.parameter(spec, unused);
            Keys::Said foreign = Keys::Said(said).only_if(false, owners_of(spec.key));
            if (!spec.otherwise && spec.unless_given.empty()) foreign.otherwise("needed by tiles that have it");
        }
}

/// Returns the classes that the keys ask for.
TileClasses asked_classes(const AskedTileSet& set)
{
    const std::vector<std::uint32_t> points(set.class_points.begin(), set.class_points.end());
    if (!set.class_distances.empty()) return {points, wei_distances(set.class_distances, set.family.dimension)};
    if (set.class_matrix.empty()) {
        const bool is_given = set.values.is_given("relative_radius");
        return classes_of_radius(points, is_given ? set.values.number("relative_radius") : usual_class_radius,
                                 set.family.dimension);
    }
    ClassDistances distances(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j) distances.set(i, j, set.class_matrix[i * points.size() + j]);
    return {points, distances};
}

bool have_classes(const AskedTileSet& set) { return set.monotile.empty() && set.family.dimension == 2; }

/// Throws InputError for keys that do not go together.
void check_class_keys(const Keys& keys, const AskedTileSet& set)
{
    const bool has_distances = !set.class_distances.empty() || !set.class_matrix.empty();
    if (set.class_points.empty()) {
        if (has_distances) throw keys.problem("needs " + keys.name_of("class_points"));
        if (!keys.is_given("points_per_tile"))
            throw keys.problem("needs " + keys.name_of("points_per_tile") +
                               (have_classes(set) ? " or " + keys.name_of("class_points") : ""));
        return;
    }
    for (const char* key : {"points_per_tile", "lloyd_iterations", "repulsion"})
        if (keys.is_given(key)) throw keys.invalid(key, "cannot be combined with " + keys.name_of("class_points"));
    if (has_distances && keys.is_given("relative_radius"))
        throw keys.invalid("relative_radius", "cannot be combined with distances of classes");
    const std::size_t n = set.class_points.size();
    if (!set.class_distances.empty() && set.class_distances.size() != n)
        throw keys.invalid("class_distances", fmt::format("must be {}, one of each class", n));
    if (!set.class_matrix.empty() && set.class_matrix.size() != n * n)
        throw keys.invalid("class_matrix", fmt::format("must be {} rows of {}", n, n));
}

void class_tile_keys(Keys& keys, AskedTileSet& set)
{
    const bool applies = have_classes(set);
    const char* const class_tiles = "corner, edge and template tiles";
    constexpr Interval tile_sides{0.001, 1};
    class_counts(keys, "class_points", set.class_points, max_points_per_tile, "how many points a tile has")
        .only_if(applies, class_tiles)
        .otherwise("points have no classes");
    class_list(keys, "class_distances", set.class_distances, tile_sides, "a number from 0.001 to 1",
               "the least distance of points of the same class")
        .unit("tiles")
        .only_if(applies, class_tiles)
        .otherwise(fmt::format("those of relative_radius, of each class then, {} unless given", usual_class_radius));
    class_matrix(keys, "class_matrix", set.class_matrix, tile_sides)
        .unit("tiles")
        .excludes("class_distances")
        .only_if(applies, class_tiles)
        .otherwise("that of Wei 2010, from distances");
}

}

std::vector<ParameterSpec> monotile_parameters()
{
    using Kind = ParameterSpec::Kind;
    return {{.key = "points_per_tile",
             .kind = Kind::integer,
             .help = "number of points in each tile",
             .minimum = 1,
             .maximum = 16,
             .symbol = "n",
             .otherwise = std::int64_t{4}},
            {.key = "levels",
             .kind = Kind::integer,
             .help = "number of ancestors that decide a tile's points, beside its neighbours",
             .minimum = 0,
             .maximum = 2,
             .otherwise = std::int64_t{1}}};
}

PoissonTileParameters AskedTileSet::parameters(std::uint64_t seed) const
{
    PoissonTileParameters p = tile_set_parameters_of(family, values, seed);
    if (!class_points.empty()) set_classes(p, asked_classes(*this));
    return p;
}

void tile_set_keys(Keys& keys, AskedTileSet& set, const TileSetDefaults& defaults, bool has_all)
{
    const bool is_monotile = !set.monotile.empty();
    std::vector<ParameterSpec> specs = is_monotile ? monotile_parameters() : tile_set_parameters(set.family);
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
        if (has_all && spec.key == "points_per_tile") said.otherwise("needed where there are no class_points");
    }
    if (has_all) class_tile_keys(keys, set);
    if (is_monotile) return;
    if (has_all && keys.is_read()) check_class_keys(keys, set);
    if (keys.is_read()) keys.check([&] { check(set.parameters(1)); });
}

}
