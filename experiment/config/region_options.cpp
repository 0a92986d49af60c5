// Regions of configs as they are read.
#include "analysis/regions/random_in_region.hpp"
#include "analysis/regions/region_tapers.hpp"
#include "base/densities/density_text.hpp"
#include "base/files/xxh64_bytes.hpp"
#include "base/regions/region_text.hpp"
#include "experiment/config/analysis_options.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

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

RegionOptions read_region_options(Keys& keys, const TypedRegion& typed, const RegionMeasures& measures,
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

}
