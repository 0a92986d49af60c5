// poissonlab distribute mri-mask: which pixels of a grid are sampled.
#include "app/commands/kind_options.hpp"
#include "host/distribution/masks/mask_measures.hpp"
#include "host/kinds/kinds.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

constexpr auto distribute_mri_mask_notes =
    R"help(Exactly as many pixels of a grid as --acceleration or --samples says, as far apart as their density allows: any two
samples are at least as far apart as the larger one of the distances that the density asks for at both, but for the
calibration area, of which all pixels are samples. Squared distances are whole numbers and are compared exactly. The
density falls as the distance from the middle (pixel rows / 2, columns / 2) to minus --power, or follows --density, a
picture or a formula; no pixel is taken twice, so where it would be more than 1 all pixels are samples. Without
--corners samples are inside the ellipse that touches the sides of the grid. Samples are counted over the whole grid.
--out, as often as you like: .npy (uint8, shape (rows, columns)), .cfl (BART, with its .hdr; dimensions 1, rows,
columns), .png.
  poissonlab distribute mri-mask --shape 256 256 --acceleration 8 --calibration 24 24 --out mask.npy --out mask.png
  poissonlab distribute mri-mask --shape 320 192 --acceleration 4 --power 0 --corners --out mask.cfl
  poissonlab distribute mri-mask --samples 6000 --density "exp(-4*(x*x+y*y))" --out mask.npy)help";

void choose_samples(const KindOptions& o)
{
    const auto settings = o.read<SamplingMaskSettings>();
    const MaskField field = mask_field(settings);
    const SamplingMask mask = sampling_mask(field, asked_samples(settings, field), o.seed());
    for (const std::filesystem::path& out : o.outs.files()) write_mask(out, mask);
    if (o.prints_json())
        print_numbers(mask_numbers(field, mask));
    else if (!o.is_quiet())
        fmt::print("{} samples of {} x {} pixels, acceleration {:.6g}; {} of them in the calibration area\n",
                   mask.samples.size(), mask.rows, mask.columns,
                   static_cast<double>(field.pixels()) / static_cast<double>(mask.samples.size()), field.always.size());
}

}

Command distribute_mri_mask_command()
{
    return kind_command(*find_kind("distribution", "mri-mask"), {{{".npy", ".cfl", ".png"}, false, false, ".cfl"}},
                        distribute_mri_mask_notes, choose_samples);
}

}
