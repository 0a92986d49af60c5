#include "host/distribution/masks/mask_measures.hpp"

#include "base/files/npy_header.hpp"
#include "base/files/whole_file.hpp"
#include "base/images/png_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace poissonlab {
namespace {

/// BART's arrays: real and imaginary part of each value in floats of the machine, the first dimension fastest. The
/// header names 16 dimensions, of which readout is the first and phase encodings are the second and third.
void write_bart(const std::filesystem::path& file, const SamplingMask& mask)
{
    const std::vector<std::uint8_t> pixels = mask.pixels();
    std::vector<float> values;
    values.reserve(2 * pixels.size());
    for (std::uint32_t column = 0; column < mask.columns; ++column)
        for (std::uint32_t row = 0; row < mask.rows; ++row) {
            values.push_back(pixels[std::size_t{row} * mask.columns + column]);
            values.push_back(0);
        }
    std::filesystem::path header = file;
    header.replace_extension(".hdr");
    write_whole_file(header, fmt::format("# Dimensions\n1 {} {} 1 1 1 1 1 1 1 1 1 1 1 1 1\n", mask.rows, mask.columns));
    write_whole_file(file,
                     std::string_view(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)));
}

}

void write_mask(const std::filesystem::path& file, const SamplingMask& mask)
{
    if (file.extension() == ".cfl") return write_bart(file, mask);
    std::vector<std::uint8_t> pixels = mask.pixels();
    if (file.extension() == ".png") {
        for (std::uint8_t& pixel : pixels) pixel = pixel == 0 ? 0 : 255;
        return write_png(file, {static_cast<int>(mask.columns), static_cast<int>(mask.rows), 1},
                         [&](int first, int) { return &pixels[static_cast<std::size_t>(first) * mask.columns]; });
    }
    write_whole_file(file, npy_header_of("'|u1'", fmt::format("({}, {})", mask.rows, mask.columns)) +
                               std::string(pixels.begin(), pixels.end()));
}

MaskDistances mask_distances(const MaskField& field, const SamplingMask& mask)
{
    const std::vector<std::uint8_t> is_sample = mask.pixels();
    std::vector<std::uint8_t> is_always(field.pixels());
    for (const std::uint32_t pixel : field.always) is_always[pixel] = 1;
    const double unit = static_cast<double>(mask.scale) * 0x1p-32; // squared distance for a cost of 1
    const double farthest = std::sqrt(unit * static_cast<double>(std::ranges::max(field.costs)) + 2);
    const auto reach = static_cast<std::int64_t>(std::clamp(std::ceil(farthest), 2.0, 4096.0));
    MaskDistances found{INFINITY, INFINITY};
    for (const std::uint32_t sample : mask.samples) {
        const std::int64_t column = sample % mask.columns, row = sample / mask.columns;
        for (std::int64_t y = std::max<std::int64_t>(0, row - reach); y <= row; ++y)
            for (std::int64_t x = std::max<std::int64_t>(0, column - reach); x <= column + reach && x < mask.columns;
                 ++x) {
                const auto other = static_cast<std::size_t>(y * mask.columns + x);
                if (other >= sample || is_sample[other] == 0 || (is_always[other] != 0 && is_always[sample] != 0))
                    continue;
                const auto squared = static_cast<double>((x - column) * (x - column) + (y - row) * (y - row));
                found.least = std::min(found.least, std::sqrt(squared));
                const auto cost = static_cast<double>(std::max(field.costs[sample], field.costs[other]));
                if (unit * cost == 0) continue; // any pixels are far enough apart
                const auto offsets = static_cast<double>(mask.offset(sample) + mask.offset(other)) * 0x1p-32;
                if (const double asked = unit * cost + offsets; asked > 0)
                    found.least_part = std::min(found.least_part, std::sqrt(squared / asked));
            }
    }
    return found;
}

std::vector<DistributionNumber> mask_numbers(const MaskField& field, const SamplingMask& mask)
{
    const auto samples = static_cast<double>(mask.samples.size());
    const MaskDistances distances = mask_distances(field, mask);
    std::vector<DistributionNumber> numbers{
        {"samples", "Samples", samples, "pixels of the mask"},
        {"acceleration", "Acceleration", static_cast<double>(field.pixels()) / samples,
         "pixels of the grid for each sample"},
        {"allowed", "Allowed", static_cast<double>(field.allowed_pixels()), "pixels that may be samples"},
        {"calibration", "Calibration", static_cast<double>(field.always.size()), "samples of the calibration area"}};
    if (std::isfinite(distances.least))
        numbers.push_back({"least_distance", "Least distance", distances.least,
                           "pixels, of two samples that are not in the calibration area both"});
    if (std::isfinite(distances.least_part))
        numbers.push_back({"least_part", "Least part", distances.least_part,
                           "the least distance in parts of what is asked for at both samples: 1 or more"});
    return numbers;
}

CurveChart mask_profile(const SamplingMask& mask)
{
    constexpr std::size_t bins = 32;
    std::vector<double> samples(bins), pixels(bins);
    const std::vector<std::uint8_t> is_sample = mask.pixels();
    for (std::size_t i = 0; i < is_sample.size(); ++i) {
        const double down = static_cast<double>(i / mask.columns) - mask.rows / 2;
        const double right = static_cast<double>(i % mask.columns) - mask.columns / 2;
        const auto bin = static_cast<std::size_t>(std::hypot(2 * down / mask.rows, 2 * right / mask.columns) * bins);
        if (bin >= bins) continue;
        samples[bin] += is_sample[i];
        pixels[bin] += 1;
    }
    ChartCurve curve{"samples", class_color(0), {}};
    for (std::size_t bin = 0; bin < bins; ++bin)
        if (pixels[bin] > 0)
            curve.places.push_back({(static_cast<double>(bin) + 0.5) / bins, samples[bin] / pixels[bin]});
    return {{"distance / half of the grid", 0, 1, 0.2}, {"part of pixels", 0, 1, 0.2}, 1, {curve}};
}

}
