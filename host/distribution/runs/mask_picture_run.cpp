// kind = "mask-picture" measures a mask of thresholds of any origin.
#include "base/images/png_file.hpp"
#include "base/images/raw_picture.hpp"
#include "host/distribution/masks/mask_picture.hpp"
#include "host/distribution/runs/run_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace poissonlab {
namespace {

constexpr double low_frequency = 0.125; ///< cycles a pixel
constexpr std::size_t first_ring = 2;   ///< whose frequencies say something about directions

void mask_picture_keys(Keys& keys, MaskPictureSettings& s)
{
    keys.picture("mask", s.mask, "the mask: a picture whose values are thresholds").required();
    keys.text("channel", s.channel, "which of its channels is measured, as its file names them: R, G, B, A")
        .otherwise("the only one, or the one that all colours have in common");
    if (!keys.is_read()) return;
    keys.check("mask", [&] { read_picture_header(s.mask); });
    keys.check(s.channel.empty() ? "mask" : "channel", [&] { read_mask_picture(s); });
}

std::string mask_picture_label(const MaskPictureSettings& s) { return "Mask " + name_of_input(s.mask.string()); }

void write_grey(const std::filesystem::path& file, const MaskPicture& mask, const std::vector<double>& values,
                double low, double high)
{
    std::vector<std::uint8_t> pixels;
    for (const double value : values)
        pixels.push_back(static_cast<std::uint8_t>(std::clamp((value - low) / (high - low) * 255 + 0.5, 0.0, 255.0)));
    write_png(file, {static_cast<int>(mask.width), static_cast<int>(mask.height), 1},
              [&](int first, int) { return &pixels[static_cast<std::size_t>(first) * mask.width]; });
}

/// Writes the power from -20 to 10 dB, with frequency 0 in the middle, as the mask stands upright.
void write_spectrum(const std::filesystem::path& file, const MaskPicture& mask, const std::vector<double>& power)
{
    std::vector<double> decibels(power.size());
    for (std::uint32_t row = 0; row < mask.height; ++row)
        for (std::uint32_t column = 0; column < mask.width; ++column) {
            const std::uint32_t v = (row + (mask.height + 1) / 2) % mask.height;
            const std::uint32_t u = (column + (mask.width + 1) / 2) % mask.width;
            decibels[std::size_t{row} * mask.width + column] =
                10 * std::log10(std::max(power[std::size_t{v} * mask.width + u], 1e-9));
        }
    write_grey(file, mask, decibels, -20, 10);
}

/// Writes squares in which the pixels below the first four thresholds up to half of all pixels are black.
void write_levels(const std::filesystem::path& file, const MaskPicture& mask, const std::vector<MaskLevel>& levels)
{
    constexpr std::uint32_t gap = 8, most_side = 128;
    std::vector<double> shown;
    for (const MaskLevel& level : levels)
        if (2 * level.below <= mask.pixels() && (shown.size() < 4)) shown.push_back(level.threshold);
    if (shown.empty()) shown.push_back(levels.front().threshold);
    const std::uint32_t wide = std::min(mask.width, most_side), high = std::min(mask.height, most_side);
    const auto count = static_cast<std::uint32_t>(shown.size());
    const std::uint32_t width = count * wide + (count - 1) * gap;
    std::vector<std::uint8_t> pixels(std::size_t{width} * high, 200);
    for (std::uint32_t i = 0; i < count; ++i)
        for (std::uint32_t y = 0; y < high; ++y)
            for (std::uint32_t x = 0; x < wide; ++x)
                pixels[std::size_t{y} * width + i * (wide + gap) + x] =
                    mask.values[std::size_t{y} * mask.width + x] < shown[i] ? 0 : 255;
    write_png(file, {static_cast<int>(width), static_cast<int>(high), 1},
              [&](int first, int) { return &pixels[static_cast<std::size_t>(first) * width]; });
}

ChartCurve ring_curve(const std::string& name, std::size_t color, const RingPower& rings,
                      const std::vector<double>& heights)
{
    ChartCurve curve{name, class_color(color), {}};
    for (std::size_t k = 0; k < heights.size(); ++k) curve.places.push_back({rings.frequency[k], heights[k]});
    return curve;
}

std::string part_words(const MaskPicture& mask, const MaskLevel& level)
{
    return fmt::format("{:.4g} %", 100 * static_cast<double>(level.below) / static_cast<double>(mask.pixels()));
}

CurveChart power_curves(const MaskPicture& mask, const RingPower& own, const std::vector<MaskLevel>& levels)
{
    std::vector<ChartCurve> curves{ring_curve("values", 0, own, own.power)};
    const std::size_t every = levels.size() > 8 ? 2 : 1;
    for (std::size_t k = every - 1; k < levels.size(); k += every)
        if (2 * levels[k].below <= mask.pixels())
            curves.push_back(
                ring_curve(part_words(mask, levels[k]), curves.size(), levels[k].rings, levels[k].rings.power));
    return {{"frequency, cycles a pixel", 0, 0.5, 0.1}, {"radially averaged power", 0, 4, 1}, 1, curves};
}

/// Draws the anisotropy in decibels, which is 0 for noise without directions.
CurveChart anisotropy_curve(const RingPower& own)
{
    std::vector<double> decibels;
    for (const double part : own.anisotropy) decibels.push_back(10 * std::log10(std::max(part, 1e-9)));
    return {{"frequency, cycles a pixel", 0, 0.5, 0.1},
            {"anisotropy, dB", -10, 10, 5},
            0,
            {ring_curve("values", 0, own, decibels)}};
}

double mean_anisotropy(const RingPower& rings)
{
    double sum = 0, count = 0;
    for (std::size_t k = first_ring; k < rings.anisotropy.size(); ++k) {
        sum += rings.anisotropy[k];
        ++count;
    }
    return count > 0 ? 10 * std::log10(std::max(sum / count, 1e-9)) : 0;
}

DistributionTable level_table(const MaskPicture& mask, const std::vector<MaskLevel>& levels)
{
    DistributionTable table{
        "Pixels below thresholds, from the middle on those that are not",
        {"threshold", "pixels below", "part", "least distance, pixels", "mean nearest distance", "low power"},
        {}};
    for (const MaskLevel& level : levels)
        table.rows.push_back({fmt::format("{:.6g}", level.threshold), fmt::format("{}", level.below),
                              part_words(mask, level), fmt::format("{:.3f}", level.least_distance),
                              fmt::format("{:.3f}", level.mean_nearest), fmt::format("{:.4f}", level.low_power)});
    return table;
}

std::size_t distinct_values(const MaskPicture& mask)
{
    std::vector<double> values = mask.values;
    std::ranges::sort(values);
    return static_cast<std::size_t>(std::ranges::unique(values).begin() - values.begin());
}

DistributionNumbers mask_picture_numbers(const MaskPicture& mask, const RingPower& own,
                                         const std::vector<MaskLevel>& levels)
{
    DistributionNumbers numbers{
        {"histogram_error", "Error of the histogram", histogram_error(mask),
         "largest difference from an even histogram in the part of pixels up to a value; 0 where each value comes as "
         "often"},
        {"distinct_values", "Values", static_cast<double>(distinct_values(mask)), "that differ"},
        {"low_power", "Low power", mean_power_below(own, low_frequency),
         "mean power of the values at frequencies below an eighth of a cycle a pixel; white noise has 1"},
        {"anisotropy", "Anisotropy", mean_anisotropy(own),
         "dB, of the values' power; 0 without directions, from the third ring on"}};
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const std::string of = fmt::format("at threshold {:.6g}", levels[i].threshold);
        const auto add = [&](const char* key, const char* title, double value, const char* meaning) {
            numbers.push_back({fmt::format("{}_{}", key, i + 1),
                               fmt::format("{} {}", title, i + 1),
                               value,
                               std::string(meaning) + of,
                               {},
                               true});
        };
        add("below", "Pixels below", static_cast<double>(levels[i].below), "");
        add("least_distance", "Least distance", levels[i].least_distance, "pixels, ");
        add("mean_nearest", "Mean nearest distance", levels[i].mean_nearest, "of that of the densest packing, ");
        add("low_power", "Low power", levels[i].low_power, "of frequencies below half of the principal one, ");
    }
    return numbers;
}

DistributionResult measure_mask(const MaskPictureSettings& settings, std::uint64_t /*seed*/,
                                const DistributionPlace& /*place*/, DistributionFiles& files)
{
    const MaskPicture mask = read_mask_picture(settings);
    const double mean =
        std::accumulate(mask.values.begin(), mask.values.end(), 0.0) / static_cast<double>(mask.pixels());
    std::vector<double> centred;
    for (const double value : mask.values) centred.push_back(value - mean);
    const std::vector<double> power = field_power(centred, mask.width, mask.height);
    const RingPower own = ring_power(power, mask.width, mask.height);
    const std::vector<MaskLevel> levels = mask_levels(mask);
    DistributionResult result;
    result.facts = {fmt::format("{} x {} pixels", mask.width, mask.height),
                    mask.codes > 0 ? fmt::format("of {} values", mask.codes) : "floating point"};
    if (!mask.note.empty()) result.facts.push_back(mask.note);
    const auto [least, most] = std::ranges::minmax(mask.values);
    write_grey(files.add("mask.png"), mask, mask.values, least, most);
    result.pictures.push_back({"mask.png", "The mask, from its least to its largest value."});
    write_levels(files.add("thresholds.png"), mask, levels);
    result.pictures.push_back({"thresholds.png", "Pixels below the first thresholds of the table, in a corner."});
    write_spectrum(files.add("spectrum.png"), mask, power);
    result.pictures.push_back(
        {"spectrum.png", "Power of the values from -20 dB, black, to 10 dB, white; 0 dB is white noise. Frequency "
                         "0 is in the middle."});
    files.add_curves(
        "power", power_curves(mask, own, levels),
        "Radially averaged power of the values, which are white noise at 1, and of the pixels below thresholds.",
        result);
    files.add_curves("anisotropy", anisotropy_curve(own), "Anisotropy of the values: 0 dB is noise without directions.",
                     result);
    result.numbers = mask_picture_numbers(mask, own, levels);
    result.tables.push_back(level_table(mask, levels));
    return result;
}

}

Kind mask_picture_kind()
{
    return make_kind<MaskPictureSettings>(
        {"distribution", "mask-picture", "", "Mask", "Measure a picture as a mask of thresholds", false},
        mask_picture_keys, mask_picture_label, measure_mask);
}

}
