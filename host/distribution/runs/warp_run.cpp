// kind = "warp": warped points or lights, over the picture and alone, and how well they follow it.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, figures 7.1 and 7.3.
#include "base/files/whole_file.hpp"
#include "base/images/png_file.hpp"
#include "host/distribution/density_measures.hpp"
#include "host/distribution/distribution_run.hpp"
#include "host/distribution/place_file.hpp"
#include "host/distribution/runs/run_numbers.hpp"
#include "host/distribution/sky_lights.hpp"
#include "host/kinds/kinds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr int ground_pixels = 1024;

void warp_keys(Keys& keys, WarpSettings& s)
{
    keys.flag("environment", s.is_environment, "whether the picture is an environment map: weights are by solid angle");
    keys.density(s.density);
    keys.word("seen_from", s.seen_from, seen_from_names, "which way round the environment map goes");
    keys.points(s.points, "the number of points: tilings have exactly so many, other methods about");
    keys.even_points(s.method);
    if (keys.is_given("seen_from") && !s.is_environment)
        throw keys.invalid("seen_from", "needs " + keys.name_of("environment"));
    if (s.is_environment && s.density.from != "light")
        throw keys.invalid("environment", fmt::format("takes the light; leave {} out", keys.name_of("density_from")));
}

std::string warp_label(const WarpSettings& s)
{
    return fmt::format("{} points by {}", s.is_environment ? "Lights" : "Warped", name_of_input(s.density.text));
}

/// The weights as grey pixels: their square roots, which look about as light is seen. Wide pictures are made smaller.
PngPixels ground_of(const Density& density)
{
    const int step = (std::max(density.width, density.height) + ground_pixels - 1) / ground_pixels;
    PngPixels ground{std::max(1, density.width / step), std::max(1, density.height / step), 1, {}};
    std::vector<double> means;
    for (int row = ground.height; row-- > 0;)
        for (int column = 0; column < ground.width; ++column) {
            double sum = 0;
            for (int y = row * step; y < (row + 1) * step && y < density.height; ++y)
                for (int x = column * step; x < (column + 1) * step && x < density.width; ++x)
                    sum += static_cast<double>(
                        density.weights[static_cast<std::size_t>(y) * static_cast<std::size_t>(density.width) +
                                        static_cast<std::size_t>(x)]);
            means.push_back(sum);
        }
    // A few suns would leave all else black: the brightest hundredth is white.
    std::vector<double> sorted = means;
    const auto white = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) * 99 / 100);
    std::ranges::nth_element(sorted, white);
    const double full = *white > 0 ? *white : *std::ranges::max_element(means);
    for (const double mean : means)
        ground.values.push_back(static_cast<std::uint8_t>(std::lround(255 * std::sqrt(std::min(1.0, mean / full)))));
    return ground;
}

/// The dots of places, in pixels, whose diameter is a part of the mean distance between points.
MarkPicture dots_of(const Density& density, const PixelPlaces& places, const std::string& color, double part)
{
    MarkPicture picture{static_cast<double>(density.width), static_cast<double>(density.height)};
    const double radius =
        part / 2 * std::sqrt(picture.width * picture.height / (static_cast<double>(places.size()) / 2));
    MarkGroup dots{color};
    for (std::size_t i = 0; i < places.size(); i += 2)
        dots.disks.push_back(
            {static_cast<double>(places[i]) / 4294967296.0, static_cast<double>(places[i + 1]) / 4294967296.0, radius});
    picture.groups.push_back(std::move(dots));
    return picture;
}

DistributionResult make_warped(const WarpSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                               DistributionFiles& files)
{
    std::optional<LinearPicture> map;
    if (settings.is_environment) map = sky_map(settings.density.text);
    const Density density = map ? sky_density(*map, settings.density.text) : chosen_density(settings.density);
    const SquarePoints points = even_points(chosen_method(settings.method), settings.points, density.width,
                                            density.height, seed, place, map ? Seam::closed : Seam::open);
    const PixelPlaces places = warp_points(density, points, place);

    DistributionResult result;
    result.facts = {fmt::format("{} x {} pixels", density.width, density.height),
                    fmt::format("{} points", places.size() / 2), method_words(settings.method)};
    if (map) result.facts.push_back("seen from " + std::string(seen_from_names[settings.seen_from]));
    if (!density.note.empty()) result.facts.push_back(density.note);
    write_png(files.add("density.png"), ground_of(density));
    result.pictures.push_back({"density.png", map ? "Luminance times solid angle." : "The density."});
    MarkPicture over = dots_of(density, places, "#e02020", map ? 0.25 : 0.2);
    over.ground = "density.png";
    files.add_marks("over.json", over, map ? "Lights over the map." : "Points over the density.", result);
    files.add_marks("points.json", dots_of(density, places, "#000000", 0.4), "The points.", result);
    write_places(files.add("points.npy", result), places,
                 static_cast<std::uint32_t>(std::max(density.width, density.height)), "");
    if (map)
        write_whole_file(files.add("lights.csv", result), lights_text(sky_lights(*map, places, settings.seen_from)));
    result.numbers = warp_numbers(map, density, places, points);
    return result;
}

}

DistributionNumbers warp_numbers(const std::optional<LinearPicture>& map, const Density& density,
                                 const PixelPlaces& places, const SquarePoints& points)
{
    DistributionNumbers numbers;
    if (map) numbers.push_back({"luminance", "Luminance", sky_luminance(*map), "of the whole map, times solid angle"});
    numbers.push_back({"density_error", "Density error", density_error(density, places), density_error_meaning});
    if (places.size() < 4) return numbers;
    const LocalSpacing spacing = local_spacing(density, places);
    const Density constant{density.width, density.height,
                           std::vector<std::uint64_t>(density.weights.size(), full_weight)};
    const PixelPlaces even = reference::warp_points(WarpTable(constant), points);
    const LocalSpacing before = local_spacing(constant, even);
    numbers.push_back({"mean_spacing", "Mean nearest distance", spacing.mean,
                       "of the largest one that the density allows at each point"});
    numbers.push_back({"least_spacing", "Least nearest distance", spacing.least, "the same of the nearest pair"});
    numbers.push_back(
        {"mean_spacing_before", "Mean before warping", before.mean, "of the even points over the same rectangle"});
    numbers.push_back({"least_spacing_before", "Least before warping", before.least, "of their nearest pair"});
    return numbers;
}

Kind warp_kind()
{
    return make_kind<WarpSettings>({"distribution", "warp", "distribute warp", "Warped points",
                                    "Move even points by the inverse cumulative distribution of a density"},
                                   warp_keys, warp_label, make_warped);
}

}
