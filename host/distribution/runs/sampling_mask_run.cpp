// kind = "mri-mask": which pixels of a grid are sampled.
#include "host/distribution/masks/mask_measures.hpp"
#include "host/kinds/kinds.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

void sampling_mask_keys(Keys& keys, SamplingMaskSettings& s)
{
    keys.integers("shape", s.shape, {1, 4096}, {"rows", "columns"}, "the grid").unit("pixels");
    keys.number("acceleration", s.acceleration, {1, 1e6}, "how many pixels there are for each sample, exactly")
        .otherwise("by samples");
    keys.integer("samples", s.samples, 1, 1 << 24, "the number of samples")
        .otherwise("by acceleration")
        .excludes("acceleration");
    keys.integers("calibration", s.calibration, {0, 4096}, {"rows", "columns"},
                  "the area in the middle of which all pixels are samples")
        .unit("pixels");
    keys.flag("corners", s.has_corners,
              "whether pixels beyond the ellipse that touches the grid's sides may be samples");
    keys.number("power", s.power, {0, 8},
                "the density falls as the distance from the middle to minus this; 0: uniform");
    keys.picture_or_formula("density", s.density.text, s.density.from,
                            "what samples follow instead: a picture, or a formula in x and y from -1 to 1")
        .excludes("power");
    if (!keys.is_read()) return;
    if (!s.acceleration && !s.samples)
        throw keys.problem(fmt::format("needs {} or {}", keys.name_of("acceleration"), keys.name_of("samples")));
    for (std::size_t k = 0; k < 2; ++k)
        if (s.calibration[k] > s.shape[k]) throw keys.invalid("calibration", "must be no larger than the grid");
    MaskField field;
    if (s.density.text.empty())
        field = mask_field(s);
    else
        keys.check("density", [&] { field = mask_field(s); });
    keys.check(s.samples ? "samples" : "acceleration", [&] { asked_samples(s, field); });
}

std::string sampling_mask_label(const SamplingMaskSettings& s)
{
    const std::string grid = fmt::format("{} x {} pixels", s.shape[0], s.shape[1]);
    return s.samples ? fmt::format("Mask of {}, {} samples", grid, *s.samples)
                     : fmt::format("Mask of {}, acceleration {}", grid, *s.acceleration);
}

DistributionResult make_sampling_mask(const SamplingMaskSettings& settings, std::uint64_t seed,
                                      const DistributionPlace&, DistributionFiles& files)
{
    const MaskField field = mask_field(settings);
    const SamplingMask mask = sampling_mask(field, asked_samples(settings, field), seed);
    DistributionResult result;
    result.facts = {fmt::format("{} x {} pixels", mask.rows, mask.columns),
                    fmt::format("{} samples", mask.samples.size()),
                    settings.density.text.empty() ? fmt::format("density falls as distance to -{}", settings.power)
                                                  : "density of " + name_of_input(settings.density.text),
                    settings.has_corners ? "corners are sampled" : "no samples in corners"};
    write_mask(files.add("mask.png"), mask);
    result.pictures.push_back({"mask.png", "Samples are white."});
    files.add_curves("profile", mask_profile(mask), "The part of pixels that are samples, by distance from the middle.",
                     result);
    write_mask(files.add("mask.npy", result), mask);
    write_mask(files.add("mask.cfl", result), mask);
    files.add("mask.hdr", result);
    result.numbers = mask_numbers(field, mask);
    return result;
}

}

Kind sampling_mask_kind()
{
    Kind kind = make_kind<SamplingMaskSettings>({"distribution", "mri-mask", "distribute mri-mask", "Mask of samples",
                                                 "Choose samples on a grid for magnetic resonance imaging", false},
                                                sampling_mask_keys, sampling_mask_label, make_sampling_mask);
    return kind;
}

}
