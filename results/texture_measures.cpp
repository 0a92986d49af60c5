#include "results/texture_measures.hpp"

#include <algorithm>
#include <stdexcept>

namespace poissonlab {
namespace {

Measure texture_row(const char* key, const char* name, const char* unit, Better better, Digits digits,
                    const char* meaning)
{
    Measure row;
    row.key = key;
    row.name = name;
    row.unit = unit;
    row.better = better;
    row.digits = digits;
    row.meaning = meaning;
    return row;
}

constexpr Digits three{Digits::Form::significant, 3};
constexpr Digits whole{Digits::Form::count, 0};

}

const std::vector<Measure>& texture_measures()
{
    using enum Better;
    static const std::vector<Measure> all{
        texture_row("sets", "sets", "", neither, whole, "With other patches each, over which all else is averaged."),
        texture_row("tiles", "tiles", "", neither, whole, "In the set."),
        texture_row("atlas_pixels", "memory", "pixels", lower, whole,
                    "Of all tiles; of methods without tiles, of the exemplar."),
        texture_row(
            "atlas_bytes", "memory in bytes", "bytes", lower, whole,
            "Of what pixels are looked up in, without mipmap levels: by-example noise has 16 bits a channel, and "
            "its tables."),
        texture_row("fetches", "look-ups", "a pixel", lower, whole,
                    "Texels that a pixel is made of, without filtering, and entries of tables."),
        texture_row("seam_pairs", "seams a tile", "pairs of pixels", lower, three,
                    "Neighbouring pixels of a tile whose sources are no neighbours in the exemplar."),
        texture_row("seam_mismatch", "seam mismatch", "of a natural step", lower, three,
                    "By how much the two windows of the exemplar that meet at a seam differ, mean over both pixels, in "
                    "parts of the mean difference of neighbours in the exemplar: 1 is natural."),
        texture_row(
            "seam_excess", "seam excess", "of a natural step", lower, three,
            "By how much the step over a seam is larger than the larger of those that both windows have there."),
        texture_row(
            "conspicuous_seams", "conspicuous seams", "", lower, three,
            "The part of the steps over seams that are above the 95 % quantile of the exemplar's: 0.05 cannot be "
            "seen."),
        texture_row("longest_run", "longest straight run", "pixels", lower, three,
                    "Conspicuous steps side by side along a straight line inside of a tile: eyes find straight lines "
                    "first."),
        texture_row("mean_seam_line", "seams over a line", "", neither, three,
                    "The share of seams among the pairs of pixels across a line between two columns or rows of a tile, "
                    "averaged over all lines."),
        texture_row("largest_seam_line", "seams over the worst line", "", lower, three,
                    "The share of seams of the line that has the most. It is far above the mean where cuts end at a "
                    "border that all tiles have."),
        texture_row("longest_seam_line", "longest straight seam", "pixels", lower, three,
                    "The largest number of seam pairs side by side along a straight line inside a tile, whether they "
                    "are conspicuous or not."),
        texture_row(
            "novelty", "new patches", "", lower, three,
            "The share of the patches of 27 x 27 pixels of a tiling that are farther from all patches of the exemplar "
            "than 90 % of the patches of one half of the exemplar are from the other half. Fused and broken shapes "
            "make such patches; cuts do not prevent them. Another picture by the same law has about 0.1, plain "
            "repetition almost none."),
        texture_row("novelty_small", "new small patches", "", lower, three,
                    "The share of new patches among patches as large as the exemplar's features, of 7 to 13 pixels."),
        texture_row("novelty_large", "new large patches", "", lower, three,
                    "The share of new patches among patches three times as large as the exemplar's features, of 41 to "
                    "81 pixels."),
        texture_row("feature_side", "size of features", "pixels", neither, whole,
                    "The side of the smallest squares of the exemplar whose means have at most half of the variance of "
                    "its pixels."),
        texture_row("fragments", "fragments a tile", "", lower, three,
                    "The number of connected pieces of the exemplar per tile that are smaller than a square of the "
                    "size of features."),
        texture_row(
            "slow_power", "uneven light", "of the power", neither, three,
            "The part of a tiling's power at frequencies below one over two tiles: light and colour that change "
            "over more than a tile, and show as camouflage where it is more than the exemplar's."),
        texture_row("exemplar_slow_power", "uneven light of the exemplar", "of the power", neither, three,
                    "The share of the exemplar's own power at frequencies below one over two tiles."),
        texture_row(
            "border_joints", "joints a border", "pairs of pixels", lower, three,
            "Over the border of two tiles that fit, pixels whose sources are no neighbours, as the shared colours "
            "predict."),
        texture_row("border_exceptions", "misfits a border", "pairs of pixels", lower, three,
                    "The same where nothing predicts them: the corner problem of Wang tiles."),
        texture_row(
            "border_step", "step over borders", "of a natural step", neither, three,
            "The mean difference of neighbours in two tiles of a tiling, over the exemplar's mean: 1 is natural."),
        texture_row("largest_step", "largest step along a line", "of a natural step", lower, three,
                    "The same of the column or row of a tile, over a whole tiling, where it is largest: 1 is natural."),
        texture_row("coverage", "coverage", "of the exemplar", higher, three,
                    "The part of the exemplar's pixels that some tile shows."),
        texture_row(
            "recurrence", "recurring power", "of the power", lower, three,
            "The part of a texture's power at whole multiples of one over the width and the height of a rectangle, "
            "beyond chance: it is 0 for independent pieces and 1 for a picture that repeats. The rectangle is a tile "
            "(2 x 2 omega tiles) in a tiling of 32 x 32 tiles, the exemplar of plain repetition, or a square, a pair "
            "of rows of hexagons or a block of methods without tiles. If regular waves fit the tiles, the exemplar's "
            "means at their phase are subtracted first. An eye notices values above 0.05."),
        texture_row("recurrence_width", "width of the recurring rectangle", "pixels", neither, whole,
                    "The width of the tile, or of the other rectangle that could recur."),
        texture_row("lattice_power", "power at 1/T", "of the power", lower, three,
                    "The part of the power of a tiling of 16 x 16 tiles at whole multiples of one over the side of a "
                    "tile, with "
                    "what chance gives. Independent tiles have 1/256; one tile again and again has 1."),
        texture_row("double_lattice_power", "power at 1/2T", "of the power", lower, three,
                    "This is the share at multiples of one over two sides of a tile: sets whose colours alternate have "
                    "no peaks at 1/T. Independent tiles have 1/64."),
        texture_row(
            "color_distance", "colour distance", "levels", lower, three,
            "By how many of 255 levels pixels of the tiling must change on average to have the exemplar's colours."),
        texture_row("histogram_spread", "colour distance, in own spreads", "times the exemplar's own", lower, three,
                    "The mean difference of quantiles of colours (1-Wasserstein) between windows of half of the "
                    "exemplar's side and such windows of the exemplar, over that between windows of the exemplar: 1 is "
                    "natural. With `compare = true`, as those that follow."),
        texture_row("histogram_largest", "largest colour difference", "", lower, three,
                    "The largest difference of cumulative distributions of a channel between such windows (Kolmogorov "
                    "and Smirnov)."),
        texture_row("contrast", "contrast", "of the exemplar's", neither, three,
                    "The mean standard deviation of lightness within squares of 4, 8, 16 and 32 pixels: below 1 where "
                    "blending takes contrast."),
        texture_row(
            "contrast_spread", "contrast distance, in own spreads", "times the exemplar's own", lower, three,
            "The mean difference of quantiles of these standard deviations, as of colours: also of textures whose "
            "contrast is right in the mean, but not everywhere."),
        texture_row("gradient_spread", "gradient distance, in own spreads", "times the exemplar's own", lower, three,
                    "The mean difference of quantiles of steps between neighbours, as of colours."),
        texture_row(
            "edge_loss", "lost edges", "times what is natural", lower, three,
            "The fraction by which the mean of the largest tenth of all steps between neighbours is below the "
            "exemplar's. If small steps increase, as in blends, their gain is added, but at most doubles the loss. The "
            "unit is the mean gradient distance between windows of the exemplar, but at least 2.5 %. Blurs and many "
            "blends lose edges; cuts of large pieces lose few."),
        texture_row(
            "edge_gain", "added edges", "times what is natural", lower, three,
            "The mean excess of all steps between neighbours over a limit, minus that of the exemplar, for the limit "
            "with the largest difference. It is divided by the exemplar's mean step and by the unit of lost edges. "
            "Visible seams add edges; means of pixels never do, by Jensen's inequality."),
        texture_row("structure_spread", "structure distance, in own spreads", "times the exemplar's own", lower, three,
                    "The difference of correlations of a steerable pyramid's magnitudes, between orientations, scales "
                    "and places (Portilla and Simoncelli 2000), as of colours, mean over four scales."),
        texture_row(
            "peak_correlation", "largest self-correlation", "", lower, three,
            "Of the texture's lightness with itself, moved by a quarter of the exemplar's side and more, at most by a "
            "quarter of 64 x 64 tiles, 4,096 x 4,096 pixels at most, or of a quilted picture: 1 repeats exactly."),
        texture_row("peak_times", "self-correlation, times chance", "times of chance", lower, three,
                    "The same over what chance alone gives in as large a picture of a random field with the exemplar's "
                    "correlations: about 1 where nothing repeats."),
        texture_row("contrast_peak", "largest self-correlation of contrast", "", lower, three,
                    "The same of standard deviations of lightness within squares of 16 pixels: lattices on which "
                    "blending takes contrast."),
        texture_row("contrast_peak_times", "that of contrast, times chance", "times of chance", lower, three,
                    "The same over what chance alone gives."),
        texture_row(
            "pixel_nanoseconds", "time a pixel", "ns", lower, three,
            "Of 1,920 x 1,080 pixels of the texture seen from straight above, each a texel large, on the device, "
            "without handing them over; with `timing = true`, of the first set."),
        texture_row("plain_frames", "such frames a second", "", higher, three,
                    "Pictures of 1,920 x 1,080 pixels in that time."),
        texture_row("frames", "frames a second", "", higher, three,
                    "Pictures of 1,024 x 576 pixels of the endless plane, between two mipmap levels of the packed "
                    "atlas, or of the exemplar of a texture without tiles, that the device draws and hands over; with "
                    "`timing = true`, of the first set."),
    };
    return all;
}

const std::vector<TextureGate>& texture_gates()
{
    static const std::vector<TextureGate> all{
        {"recurrence", 0.05, "repeats", "repetition"},
        {"edge_loss", 2, "blurs edges", "lost edges"},
        {"edge_gain", 2, "adds edges", "added edges"},
        {"novelty", 0.2, "breaks shapes", "shapes"},
    };
    return all;
}

const TextureGate& texture_gate(std::string_view key)
{
    const auto gate = std::ranges::find(texture_gates(), key, &TextureGate::key);
    if (gate == texture_gates().end()) throw std::out_of_range("no gate of textures is called " + std::string(key));
    return *gate;
}

std::optional<MeasuredValue> texture_value(const Measure& measure, const DistributionResult& texture)
{
    const auto found = std::ranges::find(texture.numbers, measure.key, &DistributionNumber::key);
    if (found == texture.numbers.end()) return std::nullopt;
    return MeasuredValue{found->value, found->standard_error};
}

DistributionNumber texture_number(const std::string& key, double value, std::optional<double> standard_error)
{
    const auto row = std::ranges::find(texture_measures(), key, &Measure::key);
    if (row == texture_measures().end()) throw std::out_of_range("no measure of textures is called " + key);
    return {key, row->title(), value, row->unit, standard_error};
}

std::string texture_measures_table()
{
    std::string text = "| key | measure | unit | meaning |\n| --- | --- | --- | --- |\n";
    for (const Measure& row : texture_measures())
        text += "| `" + row.key + "` | " + row.name + " | " + row.unit + " | " + row.meaning + " |\n";
    return text;
}

}
