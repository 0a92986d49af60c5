#include "host/distribution/stipple.hpp"

#include "base/errors/errors.hpp"
#include "base/images/png_file.hpp"
#include "host/distribution/density_measures.hpp"
#include "host/distribution/distribution_run.hpp"
#include "host/distribution/ink/line_directions.hpp"
#include "host/distribution/ranked_sets.hpp"
#include "host/distribution/relaxed_places.hpp"
#include "host/distribution/self_similar_tile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace poissonlab {
namespace {

constexpr int tone_window = 32; ///< pixels
constexpr double densest_disks = std::numbers::pi / (2 * std::numbers::sqrt3);
constexpr double most_marks = 1 << 24;
constexpr double most_tiled_points = 1 << 26; ///< that ranks choose marks of
constexpr double place_units_a_pixel = 4294967296.0;

PixelPlaces ranked_places(const Density& density, std::size_t points, std::uint64_t seed)
{
    const SelfSimilarChoice tile;
    const auto first = static_cast<std::size_t>((seed + tile.points - 1) % tile.points);
    const auto ranked = ranked_points(self_similar_points({tile.x, tile.y}, tile.points), first);
    return places_of(subdivided_points(ranked, density, static_cast<double>(points)));
}

/// Points of a tiling with ranked tiles, as large as the picture asks for: at the most ink all of them stay, elsewhere
/// those whose level is below the ink's part of it.
PixelPlaces tiled_places(const Density& density, const RankedSet& tiles, std::size_t points, std::uint64_t seed)
{
    double parts = 0; // of the most ink, in pixels
    for (const std::uint64_t weight : density.weights)
        parts += static_cast<double>(weight) / static_cast<double>(full_weight);
    const double looked_at = static_cast<double>(points) * static_cast<double>(density.weights.size()) / parts;
    if (looked_at > most_tiled_points)
        throw InputError(fmt::format("{} marks by the ranks of tiles: the darkest places are so small a part of the "
                                     "picture that they are chosen of {:.0f} points; must be at most {:.0f}",
                                     points, looked_at, most_tiled_points));
    const double side = std::sqrt(tiles.density() * parts / static_cast<double>(points)); // of a tile, or an edge
    PixelPlaces places;
    for (const LeveledPoint& point : tiles.points(density.width / side, density.height / side, seed)) {
        const double x = point.x * side, y = point.y * side;
        if (!(x < density.width && y < density.height)) continue;
        const std::uint64_t weight =
            density.weights[static_cast<std::size_t>(y) * static_cast<std::size_t>(density.width) +
                            static_cast<std::size_t>(x)];
        if (point.level * static_cast<double>(full_weight) >= static_cast<double>(weight)) continue;
        places.push_back(static_cast<std::uint64_t>(x * place_units_a_pixel));
        places.push_back(static_cast<std::uint64_t>(y * place_units_a_pixel));
    }
    return places;
}

/// A stroke of this length, round ends included, around a place.
std::array<double, 5> stroke_around(double x, double y, double angle, double length, double width)
{
    const double reach = (length - width) / 2, dx = reach * std::cos(angle), dy = reach * std::sin(angle);
    return {x - dx, y - dy, x + dx, y + dy, width};
}

void add_marks(const InkPicture& picture, const StippleSettings& settings, Stippling& stippling)
{
    const auto in_pixels = [](std::uint64_t place) { return static_cast<double>(place) / place_units_a_pixel; };
    std::optional<LineDirections> lines;
    if (settings.has_strokes && !settings.angle) lines.emplace(picture.ink, std::numbers::pi / 4);
    for (std::size_t i = 0; i < stippling.places.size(); i += 2) {
        const double x = in_pixels(stippling.places[i]), y = in_pixels(stippling.places[i + 1]);
        if (!settings.has_strokes)
            stippling.marks.disks.push_back({x, y, stippling.mark_width / 2});
        else
            stippling.marks.strokes.push_back(stroke_around(x, y, lines ? lines->at(x, y) : *settings.angle,
                                                            stippling.mark_width * settings.slenderness,
                                                            stippling.mark_width));
    }
}

Density constant_density(int width, int height)
{
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    return {width, height, std::vector<std::uint64_t>(pixels, full_weight)};
}

/// The least relative radius of so many points, 4,096 at most, that are relaxed where the ink is constant: they differ
/// from set to set by a hundredth or so.
double relaxed_radius(const StippleSettings& settings, std::size_t points, int width, int height,
                      const DistributionPlace& place)
{
    constexpr std::size_t enough_points = 4096;
    const Density constant = constant_density(width, height);
    const SquarePoints even =
        even_points(chosen_method(settings.method), std::min(points, enough_points), width, height, 1, place);
    const PixelPlaces places = relaxed_places(constant, warp_points(constant, even, place), settings.iterations, place,
                                              "from which ink on marks overlap: ");
    return std::min(1.0, local_spacing(constant, places).least);
}

/// The least relative radius of even points that marks are made of: before they are warped.
double even_radius(const InkPicture& picture, const StippleSettings& settings, const Stippling& stippling,
                   const DistributionPlace& place)
{
    if (settings.by == MarkPlaces::gaussian)
        return relaxed_radius(settings, stippling.asked, picture.ink.width, picture.ink.height, place);
    if (settings.by == MarkPlaces::ranks && !settings.method.tiles.empty()) {
        // Distances are of the marks that were asked for, which are as many as the tiles' scale says.
        return RankedSet(settings.method.tiles).relative_radius() *
               std::sqrt(static_cast<double>(stippling.places.size()) / 2 / static_cast<double>(stippling.asked));
    }
    if (settings.by == MarkPlaces::ranks) {
        // Points from the first quarter of the tile's to all of them, whichever are nearest to each other.
        const SelfSimilarChoice tile;
        const auto ranked = ranked_points(self_similar_points({tile.x, tile.y}, tile.points), 0);
        double least = 1;
        std::uint64_t squared = std::numeric_limits<std::uint64_t>::max();
        for (std::uint32_t n = 1; n <= tile.points; ++n) {
            for (std::uint32_t i = 0; i + 1 < n; ++i)
                squared = std::min(squared, squared_torus_distance(ranked[i], ranked[n - 1], tile.points));
            if (4 * n > tile.points)
                least = std::min(least, self_similar_radius(squared, tile.points) *
                                            std::sqrt(static_cast<double>(n) / tile.points));
        }
        return least;
    }
    const Density constant = constant_density(picture.ink.width, picture.ink.height);
    const PixelPlaces places = reference::warp_points(WarpTable(constant), stippling.even);
    return std::min(1.0, local_spacing(constant, places).least);
}

/// Tones are those that a viewer of the coverage's picture is shown.
double tone_error(const PixelValues& ink, const Coverage& coverage)
{
    double sum = 0;
    int windows = 0;
    for (int y0 = 0; y0 < ink.height; y0 += tone_window)
        for (int x0 = 0; x0 < ink.width; x0 += tone_window, ++windows) {
            double difference = 0;
            int pixels = 0;
            for (int y = y0; y < std::min(ink.height, y0 + tone_window); ++y)
                for (int x = x0; x < std::min(ink.width, x0 + tone_window); ++x, ++pixels)
                    difference += shown_part(shown_byte(
                                      coverage.parts[static_cast<std::size_t>(y) * static_cast<std::size_t>(ink.width) +
                                                     static_cast<std::size_t>(x)])) -
                                  ink.at(x, y);
            sum += std::abs(difference) / pixels;
        }
    return sum / windows;
}

}

double ink_of_lightness(double ink)
{
    constexpr double linear_end = 216.0 / 24'389; // (6 / 29)^3
    const double light = 1 - ink;
    const double root = light > linear_end ? std::cbrt(light) : (24'389.0 / 27 * light + 16) / 116;
    return std::clamp(1.16 * (1 - root), 0.0, 1.0);
}

InkPicture read_ink(const StippleSettings& settings)
{
    InkPicture picture{middle_of(values_of_text(settings.image, settings.from, 1, 1), settings.zoom), {}, 0};
    PixelValues& ink = picture.ink;
    for (std::size_t i = 0; i < ink.values.size(); ++i) {
        if (!(ink.values[i] >= 0 && ink.values[i] <= 1))
            throw InputError(fmt::format("image {}: {}: ink {}: must be from 0, white, to 1, black",
                                         printable(shortened(settings.image)), pixel_name(ink.width, ink.height, i),
                                         ink.values[i]));
        if (settings.tones == InkTones::lightness) ink.values[i] = ink_of_lightness(ink.values[i]);
        ink.values[i] *= settings.ink;
        picture.total += ink.values[i];
    }
    if (picture.total == 0)
        throw InputError(
            fmt::format("image {}: has no ink: is white everywhere", printable(shortened(settings.image))));
    picture.density = density_of_values(ink.width, ink.height, ink.values, printable(shortened(settings.image)));
    return picture;
}

double mark_area(const StippleSettings& settings, double width)
{
    const double disk = std::numbers::pi / 4;
    return width * width * (settings.has_strokes ? settings.slenderness - 1 + disk : disk);
}

Stippling stipple(const InkPicture& picture, const StippleSettings& settings, std::uint64_t seed,
                  const DistributionPlace& place)
{
    const double count = settings.points > 0 ? static_cast<double>(settings.points)
                                             : std::round(picture.total / mark_area(settings, settings.mark_width));
    if (count < 1 || count > most_marks)
        throw InputError(fmt::format("{:.0f} marks for the ink of {:.1f} pixels: must be from 1 to {:.0f}", count,
                                     picture.total, most_marks));
    const auto points = static_cast<std::size_t>(count);
    Stippling stippling;
    stippling.asked = points;
    if (settings.by == MarkPlaces::ranks) {
        stippling.places = settings.method.tiles.empty()
                               ? ranked_places(picture.density, points, seed)
                               : tiled_places(picture.density, RankedSet(settings.method.tiles), points, seed);
    } else {
        stippling.even = even_points(chosen_method(settings.method), points, picture.density.width,
                                     picture.density.height, seed, place);
        stippling.places = warp_points(picture.density, stippling.even, place);
        if (settings.by == MarkPlaces::gaussian)
            stippling.places = relaxed_places(picture.density, stippling.places, settings.iterations, place);
    }
    if (stippling.places.empty()) throw InputError("no marks: the ranks of so few points are all left out");
    stippling.mark_area = picture.total / (static_cast<double>(stippling.places.size()) / 2);
    stippling.mark_width = std::sqrt(stippling.mark_area / mark_area(settings, 1));
    stippling.nominal_width = settings.mark_width > 0 ? settings.mark_width : stippling.mark_width;
    // A mark reaches half of its length beyond the picture.
    stippling.margin =
        std::max(stippling.nominal_width, stippling.mark_width / 2) * (settings.has_strokes ? settings.slenderness : 1);
    add_marks(picture, settings, stippling);
    return stippling;
}

TonesOfMarks tones_of(const InkPicture& picture, const StippleSettings& settings, const Stippling& stippling,
                      const Coverage& coverage, const DistributionPlace& place)
{
    TonesOfMarks tones;
    const double length = stippling.mark_width * (settings.has_strokes ? settings.slenderness : 1);
    const double around = std::numbers::pi / 4 * length * length; // the disk that holds a mark
    if (stippling.places.size() >= 4) {
        const double radius = even_radius(picture, settings, stippling, place);
        tones.darkest_ink = densest_disks * radius * radius * stippling.mark_area / around;
    }
    const auto dark = std::ranges::count_if(picture.ink.values, [&](double ink) { return ink > tones.darkest_ink; });
    tones.too_dark = static_cast<double>(dark) / static_cast<double>(picture.ink.values.size());
    tones.overlap = coverage.laid > 0 ? std::max(0.0, 1 - coverage.covered / coverage.laid) : 0; // rounding
    tones.error = tone_error(picture.ink, coverage);
    return tones;
}

void write_coverage(const std::filesystem::path& file, const Coverage& coverage)
{
    std::vector<std::uint8_t> grey;
    grey.reserve(coverage.parts.size());
    const auto wide = static_cast<std::size_t>(coverage.width);
    for (std::size_t row = static_cast<std::size_t>(coverage.height); row-- > 0;)
        for (std::size_t column = 0; column < wide; ++column)
            grey.push_back(shown_byte(coverage.parts[row * wide + column]));
    write_png(file, {coverage.width, coverage.height, 1},
              [&](int first, int) { return &grey[static_cast<std::size_t>(first) * wide]; });
}

MarkPicture mark_picture(const InkPicture& picture, const Stippling& stippling)
{
    constexpr double units_a_mark = 20, most_units = 16'384;
    const double margin = stippling.margin;
    MarkPicture marks;
    marks.width = picture.ink.width + 2 * margin;
    marks.height = picture.ink.height + 2 * margin;
    const double units = marks.width * std::max(1.0, units_a_mark / stippling.nominal_width);
    marks.pixels = static_cast<int>(std::ceil(std::max(1.0, std::min(units, most_units))));
    MarkGroup& group = marks.groups.emplace_back(stippling.marks);
    for (auto& disk : group.disks)
        for (std::size_t k = 0; k < 2; ++k) disk[k] += margin;
    for (auto& stroke : group.strokes)
        for (std::size_t k = 0; k < 4; ++k) stroke[k] += margin;
    return marks;
}

}
