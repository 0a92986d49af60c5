#include "host/texture/advice/texture_advice.hpp"

#include "base/errors/errors.hpp"
#include "host/texture/advice/picture_scales.hpp"
#include "host/texture/exemplar.hpp"
#include "host/texture/flattening.hpp"
#include "host/texture/regular/seen_waves.hpp"
#include "host/texture/regular/wave_comb.hpp"
#include "tiles/texture/tiling_measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace poissonlab {
namespace {

/// Pictures are reduced to so many pixels before they are measured.
constexpr std::size_t measured_pixels = std::size_t{1} << 18;

/// Means over squares as wide as the scale have this part of the variance.
constexpr double scale_share = 0.25;

/// The contrast of parts of a texture differs by less than this, in octaves, and their lightness has a smaller part of
/// the variance.
constexpr double most_contrast_spread = 0.25, most_part_variance = 0.35;

/// The picture is divided into at most so many parts along each side, which have at least so many pixels.
constexpr int most_parts = 4, least_part_pixels = 32;

/// The middle of a picture with one object has more contrast than the rim by so many octaves.
constexpr double least_object_octaves = 1;

/// Views from other angles are looked at if the picture is this regular from straight above.
constexpr double least_suspected_times = 6;

int shorter_side(const PngPixels& picture) { return std::min(picture.width, picture.height); }

/// The sizes of tiles that the picture has room for: powers of two, of which engines make levels.
std::vector<int> tile_sizes(const PngPixels& picture)
{
    std::vector<int> sizes;
    for (const auto& [size, least_side] : {std::pair(64, 128), std::pair(128, 256), std::pair(256, 768)})
        if (shorter_side(picture) >= least_side) sizes.push_back(size);
    if (sizes.empty()) sizes.push_back(std::max(least_tile_pixels, shorter_side(picture) / 4 * 2));
    return sizes;
}

/// The reduced picture without light that is slower than two tiles: a square of 7/4 of a tile has the variance of a
/// Gaussian of half a tile.
LightMap even_light(const LightMap& light, int factor, int size)
{
    return without_slow_light(light, std::max(1, size * 7 / (8 * factor)));
}

/// Takes the smallest size that is wide enough, or the largest one.
void choose_size(TextureAdvice& advice, const PngPixels& picture, const LightMap& light, int factor)
{
    for (const int size : tile_sizes(picture)) {
        advice.size = size;
        advice.scale = side_at_share(even_light(light, factor, size), scale_share);
        if (advice.scale) *advice.scale *= factor;
        advice.is_wide = !advice.scale || least_tile_scales * *advice.scale > size;
        if (!advice.is_wide) break;
    }
    advice.colors = advised_colors(advice.size);
}

/// Finds light that texture build flattens by itself, by the measurement that it makes.
void measure_light(TextureAdvice& advice, const PngPixels& picture)
{
    const UnevenLight light = uneven_light(picture, advice.size);
    advice.slow_power = light.share;
    advice.is_flattened = light.is_uneven();
}

/// A part of a map: the mean, and the mean step from one pixel to the next along both axes.
struct PartOfLight
{
    double mean = 0;
    double steps = 0;
};

PartOfLight part_of(const LightMap& light, int left, int top, int right, int bottom)
{
    PartOfLight part;
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) {
            part.mean += light.at(x, y);
            if (x + 1 < right) part.steps += std::abs(light.at(x + 1, y) - light.at(x, y));
            if (y + 1 < bottom) part.steps += std::abs(light.at(x, y + 1) - light.at(x, y));
        }
    const double pixels = static_cast<double>(right - left) * (bottom - top);
    return {part.mean / pixels, part.steps / pixels};
}

double variance_of(const std::vector<double>& values)
{
    const double count = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
    double squares = 0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    return squares / count;
}

/// By how many octaves the middle of a square of parts has more contrast than the rim.
double middle_over_rim(const std::vector<double>& contrasts, int parts)
{
    double middle = 0, rim = 0;
    int middles = 0;
    for (int i = 0; i < parts * parts; ++i) {
        const int x = i % parts, y = i / parts;
        const bool is_middle = x > 0 && y > 0 && x + 1 < parts && y + 1 < parts;
        (is_middle ? middle : rim) += contrasts[static_cast<std::size_t>(i)];
        middles += is_middle ? 1 : 0;
    }
    return middles == 0 ? 0 : middle / middles - rim / (parts * parts - middles);
}

/// Compares the parts of the picture, side by side.
void compare_parts(TextureAdvice& advice, const LightMap& light)
{
    const int parts = std::clamp(std::min(light.width, light.height) / least_part_pixels, 2, most_parts);
    const double variance = variance_of(light.values);
    std::vector<double> means, contrasts;
    for (int j = 0; j < parts; ++j)
        for (int i = 0; i < parts; ++i) {
            const PartOfLight part = part_of(light, i * light.width / parts, j * light.height / parts,
                                             (i + 1) * light.width / parts, (j + 1) * light.height / parts);
            means.push_back(part.mean);
            // A plain part has one hundredth of the picture's contrast.
            contrasts.push_back(std::log2(part.steps + 0.01 * std::sqrt(variance)));
        }
    advice.part_variance = variance_of(means) / variance;
    advice.contrast_spread = std::sqrt(variance_of(contrasts));
    if (advice.contrast_spread > most_contrast_spread)
        advice.obstacle = middle_over_rim(contrasts, parts) > least_object_octaves ? TextureObstacle::one_object
                                                                                   : TextureObstacle::not_alike;
    else if (advice.part_variance > most_part_variance)
        advice.obstacle = TextureObstacle::other_colors;
}

/// Looks for what is regular, in the reduced picture. Most pictures have nothing, which is soon seen.
void find_periods(TextureAdvice& advice, const ReducedPicture& reduced, const LightMap& light)
{
    const WaveSpectrum spectrum(windowed(light));
    if (spectrum.strongest().times < least_suspected_times && !stands_out_together(strongest_comb(spectrum))) return;
    const SeenWaves seen = seen_waves(reduced.pixels);
    bool fits = seen.slope.east == 0 && seen.slope.south == 0;
    for (RegularWave wave : seen.waves) {
        wave.x /= reduced.factor;
        wave.y /= reduced.factor;
        if (2 * wave.period() > 3 * advice.size) continue;
        advice.periods.push_back(wave.period());
        fits = fits && fits_tiles(wave, advice.size);
    }
    advice.is_straightened = !advice.periods.empty() && !fits;
}

}

TextureAdvice advise_texture(const PngPixels& picture)
{
    if (shorter_side(picture) < least_tile_pixels)
        throw InputError(fmt::format("{} x {} pixels: must have at least {} x {}", picture.width, picture.height,
                                     least_tile_pixels, least_tile_pixels));
    TextureAdvice advice;
    advice.width = picture.width;
    advice.height = picture.height;
    const ReducedPicture reduced = reduced_picture(picture, measured_pixels);
    const LightMap light = lightness_map(reduced.pixels);
    const bool has_one_color = std::ranges::all_of(light.values, [&](double v) { return v == light.values.front(); });
    if (has_one_color) {
        advice.obstacle = TextureObstacle::one_color; // of no scale
        advice.size = tile_sizes(picture).front();
        advice.colors = advised_colors(advice.size);
    } else {
        choose_size(advice, picture, light, reduced.factor);
    }
    TextureRequest request;
    request.is_joint_open = true;
    take_advice(request, advice, true, true);
    advice.is_joint = request.joint;
    if (has_one_color) return advice;
    measure_light(advice, picture);
    compare_parts(advice, light);
    if (advice.is_texture() && shorter_side(picture) < 2 * advice.size) advice.obstacle = TextureObstacle::too_small;
    if (advice.is_texture()) find_periods(advice, reduced, light);
    return advice;
}

TextureAdvice advise_file(const std::filesystem::path& picture)
{
    const PngPixels pixels = read_exemplar(picture);
    try {
        return advise_texture(pixels);
    } catch (const InputError& error) {
        throw error.moved_to({picture.string()});
    }
}

Color advised_colors(int size) { return size > 128 ? 2 : 3; } // as many pixels as 256 tiles of 64

void take_advice(TextureRequest& request, const TextureAdvice& advice, bool is_size_open, bool are_colors_open)
{
    if (is_size_open) request.size = advice.size;
    if (are_colors_open && request.kind != TextureKind::omega) {
        // Half of the colours of corners are those of marked ones; Wang tiles have all marks of their corners.
        const Color marked = request.kind == TextureKind::corner ? 4 : 2;
        const Color colors = request.split > 0 ? marked : advised_colors(request.size);
        request.colors = {colors, colors};
    }
    settle_joint(request);
}

}
