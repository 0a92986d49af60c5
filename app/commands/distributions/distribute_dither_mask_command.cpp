// poissonlab distribute dither-mask: thresholds of pixels, below any of which they are even.
#include "app/commands/kind_options.hpp"
#include "base/errors/errors.hpp"
#include "host/distribution/masks/dither_mask.hpp"
#include "host/kinds/kinds.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
namespace {

constexpr auto distribute_dither_mask_notes =
    R"help(A mask has a threshold for each pixel: the pixels below any of them are spread evenly (blue noise), and those below a
lower one are among them. A picture is dithered by comparing each pixel with the mask, which repeats.
--by says how pixels get their ranks:
  void-and-cluster   Ulichney 1993, of the whole mask: as many thresholds as pixels (the default)
  tiles              corner tiles of --colors and --tile-pixels, ranked together, for masks that never repeat: as many
                     pixels of each tile are below any threshold; where tiles meet, pixels below low thresholds may
                     touch; 16 pixels make 256 thresholds
--out, as often as you like: .png (8 bits for up to 256 thresholds, else 16), .npy (uint32, ranks), and by tiles .ptiles:
the ranked tile set, whose points are the middles of pixels, for an endless mask by the runtime headers.
  poissonlab distribute dither-mask --size 256 --out mask.png --out mask.npy --json
  poissonlab distribute dither-mask --by tiles --out mask.png --out mask.ptiles)help";

void make_thresholds(const KindOptions& o)
{
    const auto settings = o.read<DitherMaskSettings>();
    const bool has_tiles = settings.method == DitherMethod::tiles;
    const auto is_tile_set = [](const std::filesystem::path& file) { return file.extension() == ".ptiles"; };
    if (!has_tiles && std::ranges::any_of(o.outs.files(), is_tile_set))
        throw InputError("--out: .ptiles needs --by tiles");
    const DistributionPlace place = o.place();
    const OnPart tell = [&](double part) {
        if (place.on_step) place.on_step(fmt::format("thresholds: {:.0f} %", 100 * part));
    };
    PoissonTileSet tiles;
    if (has_tiles) tiles = dither_tiles(settings, o.seed(), tell);
    const DitherMask mask = has_tiles ? mask_of_tiles(tiles, settings.size / settings.tile_pixels, o.seed())
                                      : dither_mask(settings, o.seed(), tell);
    for (const std::filesystem::path& out : o.outs.files()) {
        if (is_tile_set(out))
            write_tile_set(out, tiles);
        else
            write_dither_mask(out, mask);
    }
    if (!o.prints_json()) return;
    std::vector<ThresholdMeasures> measures;
    for (std::uint32_t i = 1; i <= measured_thresholds; ++i) measures.push_back(threshold_measures(mask, i));
    print_numbers(dither_numbers(measures));
}

}

Command distribute_dither_mask_command()
{
    return kind_command(*find_kind("distribution", "dither-mask"), {{{".png", ".npy", ".ptiles"}}},
                        distribute_dither_mask_notes, make_thresholds);
}

}
