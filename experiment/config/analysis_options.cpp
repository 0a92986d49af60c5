#include "experiment/config/analysis_options.hpp"

#include "analysis/regions/region_tapers.hpp"
#include "experiment/config/overrides.hpp"
#include "host/settings/keys/region_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr std::int64_t most_random_sets = 9999;

void check_is_planar(const Keys& keys, int dimension)
{
    if (dimension != 2) throw keys.invalid("region", "needs dimension = 2: regions are of the plane");
}

void check_region_keys(const Keys& keys, int dimension, bool is_any_in_region)
{
    const bool has_region = keys.is_given("region");
    for (const char* key : region_reading_names)
        if (!has_region && keys.is_given(key)) throw keys.invalid(key, "needs region");
    for (const char* key : {"density", "density_from"})
        if (!has_region && keys.is_given(key)) throw keys.invalid(key, "needs region");
    for (const char* key : {"envelope", "tapers"})
        if (!has_region && !is_any_in_region && keys.is_given(key)) throw keys.invalid(key, "needs region");
    for (const char* key : {"window", "tiles", "zone_plate"})
        if ((has_region || is_any_in_region) && keys.is_given(key))
            throw keys.invalid(key, "cannot be combined with region: it is for sets in a square");
    if (has_region) check_is_planar(keys, dimension);
    if (keys.is_given("density_from") && !keys.is_given("density")) throw keys.invalid("density_from", "needs density");
}

void typed_region_keys(Keys& keys, TypedRegion& region, const std::string& of_what)
{
    keys.region("region", region.text, "the region of the plane that " + of_what + ", in whose units their points are");
    region_reading_keys(keys, region.reading);
}

void measure_keys(Keys& keys, RegionMeasures& measures)
{
    keys.integer("envelope", measures.envelope, 0, most_random_sets, "random sets that curves are held against");
    keys.integer("tapers", measures.tapers, 0, std::int64_t{most_tapers},
                 "orthogonal tapers of the region, whose spectra are averaged; 0: points less the region");
}

constexpr int most_tiles = 4096;

void spectrum_keys(Keys& keys, AnalysisOptions& o, int dimension)
{
    std::string spectrum = "fast";
    keys.word("spectrum", spectrum, {"fast", "exact", "none"}, "how periodograms are computed");
    if (spectrum == "exact") o.spectrum = PeriodogramMethod::exact;
    if (spectrum == "none") o.spectrum = std::nullopt;
    keys.integer("spectrum_size", o.spectrum_size, 4, dimension == 2 ? most_frequencies_2d : most_frequencies_3d,
                 "frequencies along each axis")
        .otherwise("by the number of points");
    if (o.spectrum_size % 2 != 0) throw keys.invalid("spectrum_size", "must be even");
    keys.number("bin_width", o.bin_width, {1, 100}, "of radial curves").unit("frequencies");
    keys.flag(
        "keep_spectrum", o.keep_spectrum,
        fmt::format("whether spectra of more than {} frequencies along an axis are stored whole, not as means over "
                    "blocks, in 2D; those of a given spectrum_size are",
                    largest_stored_spectrum));
    keys.flag("volume", o.volume, "whether the whole spectrum is stored, in 3D");
}

/// The numbers above 0 of a list; empty where it has others, or is none.
std::vector<double> sides_of(const ConfigNode& node)
{
    std::vector<double> sides;
    const auto* items = node.get_if<ConfigList>();
    for (std::size_t i = 0; items && i < items->size(); ++i) {
        const auto* whole = (*items)[i].get_if<std::int64_t>();
        const auto* real = (*items)[i].get_if<double>();
        if (!whole && !real) return {};
        sides.push_back(whole ? static_cast<double>(*whole) : *real);
        if (!(sides.back() > 0 && std::isfinite(sides.back()))) return {};
    }
    return sides;
}

/// Sides that are all the same are those of the unit square (cube), and are forgotten.
void box_key(Keys& keys, AnalysisOptions& o, int dimension)
{
    constexpr auto allowed = "[width, height], in 3D [width, height, depth]";
    keys.value("box", allowed, "sides of the periodic box that sets from files and commands lie in",
               [&](const ConfigNode& node) {
                   const std::vector<double> sides = sides_of(node);
                   if (sides.size() != static_cast<std::size_t>(dimension))
                       throw keys.invalid("box",
                                          fmt::format("must be {}, numbers above 0",
                                                      dimension == 2 ? "[width, height]" : "[width, height, depth]"));
                   keys.check("box", [&] { check_box_sides(sides); });
                   if (!periodic_box(sides).is_unit()) o.box_sides = sides;
               })
        .otherwise("a square (cube)");
}

/// Throws InputError for what is defined in squares and cubes alone.
void check_box(const Keys& keys, const AnalysisOptions& o, bool is_any_in_region)
{
    if (o.box_sides.empty()) return;
    if (o.region || is_any_in_region)
        throw keys.invalid("box", "cannot be combined with a region, which is not periodic");
    if (o.window) throw keys.invalid("box", "cannot be combined with window = true: a window is not periodic");
    if (o.tiles > 0) throw keys.invalid("box", "cannot be combined with tiles, which are squares (cubes)");
    if (o.zone_plate)
        throw keys.invalid("box", "cannot be combined with zone_plate = true: the zone plate is a square");
}

void check_analysis(const Keys& keys, const AnalysisOptions& o, int dimension, bool is_any_in_region)
{
    if (!o.spectrum)
        for (const char* key : {"spectrum_size", "bin_width", "keep_spectrum", "volume", "tiles", "tapers"})
            if (keys.is_given(key))
                throw keys.invalid(key, "cannot be combined with spectrum = \"none\"; leave it out");
    if (o.keep_spectrum && dimension != 2) throw keys.invalid("keep_spectrum", "needs dimension = 2; see volume");
    if (o.volume && dimension != 3) throw keys.invalid("volume", "needs dimension = 3; see keep_spectrum");
    if (o.zone_plate && dimension != 2)
        throw keys.invalid("zone_plate", "needs dimension = 2: the zone plate is a function of the plane");
    if ((o.region || is_any_in_region) && o.spectrum_size > largest_region_spectrum)
        throw keys.invalid("spectrum_size",
                           fmt::format("must be at most {} for sets in a region", largest_region_spectrum));
}

/// Reads the table [analysis] of `--set` arguments over these entries by such a function.
template <class Visit>
auto overridden(const std::vector<std::string>& overrides, const ConfigTable& entries, const Visit& visit)
{
    ConfigTable top{{"analysis", {entries, {}, {}}}};
    apply_overrides(top, overrides);
    check_keys(top, {"analysis"});
    const ConfigNode* analysis = find(top, "analysis");
    const auto* table = analysis->get_if<ConfigTable>();
    if (!table) throw invalid_node("analysis", *analysis, "must be a table: --set analysis.KEY=VALUE");
    check_described_keys(*table, [](Keys& keys) { analysis_keys(keys, 2); });
    Keys keys(*table, {}, "");
    return visit(keys);
}

}

std::optional<RegionOptions> region_keys(Keys& keys, int dimension, RegionMeasures& measures, bool is_any_in_region)
{
    TypedRegion typed;
    DensityChoice density;
    typed_region_keys(keys, typed, "sets lie in");
    keys.picture_or_formula("density", density.text, density.from,
                            "what points follow: a picture, or a formula, over the region's box");
    measure_keys(keys, measures);
    check_region_keys(keys, dimension, is_any_in_region);
    if (!keys.is_given("region")) return {};
    return read_region_options(keys, typed, measures, density);
}

std::optional<RegionOptions> method_region_keys(Keys& keys, int dimension, const RegionMeasures& measures)
{
    TypedRegion typed;
    typed_region_keys(keys, typed, "this method's sets lie in");
    if (!keys.is_given("region")) {
        for (const char* key : region_reading_names)
            if (keys.is_given(key)) throw keys.invalid(key, "needs region");
        return {};
    }
    check_is_planar(keys, dimension);
    return read_region_options(keys, typed, measures, {});
}

AnalysisOptions analysis_keys(Keys& keys, int dimension, bool is_any_in_region)
{
    AnalysisOptions o;
    spectrum_keys(keys, o, dimension);
    keys.flag("zone_plate", o.zone_plate, "whether sets sample the zone plate, in 2D");
    keys.integer("tiles", o.tiles, 2, most_tiles, "tiles that sets are made of, along each axis")
        .otherwise("sets have no tiles");
    keys.flag("window", o.window, "whether sets are windows of the plane, not tori");
    box_key(keys, o, dimension);
    static constexpr WordTable<bool, 2> measures{{{{false, "all"}, {true, "distances"}}}};
    static constexpr WordTable<bool, 2> point_files{{{{false, "all"}, {true, "first"}}}};
    keys.word("measures", o.distances_only, measures, "what is measured");
    keys.word("point_files", o.first_points_only, point_files, "whose points are stored");
    o.region = region_keys(keys, dimension, o.region_measures, is_any_in_region);
    check_box(keys, o, is_any_in_region);
    check_analysis(keys, o, dimension, is_any_in_region);
    return o;
}

void check_box_sides(const std::vector<double>& sides)
{
    const auto [shortest, longest] = std::ranges::minmax(sides);
    if (longest > longest_to_shortest * shortest)
        throw InputError(fmt::format("the longest side must be at most {} times the shortest", longest_to_shortest));
}

AnalysisOptions overridden_analysis(const std::vector<std::string>& overrides, int dimension,
                                    const ConfigTable& entries)
{
    return overridden(overrides, entries, [&](Keys& keys) { return analysis_keys(keys, dimension); });
}

std::optional<RegionOptions> overridden_region(const std::vector<std::string>& overrides, const ConfigTable& entries)
{
    return overridden(overrides, entries, [](Keys& keys) {
        RegionMeasures measures;
        return region_keys(keys, 2, measures, false);
    });
}

}
