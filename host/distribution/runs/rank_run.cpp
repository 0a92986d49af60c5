// kind = "self-similar-tile" and "ranks": the tile of D 4.7, how it is found and ranked, and points of a density from
// it.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, figures 4.38 to 4.44, table 4.1, figures 7.2 and 7.4.
#include "base/densities/density_values.hpp"
#include "base/files/whole_file.hpp"
#include "host/device/device_memory.hpp"
#include "host/distribution/density_measures.hpp"
#include "host/distribution/place_file.hpp"
#include "host/distribution/runs/run_numbers.hpp"
#include "host/distribution/self_similar_search.hpp"
#include "host/kinds/kinds.hpp"
#include "host/settings/distributions/distribution_config.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace poissonlab {
namespace {

/// The key `tile_points`.
void tile_size_key(Keys& keys, SelfSimilarChoice& tile)
{
    keys.integer("tile_points", tile.points, 8, 24, "points of the tile, a multiple of 4");
    if (tile.points % 4 != 0) throw keys.invalid("tile_points", "must be a multiple of 4");
}

/// The keys `tile_points` and `starts`, by default those of D table 4.1.
void tile_keys(Keys& keys, SelfSimilarChoice& tile)
{
    tile_size_key(keys, tile);
    std::array<std::uint32_t, 2> starts{tile.x, tile.y};
    keys.integers("starts", starts, {0, UINT32_MAX}, {"x", "y"},
                  "the words that the coordinates of its points start from");
    if (!keys.is_given("starts")) {
        if (tile.points != 16) throw keys.invalid("tile_points", "needs starts, unless it is 16");
        return;
    }
    for (const std::uint32_t start : starts)
        if (std::uint64_t{start} >> tile.points != 0 || 2 * std::popcount(start) != static_cast<int>(tile.points))
            throw keys.invalid("starts", fmt::format("must be words of {} bits, half of them ones", tile.points));
    tile.x = starts[0];
    tile.y = starts[1];
}

void self_similar_keys(Keys& keys, SelfSimilarSettings& s)
{
    keys.word("show", s.show, {"tile", "ranks", "progression", "function", "search"}, "what is shown of the tile");
    if (s.show != "search" || !keys.is_read())
        tile_keys(keys, s.tile);
    else if (keys.is_given("starts"))
        throw keys.invalid("starts", "cannot be combined with show = \"search\", which finds them");
    else
        tile_size_key(keys, s.tile);
    keys.number("least_radius", s.least_radius, {0.3, 1}, "of a search: the least relative radius of tiles");
    keys.integer("repeats", s.repeats, 1, 6, "of the function: how many times it is applied");
}

std::string self_similar_label(const SelfSimilarSettings& s)
{
    return s.show == "search" ? fmt::format("Self-similar tiles of {} points", s.tile.points)
                              : fmt::format("The self-similar tile: {}", s.show);
}

void rank_keys(Keys& keys, RankSettings& s)
{
    keys.density(s.density);
    keys.points(s.points, "the number of points, about");
    tile_keys(keys, s.tile);
    keys.number("zoom", s.zoom, {1, 1000}, "the picture's middle is used, one over this of each side");
}

std::string rank_label(const RankSettings& s) { return "Ranked points by " + name_of_input(s.density.text); }

constexpr int tile_pixels = 480;
constexpr double dot_radius = 0.012;
constexpr double circle_width = 0.004;

MarkPicture unit_picture()
{
    MarkPicture picture;
    picture.pixels = tile_pixels;
    MarkGroup frame{"#8a8f98"};
    frame.strokes = {{0, 0, 1, 0, 0.004}, {1, 0, 1, 1, 0.004}, {1, 1, 0, 1, 0.004}, {0, 1, 0, 0, 0.004}};
    picture.groups = {frame};
    return picture;
}

std::vector<std::array<double, 2>> unit_points(const std::vector<SelfSimilarPoint>& points)
{
    const double units = (1u << points.size()) - 1.0;
    std::vector<std::array<double, 2>> places;
    for (const SelfSimilarPoint& point : points) places.push_back({point[0] / units, point[1] / units});
    return places;
}

MarkGroup dots_at(const std::vector<std::array<double, 2>>& places, double radius, const std::string& color = "#000000")
{
    MarkGroup group{color};
    for (const auto& [x, y] : places) group.disks.push_back({x, y, radius});
    return group;
}

/// Rings are white disks on coloured ones.
void add_rings(const std::vector<std::array<double, 2>>& places, double radius, MarkPicture& picture)
{
    picture.groups.push_back(dots_at(places, radius, "#c02020"));
    picture.groups.push_back(dots_at(places, radius - circle_width, "#ffffff"));
}

/// The point set, and copies of half the size in its quarters, with a ring around each point of the whole.
void show_tile(const std::vector<SelfSimilarPoint>& points, DistributionFiles& files, DistributionResult& result)
{
    const auto places = unit_points(points);
    MarkPicture whole = unit_picture();
    whole.groups.push_back(dots_at(places, dot_radius));
    files.add_marks("points.json", whole, "(a) The points.", result);
    MarkPicture quarters = unit_picture();
    add_rings(places, 2 * dot_radius, quarters);
    std::vector<std::array<double, 2>> copies;
    for (const double x : {0.0, 0.5})
        for (const double y : {0.0, 0.5})
            for (const auto& place : places) copies.push_back({x + place[0] / 2, y + place[1] / 2});
    quarters.groups.push_back(dots_at(copies, dot_radius));
    files.add_marks("quarters.json", quarters,
                    "(b) Copies at half the size in each quarter; rings are the points of the whole.", result);
}

/// Rank, numerators and coordinates, as D table 4.1 has them.
std::string ranks_text(const std::vector<SelfSimilarPoint>& ranked)
{
    std::string text = "rank,x_units,y_units,x,y\n";
    const auto places = unit_points(ranked);
    for (std::size_t i = 0; i < ranked.size(); ++i)
        text += fmt::format("{},{},{},{:.8f},{:.8f}\n", i, ranked[i][0], ranked[i][1], places[i][0], places[i][1]);
    return text;
}

void show_ranks(const std::vector<SelfSimilarPoint>& ranked, DistributionFiles& files, DistributionResult& result)
{
    const auto places = unit_points(ranked);
    MarkPicture points = unit_picture(), words = unit_picture();
    points.groups.push_back(dots_at(places, dot_radius));
    for (std::size_t i = 0; i < places.size(); ++i)
        words.words.push_back({{places[i][0], places[i][1] - 0.015}, 0.045, fmt::format("{}", i)});
    files.add_marks("points.json", points, "(a) The points.", result);
    files.add_marks("ranks.json", words, "(b) Their ranks.", result);
    write_whole_file(files.add("ranks.csv", result), ranks_text(ranked));
}

void show_progression(const std::vector<SelfSimilarPoint>& ranked, DistributionFiles& files, DistributionResult& result)
{
    const auto places = unit_points(ranked);
    for (std::size_t part = 1; part <= 4; ++part) {
        const std::size_t count = part * places.size() / 4;
        MarkPicture picture = unit_picture();
        picture.groups.push_back(
            dots_at({places.begin(), places.begin() + static_cast<std::ptrdiff_t>(count)}, dot_radius));
        files.add_marks(fmt::format("first-{}.json", count), picture,
                        fmt::format("({}) The first {} points.", "abcd"[part - 1], count), result);
    }
}

/// Doubling modulo 1, so many times.
void show_function(std::uint32_t repeats, DistributionFiles& files, DistributionResult& result)
{
    MarkPicture picture = unit_picture();
    MarkGroup lines{"#1356a2"};
    const std::uint32_t pieces = 1u << repeats;
    for (std::uint32_t i = 0; i < pieces; ++i)
        lines.strokes.push_back({i / static_cast<double>(pieces), 0, (i + 1) / static_cast<double>(pieces), 1, 0.006});
    picture.groups.push_back(lines);
    files.add_marks("function.json", picture,
                    fmt::format("2x modulo 1, {} {}.", repeats, repeats == 1 ? "time" : "times"), result);
}

std::vector<FoundStarts> found_tiles(const SelfSimilarSettings& settings, const DistributionPlace& place)
{
    const std::uint32_t points = settings.tile.points;
    if (place.engine == Engine::reference) return reference::search_self_similar(points, settings.least_radius);
    Device& device = place.device();
    check_fits("the search", self_similar_memory(points), device.info());
    return search_self_similar(device, points, settings.least_radius, [&](double done) {
        if (place.on_step) place.on_step(fmt::format("self-similar tiles of {} points: {:.0f} %", points, 100 * done));
    });
}

/// The best tiles, one of each radius, and a list of all.
void show_search(const SelfSimilarSettings& settings, const DistributionPlace& place, DistributionFiles& files,
                 DistributionResult& result)
{
    constexpr std::size_t most_pictures = 6;
    const std::uint32_t points = settings.tile.points;
    const std::vector<FoundStarts> found = found_tiles(settings, place);
    if (found.empty())
        throw InputError(
            fmt::format("no tile of {} points has a relative radius of {} or more", points, settings.least_radius));
    std::string text = "x,y,squared_distance,relative_radius\n";
    std::uint64_t before = 0;
    std::size_t different = 0;
    for (const FoundStarts& tile : found) {
        const double radius = self_similar_radius(tile.squared, points);
        text += fmt::format("{},{},{},{:.6f}\n", tile.starts.x, tile.starts.y, tile.squared, radius);
        if (tile.squared == before) continue;
        before = tile.squared;
        if (++different > most_pictures) continue;
        MarkPicture picture = unit_picture();
        picture.groups.push_back(dots_at(unit_points(self_similar_points(tile.starts, points)), dot_radius));
        files.add_marks(fmt::format("best-{}.json", different), picture,
                        fmt::format("Relative radius {:.4f}, starts {} and {}.", radius, tile.starts.x, tile.starts.y),
                        result);
        result.numbers.push_back({fmt::format("radius_{}", different), fmt::format("Radius {}", different), radius,
                                  fmt::format("starts {} and {}", tile.starts.x, tile.starts.y)});
    }
    // D 4.7.2.2 has 19.64, 17.62, 16.12 and 14.00 % for 16, 20, 24 and 32 points.
    result.numbers.push_back({"balanced_share", "Balanced sequences", balanced_share(points),
                              "of all starts: half of the sequence of each lies below 1/2"});
    for (const std::uint32_t others : {16u, 20u, 24u, 32u})
        if (others != points)
            result.numbers.push_back({fmt::format("balanced_share_{}", others), "Balanced sequences",
                                      balanced_share(others), fmt::format("of {} points", others)});
    write_whole_file(files.add("starts.csv", result), text);
    result.facts = {fmt::format("{} points", points),
                    fmt::format("{} tiles of a relative radius of {} or more, {} different radii", found.size(),
                                settings.least_radius, different)};
}

DistributionResult make_self_similar_tile(const SelfSimilarSettings& settings, std::uint64_t,
                                          const DistributionPlace& place, DistributionFiles& files)
{
    DistributionResult result;
    if (settings.show == "search") {
        show_search(settings, place, files, result);
        return result;
    }
    if (settings.show == "function") {
        show_function(settings.repeats, files, result);
        return result;
    }
    const SelfSimilarStarts starts{settings.tile.x, settings.tile.y};
    const auto points = self_similar_points(starts, settings.tile.points);
    const std::uint64_t squared = squared_min_distance(starts, settings.tile.points);
    result.facts = {fmt::format("{} points", settings.tile.points),
                    fmt::format("starts {} and {}", starts.x, starts.y)};
    result.numbers.push_back(
        {"relative_radius", "Relative radius", self_similar_radius(squared, settings.tile.points), "on the torus"});
    const auto ranked = ranked_points(points, 0);
    if (settings.show == "tile") show_tile(points, files, result);
    if (settings.show == "ranks") show_ranks(ranked, files, result);
    if (settings.show == "progression") show_progression(ranked, files, result);
    return result;
}

DistributionResult make_ranked(const RankSettings& settings, std::uint64_t, const DistributionPlace&,
                               DistributionFiles& files)
{
    const Density density = rank_density(settings);
    const auto ranked = ranked_points(self_similar_points({settings.tile.x, settings.tile.y}, settings.tile.points), 0);
    const auto points = subdivided_points(ranked, density, static_cast<double>(settings.points));
    const PixelPlaces places = places_of(points);

    DistributionResult result;
    result.facts = {
        fmt::format("{} x {} pixels", density.width, density.height),
        fmt::format("{} points, asked for {}", points.size(), settings.points),
        fmt::format("tile of {} points, starts {} and {}", settings.tile.points, settings.tile.x, settings.tile.y)};
    if (!density.note.empty()) result.facts.push_back(density.note);
    MarkPicture picture;
    picture.width = density.width;
    picture.height = density.height;
    MarkGroup dots;
    const double radius =
        0.12 * std::sqrt(picture.width * picture.height / std::max<double>(1, static_cast<double>(points.size())));
    for (const SubdividedPoint& point : points) dots.disks.push_back({point.x, point.y, radius});
    picture.groups.push_back(std::move(dots));
    files.add_marks("points.json", picture, "The points.", result);
    write_places(files.add("points.npy", result), places,
                 static_cast<std::uint32_t>(std::max(density.width, density.height)), "");
    result.numbers = rank_numbers(settings, density, places);
    return result;
}

}

Density rank_density(const RankSettings& settings)
{
    const PixelValues values =
        middle_of(values_of_text(settings.density.text, settings.density.from, 1, 1), settings.zoom);
    return density_of_values(values.width, values.height, values.values, printable(shortened(settings.density.text)));
}

DistributionNumbers rank_numbers(const RankSettings& settings, const Density& density, const PixelPlaces& places)
{
    DistributionNumbers numbers;
    numbers.push_back({"asked_for", "Asked for", static_cast<double>(settings.points), "points"});
    numbers.push_back({"points", "Points", static_cast<double>(places.size()) / 2, "of those asked for"});
    if (places.size() < 4) return numbers;
    numbers.push_back({"density_error", "Density error", density_error(density, places), density_error_meaning});
    const LocalSpacing spacing = local_spacing(density, places);
    numbers.push_back({"mean_spacing", "Mean nearest distance", spacing.mean,
                       "of the largest one that the density allows at each point"});
    numbers.push_back({"least_spacing", "Least nearest distance", spacing.least, "the same of the nearest pair"});
    return numbers;
}

Kind self_similar_kind()
{
    return make_kind<SelfSimilarSettings>({"distribution", "self-similar-tile", "", "Self-similar tile",
                                           "The ranked tile that has copies of itself in its quarters"},
                                          self_similar_keys, self_similar_label, make_self_similar_tile);
}

Kind rank_kind()
{
    return make_kind<RankSettings>({"distribution", "ranks", "distribute rank", "Ranked points",
                                    "Take the points of a self-similar tile whose ranks a density asks for"},
                                   rank_keys, rank_label, make_ranked);
}

}
