// kind = "recursive-tiles": what it takes, its points, and its results.
#include "host/distribution/recursive_tiles/recursive_tile_run.hpp"

#include "base/densities/density_text.hpp"
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/programs/cache_folder.hpp"
#include "host/tile_sampling/recursive/recursive_sampler.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>

namespace poissonlab {
namespace {

constexpr std::uint32_t painting_pixels = 720; // along the longer side

/// So many points take some 2 GiB.
constexpr std::int64_t most_stamped_points = std::int64_t{1} << 24;

void window_keys(Keys& keys, RecursiveWindow& window)
{
    std::array<std::string, 2> at{"0", "0"};
    keys.text(
        "x", at[0],
        "the lowest tile of the window along x: a tile of level 0, and after a colon a digit from 0 to 3 for each "
        "level below, as in -5:0132");
    keys.text("y", at[1], "the same along y, with as many digits");
    keys.integers("size", window.size, {1, most_window_tiles}, {"width", "height"}, "of the window, in these tiles");
    if (!keys.is_read()) return;
    for (std::size_t k = 0; k < 2; ++k)
        keys.check(k == 0 ? "x" : "y", [&] { window.corner[k] = read_recursive_address(at[k]); });
    if (window.corner[0].digits.size() != window.corner[1].digits.size())
        throw keys.invalid(keys.is_given("y") ? "y" : "x",
                           fmt::format("must have as many digits after the colon as {} = {}",
                                       keys.is_given("y") ? "x" : "y", keys.is_given("y") ? at[0] : at[1]));
}

std::optional<Density> density_of(const RecursiveTileSettings& s)
{
    if (s.density.text.empty()) return std::nullopt;
    return density_of_text(s.density.text, s.density.from, s.window.size[0], s.window.size[1]);
}

RecursiveDensity demand_of(const RecursiveTileSettings& s, const std::optional<Density>& density)
{
    const std::array<std::uint64_t, 2> size{s.window.size[0], s.window.size[1]};
    return {s.points, size, static_cast<int>(s.window.corner[0].digits.size()), density};
}

void recursive_tile_keys(Keys& keys, RecursiveTileSettings& s)
{
    window_keys(keys, s.window);
    keys.integer("points", s.points, 1, most_stamped_points, "about so many points in the window").required();
    keys.picture_or_formula("density", s.density.text, s.density.from, "what points follow, over the window")
        .otherwise("the same everywhere");
    keys.integer("points_per_tile", s.points_per_tile, min_recursive_points, max_recursive_points,
                 "N, points of a tile before those of the tiles in its cells are drawn");
    keys.pictures("stamps", s.stamps, "pictures that are laid at the points").otherwise("dots");
    keys.number("stamp_size", s.stamp_size, {0.05, 100},
                "the mean length of a stamp's longest side; dots are half as wide")
        .unit("distances of points where they are densest");
    keys.flag("upright", s.is_upright, "whether stamps stay upright; else each is turned by an angle of its own");
    if (!keys.is_read()) return;
    if (!s.density.text.empty()) keys.check("density", [&] { static_cast<void>(demand_of(s, density_of(s))); });
}

std::string words_of(const RecursiveWindow& window)
{
    return fmt::format("{} x {} tiles from {}, {}", window.size[0], window.size[1], text_of(window.corner[0]),
                       text_of(window.corner[1]));
}

std::string recursive_tile_label(const RecursiveTileSettings& s)
{
    return s.density.text.empty() ? "Recursive tiles: " + words_of(s.window)
                                  : "Painted " + name_of_input(s.density.text);
}

DistributionResult make_recursive_tiles(const RecursiveTileSettings& s, std::uint64_t seed,
                                        const DistributionPlace& place, DistributionFiles& files)
{
    const StampedWindow window = stamped_window(s, seed, place);
    DistributionResult result;
    result.facts = {words_of(s.window), fmt::format("level {}", s.window.corner[0].digits.size()),
                    fmt::format("{} points", window.points.size())};
    if (!window.note.empty()) result.facts.push_back(window.note);
    const std::uint32_t longest = std::max(s.window.size[0], s.window.size[1]);
    const auto pixels = static_cast<int>(std::max(1U, painting_pixels * s.window.size[0] / longest));
    write_png(files.add("painting.png"), painting(s, window, pixels));
    result.pictures.push_back({"painting.png", s.stamps.empty() ? "The points." : "A stamp at each point."});
    write_whole_file(files.add("points.csv", result), stamps_csv(window));
    result.numbers = recursive_tile_numbers(s, window);
    return result;
}

}

StampedWindow stamped_window(const RecursiveTileSettings& s, std::uint64_t seed, const DistributionPlace& place)
{
    const std::optional<Density> density = density_of(s);
    const RecursiveDensity demand = demand_of(s, density);
    StampedWindow window{cached_recursive_tiles(s.points_per_tile, seed, cache_folder(), place.on_step).tiles,
                         stream_key(seed, Purpose::recursive_tilings, 0)[0],
                         density ? density->note : "",
                         1 / std::sqrt(static_cast<double>(demand.most()) * 0x1p-32),
                         {}};
    const auto root = [&](std::int64_t x, std::int64_t y) { return plane_root(window.seed, x, y); };
    for (const RecursivePoint& point : window_points(window.tiles, root, s.window, demand)) {
        const std::uint32_t bits = point_bits(window.seed, s.window, point.origin);
        window.points.push_back({place_in_window(s.window, point),
                                 (bits & 255) % static_cast<std::uint32_t>(std::max<std::size_t>(1, s.stamps.size())),
                                 s.is_upright ? 0 : (bits >> 8 & 255) * (2 * std::numbers::pi / 256),
                                 0.7 + 0.6 * (bits >> 16 & 255) / 255});
    }
    return window;
}

std::string stamps_csv(const StampedWindow& window)
{
    std::string text = "x,y,stamp,turn,size\n";
    for (const StampedPoint& point : window.points)
        fmt::format_to(std::back_inserter(text), "{},{},{},{},{}\n", point.place[0], point.place[1], point.stamp,
                       point.turn, point.size);
    return text;
}

DistributionNumbers recursive_tile_numbers(const RecursiveTileSettings& s, const StampedWindow& window)
{
    DistributionNumbers numbers{{"points", "Points", static_cast<double>(window.points.size()), "in the window"},
                                {"asked_for", "Asked for", static_cast<double>(s.points), "points"},
                                {"spacing", "Spacing", window.spacing,
                                 "tiles: the side of the square that a point has where points are densest"}};
    std::vector<std::array<double, 2>> places;
    for (const StampedPoint& point : window.points) places.push_back(point.place);
    std::ranges::sort(places);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t j = i + 1; j < places.size() && places[j][0] - places[i][0] < least; ++j)
            least = std::min(least, std::hypot(places[i][0] - places[j][0], places[i][1] - places[j][1]));
    if (places.size() >= 2)
        numbers.push_back({"relative_radius", "Relative radius", relative_radius(least / window.spacing, 1, 2),
                           "least distance of two points, 1 for the densest packing where points are densest"});
    return numbers;
}

Kind recursive_tile_kind()
{
    return make_kind<RecursiveTileSettings>(
        {"distribution", "recursive-tiles", "distribute recursive", "Recursive tiles",
         "Place points or stamps in a window of an endless tiling, at any zoom", false},
        recursive_tile_keys, recursive_tile_label, make_recursive_tiles);
}

}
