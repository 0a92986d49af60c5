// kind = "dither-mask": thresholds of pixels, below any of which they are even.
#include "base/errors/errors.hpp"
#include "host/distribution/masks/dither_mask.hpp"
#include "host/kinds/kinds.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

void dither_mask_keys(Keys& keys, DitherMaskSettings& s)
{
    keys.integer("size", s.size, 16, 4096, "the side of the mask, after which it repeats").unit("pixels");
    keys.word("by", s.method, dither_methods, "how pixels get their ranks");
    const bool has_tiles = s.method == DitherMethod::tiles;
    const std::string when = keys.shown("by", std::string(dither_methods[DitherMethod::tiles]));
    keys.integer("colors", s.colors, 1, 8, "of the corners of tiles").only_if(has_tiles, when);
    keys.integer("tile_pixels", s.tile_pixels, 4, 32, "the side of a tile, a power of two")
        .unit("pixels")
        .only_if(has_tiles, when);
    if (!keys.is_read() || !has_tiles) return;
    if ((s.tile_pixels & (s.tile_pixels - 1)) != 0) throw keys.invalid("tile_pixels", "must be a power of two");
    if (s.size % s.tile_pixels == 0) return;
    if (keys.is_given("size"))
        throw keys.invalid("size", fmt::format("must be a multiple of the side of a tile, {} pixels", s.tile_pixels));
    throw keys.invalid("tile_pixels", fmt::format("must divide the side of the mask, {} pixels", s.size));
}

std::string dither_mask_label(const DitherMaskSettings& s)
{
    return fmt::format("Thresholds of {} x {} pixels by {}", s.size, s.size, dither_methods[s.method]);
}

DistributionResult make_dither_mask(const DitherMaskSettings& settings, std::uint64_t seed,
                                    const DistributionPlace& place, DistributionFiles& files)
{
    const bool has_tiles = settings.method == DitherMethod::tiles;
    const DitherMask mask = dither_mask(settings, seed, [&](double part) {
        if (place.on_step) place.on_step(fmt::format("thresholds: {:.0f} %", 100 * part));
    });
    DistributionResult result;
    result.facts = {fmt::format("{} x {} pixels", mask.size, mask.size), fmt::format("{} thresholds", mask.levels),
                    has_tiles ? fmt::format("corner tiles of {} colours, {} x {} pixels", settings.colors,
                                            settings.tile_pixels, settings.tile_pixels)
                              : "void and cluster"};
    write_dither_mask(files.add("mask.png"), mask);
    result.pictures.push_back({"mask.png", "The mask: grey values are thresholds."});
    write_threshold_strip(files.add("thresholds.png"), mask);
    result.pictures.push_back({"thresholds.png", "Pixels below 1/16, 2/16, ... 8/16 of the thresholds, in a corner."});
    std::vector<ThresholdMeasures> measures;
    for (std::uint32_t i = 1; i <= measured_thresholds; ++i) measures.push_back(threshold_measures(mask, i));
    files.add_curves("power", dither_curves(measures), "Radially averaged power of the pixels below thresholds.",
                     result);
    write_dither_mask(files.add("mask.npy", result), mask);
    result.numbers = dither_numbers(measures);
    result.tables.push_back(dither_table(measures));
    return result;
}

}

Kind dither_mask_kind()
{
    return make_kind<DitherMaskSettings>({"distribution", "dither-mask", "distribute dither-mask", "Mask of thresholds",
                                          "Make a mask of thresholds for dithering, even below each", false},
                                         dither_mask_keys, dither_mask_label, make_dither_mask);
}

}
