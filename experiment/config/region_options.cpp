#include "experiment/config/region_options.hpp"

#include "base/densities/density_text.hpp"
#include "base/files/xxh64_bytes.hpp"
#include "base/regions/region_text.hpp"
#include "host/settings/keys/region_keys.hpp"

#include <fmt/format.h>

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
        if (!has_region && keys.is_given(key)) throw keys.invalid(key, "goes with region");
    for (const char* key : {"density", "density_from"})
        if (!has_region && keys.is_given(key)) throw keys.invalid(key, "goes with region");
    for (const char* key : {"envelope", "tapers"})
        if (!has_region && !is_any_in_region && keys.is_given(key)) throw keys.invalid(key, "goes with region");
    for (const char* key : {"window", "tiles", "zone_plate"})
        if ((has_region || is_any_in_region) && keys.is_given(key))
            throw keys.invalid(key, "does not go with region: it is about sets in a square");
    if (has_region) check_is_planar(keys, dimension);
    if (keys.is_given("density_from") && !keys.is_given("density"))
        throw keys.invalid("density_from", "goes with density");
}

std::shared_ptr<const RegionDensity> region_density(const DensityChoice& density, const FramedRegion& region,
                                                    Xxh64& hash)
{
    const RegionBox box = box_of(region.polygons());
    Density read = density_of_text(density.text, density.from, box.width(), box.height());
    hash.add({reinterpret_cast<const char*>(read.weights.data()), read.weights.size() * sizeof(std::uint64_t)});
    hash.add(fmt::format("{} columns", read.width));
    return std::make_shared<const RegionDensity>(std::move(read), region);
}

/// The region that a table says, as it is read and measured.
struct TypedRegion
{
    std::string text;
    RegionReading reading;
};

void typed_region_keys(Keys& keys, TypedRegion& region, const std::string& of_what)
{
    keys.region("region", region.text, "the region of the plane that " + of_what + ", in whose units their points are");
    region_reading_keys(keys, region.reading);
}

RegionOptions read_options(Keys& keys, const TypedRegion& typed, const RegionMeasures& measures,
                           const DensityChoice& density)
{
    RegionOptions options;
    keys.check("region", [&] {
        options.region =
            std::make_shared<const FramedRegion>(read_region(typed.text, typed.reading), name_of_input(typed.text));
    });
    options.envelope = measures.envelope;
    Xxh64 hash;
    hash.add(fmt::format("{} ", options.region->hash()));
    if (!density.text.empty())
        keys.check("density", [&] { options.density = region_density(density, *options.region, hash); });
    if (measures.tapers > 0) {
        keys.check(keys.is_given("tapers") ? "tapers" : "region",
                   [&] { options.tapers = std::make_shared<const RegionTapers>(*options.region, measures.tapers); });
        hash.add(fmt::format(" {} tapers", measures.tapers));
    }
    options.hash = hash.value();
    return options;
}

void measure_keys(Keys& keys, RegionMeasures& measures)
{
    keys.integer("envelope", measures.envelope, 0, most_random_sets, "random sets that curves are held against");
    keys.integer("tapers", measures.tapers, 0, std::int64_t{most_tapers},
                 "orthogonal tapers of the region, whose spectra are averaged; 0: points less the region");
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
    return read_options(keys, typed, measures, density);
}

std::optional<RegionOptions> method_region_keys(Keys& keys, int dimension, const RegionMeasures& measures)
{
    TypedRegion typed;
    typed_region_keys(keys, typed, "this method's sets lie in");
    if (!keys.is_given("region")) {
        for (const char* key : region_reading_names)
            if (keys.is_given(key)) throw keys.invalid(key, "goes with region");
        return {};
    }
    check_is_planar(keys, dimension);
    return read_options(keys, typed, measures, {});
}

}
