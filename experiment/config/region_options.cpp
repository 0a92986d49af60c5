#include "experiment/config/region_options.hpp"

#include "base/densities/density_text.hpp"
#include "base/files/xxh64_bytes.hpp"
#include "base/regions/region_text.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

constexpr std::int64_t most_random_sets = 9999;

void check_region_keys(const Keys& keys, int dimension)
{
    if (!keys.is_given("region")) {
        for (const char* key : {"planar", "density", "density_from", "envelope", "tapers"})
            if (keys.is_given(key)) throw keys.invalid(key, "goes with region");
        return;
    }
    if (dimension != 2) throw keys.invalid("region", "needs dimension = 2: regions are of the plane");
    for (const char* key : {"window", "tiles", "zone_plate"})
        if (keys.is_given(key)) throw keys.invalid(key, "does not go with region: it is about sets in a square");
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

}

std::optional<RegionOptions> region_keys(Keys& keys, int dimension)
{
    RegionOptions options;
    std::string region;
    bool is_planar = false;
    DensityChoice density;
    keys.region("region", region, "the region of the plane that sets lie in, in whose units their points are");
    keys.flag("planar", is_planar, "whether coordinates of the region that look like degrees are lengths");
    keys.picture_or_formula("density", density.text, density.from,
                            "what points follow: a picture, or a formula, over the region's box");
    keys.integer("envelope", options.envelope, 0, most_random_sets, "random sets that curves are held against");
    std::uint32_t tapers = 0;
    keys.integer("tapers", tapers, 0, std::int64_t{most_tapers},
                 "orthogonal tapers of the region, whose spectra are averaged; 0: points less the region");
    check_region_keys(keys, dimension);
    if (!keys.is_given("region")) return {};
    options.where = keys.place_of("region");
    keys.check("region", [&] {
        options.region = std::make_shared<const FramedRegion>(read_region(region, is_planar), name_of_input(region));
    });
    Xxh64 hash;
    hash.add(fmt::format("{} ", options.region->hash()));
    keys.check("density", [&] { options.density = region_density(density, *options.region, hash); });
    if (tapers > 0) {
        keys.check("tapers", [&] { options.tapers = std::make_shared<const RegionTapers>(*options.region, tapers); });
        hash.add(fmt::format(" {} tapers", tapers));
    }
    options.hash = hash.value();
    return options;
}

}
