// kind = "objects": pictures of the procedural object distribution function, and how much of them is covered.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 7.6, figures 7.7 to 7.16.
#include "base/images/png_file.hpp"
#include "base/programs/interrupt.hpp"
#include "base/random/random.hpp"
#include "host/distribution/object_shapes.hpp"
#include "host/distribution/object_tiles.hpp"
#include "host/distribution/objects.hpp"
#include "host/distribution/tabled_noise.hpp"
#include "host/kinds/kinds.hpp"
#include "host/settings/distributions/distribution_config.hpp"
#include "tiles/poisson/proof/tile_certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace poissonlab {
namespace {

// The cost of looking objects up, in time and in calls of Perlin's noise.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 7.6.2.1 and 7.6.3, says about 5 calls in the plane and
// 20 in space, and not in which order. Noise is several times as fast along rows of pixels, where its permutations are
// in the cache: both orders are measured.

/// Calls a second, at random places and at those of pixels, row by row: medians of several times. They differ from run
/// to run.
struct LookupCosts
{
    double lookups_anywhere = 0;
    double lookups_in_rows = 0;
    double noise_anywhere = 0;
    double noise_in_rows = 0;
};

constexpr std::size_t timed_places = 1 << 14;
constexpr int timed_repeats = 9;
constexpr double noise_cells_a_tile = 8; ///< so that a cell of noise is about as large as an object of 64 in a tile

using TimedPlaces = std::vector<std::array<double, 3>>;

TimedPlaces random_places()
{
    std::mt19937 random(2);
    TimedPlaces places(timed_places);
    for (auto& place : places)
        for (double& number : place) number = static_cast<double>(random() % (1 << 24)) / (1 << 14);
    return places;
}

/// Rows of 256 pixels of which a tile has 180 along each side.
TimedPlaces places_in_rows()
{
    TimedPlaces places;
    for (std::size_t i = 0; i < timed_places; ++i)
        places.push_back({static_cast<double>(i % 256) / 180, static_cast<double>(i / 256) / 180, 0.37});
    return places;
}

/// Calls a second of processor time of what is called for each place: other programs that run do not count. The sum
/// keeps compilers from leaving calls out.
template <class Call>
double calls_a_second(const TimedPlaces& places, Call call)
{
    std::vector<double> seconds;
    volatile double kept = 0;
    for (int repeat = 0; repeat < timed_repeats; ++repeat) {
        stop_if_interrupted();
        const std::clock_t start = std::clock();
        double sum = 0;
        for (const auto& place : places) sum += call(place);
        kept = kept + sum;
        seconds.push_back(static_cast<double>(std::max<std::clock_t>(1, std::clock() - start)) / CLOCKS_PER_SEC);
    }
    std::ranges::nth_element(seconds, seconds.begin() + timed_repeats / 2);
    return static_cast<double>(places.size()) / seconds[timed_repeats / 2];
}

/// Measures the look-up on the host, of the runtime's header. Throws Interrupted.
LookupCosts lookup_costs(const ObjectTileSet& tiles)
{
    const pobjects distribution = tiles.distribution({1, 0});
    const bool is_in_space = tiles.tiles().parameters.dimension == 3;
    const TabledNoise noise;
    const auto look_up = [&](const std::array<double, 3>& place, pobjects_cursor* cursor) {
        return static_cast<double>(pobjects_at(&distribution, place.data(), cursor).point.id);
    };
    const auto call_noise = [&](const std::array<double, 3>& place) {
        const double x = place[0] * noise_cells_a_tile, y = place[1] * noise_cells_a_tile;
        return is_in_space ? noise.at(x, y, place[2] * noise_cells_a_tile) : noise.at(x, y);
    };
    const TimedPlaces anywhere = random_places(), rows = places_in_rows();
    pobjects_cursor cursor{};
    LookupCosts costs;
    costs.lookups_anywhere = calls_a_second(anywhere, [&](const auto& place) { return look_up(place, nullptr); });
    costs.lookups_in_rows = calls_a_second(rows, [&](const auto& place) { return look_up(place, &cursor); });
    costs.noise_anywhere = calls_a_second(anywhere, call_noise);
    costs.noise_in_rows = calls_a_second(rows, call_noise);
    return costs;
}

using namespace contract::objects;

void object_keys(Keys& keys, ObjectSettings& s)
{
    keys.integer("dimension", s.dimension, 2, 3, "objects in the plane, or in space");
    keys.word("object", s.object, object_looks(s.dimension), "the look of objects");
    keys.tiles(s.tiles).otherwise("corner tiles of 3 colours, 32 points; in space sphere tiles of 2, 128 points");
    keys.number("objects", s.objects, {1e-6, 1e6}, "objects in a unit square or cube, on average");
    keys.number("window", s.window, {1e-6, 1e3}, "the side of the picture").unit("units");
    keys.numbers("origin", s.origin, {{-1e6, 1e6}}, {"x", "y"}, "the lowest corner of the picture").unit("units");
    keys.word(
        "view", s.view, {"plane", "sphere", "torus", "table"},
        "what objects in space are seen on; those in the plane on the cloth of a table that is 0.6 windows wide, on a "
        "floor of granite");
    keys.integer("pixels", s.pixels, 16, 8192, "the width of the picture");
    keys.integer("samples", s.samples, 1, 15, "samples of a pixel along each axis");
    keys.integer("period", s.period, 0, 1 << 20, "after which everything repeats; 0: never").unit("tiles");
    keys.flag("timing", s.has_timing, "whether look-ups a second are measured");
    keys.spread("size", s.size, {0, 1}, "the size of objects, in parts of their disks");
    keys.spread("orientation", s.orientation, {-1e4, 1e4}, "how objects are turned").unit("radians");
    keys.spread("aspect", s.aspect, {0.01, 100}, "how much wider than high objects are");
    if (s.view != "plane" && (s.view == "table") != (s.dimension == 2))
        throw keys.invalid("view", s.dimension == 2 ? "is for dimension = 3, whose objects fill space"
                                                    : "is for dimension = 2, whose objects lie in the plane");
}

std::string object_label(const ObjectSettings& s)
{
    return fmt::format("Objects: {}{}", s.object, s.dimension == 3 ? " in space" : "");
}

/// Tiles a unit of length: D 7.6.2.2, where the text has its inverse.
double tiles_per_unit(const ObjectSettings& settings, std::uint32_t points_per_tile)
{
    const double tiles = settings.objects / points_per_tile;
    return settings.dimension == 3 ? std::cbrt(tiles) : std::sqrt(tiles);
}

ObjectScene scene_of(const ObjectSettings& settings, const ObjectTileSet& tiles)
{
    ObjectScene scene{};
    const double scale = tiles_per_unit(settings, tiles.tiles().parameters.points_per_tile);
    constexpr double place_units = 4294967296.0;
    scene.width = scene.height = settings.pixels;
    scene.samples = settings.samples;
    scene.view = settings.view == "sphere"  ? VIEW_SPHERE
                 : settings.view == "torus" ? VIEW_TORUS
                 : settings.view == "table" ? VIEW_CLOTH
                                            : VIEW_PLANE;
    scene.step = std::max<std::int64_t>(
        1, std::llround(settings.window * scale / settings.pixels / settings.samples * place_units));
    scene.left = std::llround(settings.origin[0] * scale * place_units) + scene.step / 2;
    scene.bottom = std::llround(settings.origin[1] * scale * place_units) + scene.step / 2;
    scene.z = 1 << 30;
    scene.radius = static_cast<float>(tiles.radius());
    scene.extent = static_cast<float>(settings.window * scale);
    scene.size = spread_of(settings.size, 1);
    scene.turn = spread_of(settings.orientation, 2 * std::numbers::pi);
    scene.aspect = spread_of(settings.aspect, 1);
    set_look(scene, settings.object, settings.dimension);
    return scene;
}

/// The mean of size^dimension over objects: what a constant size is to the share that disks cover. Those of other kinds
/// are cut at 0 and 1, so that their share is taken from the objects that are seen.
std::optional<double> mean_power_of_size(const SpreadChoice& size, int dimension)
{
    if (size.kind == SpreadChoice::Kind::constant) return std::pow(size.a, dimension);
    if (size.kind == SpreadChoice::Kind::normal) return std::nullopt;
    const int n = dimension + 1;
    if (size.b == size.a) return std::pow(size.a, dimension);
    return (std::pow(size.b, n) - std::pow(size.a, n)) / (n * (size.b - size.a));
}

void add_numbers(const ObjectSettings& settings, const ObjectTileSet& tiles, const ObjectPicture& picture,
                 DistributionResult& result)
{
    const auto n = static_cast<double>(tiles.tiles().parameters.points_per_tile);
    const double disk = settings.dimension == 3 ? 4.0 / 3 * std::numbers::pi * std::pow(tiles.radius(), 3)
                                                : std::numbers::pi * std::pow(tiles.radius(), 2);
    if (settings.view == "plane") {
        double inside = 0;
        for (std::size_t i = 3; i < picture.pixels.size(); i += 4) inside += picture.pixels[i];
        const double samples = static_cast<double>(picture.ids.size()) * settings.samples * settings.samples;
        result.numbers.push_back(
            {"share_inside", "Share inside", inside / samples, "of the picture, in objects' disks"});
    }
    if (const auto power = mean_power_of_size(settings.size, settings.dimension))
        result.numbers.push_back({"expected_share", "Share of the whole", n * disk * *power,
                                  settings.dimension == 3 ? "4/3 π R³ of each point" : "π R² of each point"});
}

/// The shares of look-ups that visit 1, 2 and 4 tiles by the rule of D 7.6.2.1: a place nearer to a corner than the
/// largest empty circle's radius needs four, one nearer to an edge two. Points that leave their tiles are nearer by
/// that.
void add_visited_tiles(const ObjectTileSet& tiles, DistributionResult& result)
{
    const ptiles_set set = tiles.distribution({}).tiling.set;
    if (set.dimension == 3) return;
    const double radius = certify(tiles.tiles()).largest_empty_radius, out = std::max(set.below, set.above) / 65536.0;
    if (radius + out > 0.5) return;
    const double inner = 1 - 2 * (radius + out);
    const double one = inner * inner, four = std::numbers::pi * radius * radius + 8 * radius * out + 4 * out * out;
    result.numbers.push_back({"largest_empty_radius", "Largest empty circle", radius, "tiles, of any tiling"});
    result.numbers.push_back({"one_tile", "Look-ups in one tile", one, "no edge is in reach of this circle"});
    result.numbers.push_back({"two_tiles", "Look-ups in two tiles", 1 - one - four, "an edge is"});
    result.numbers.push_back({"four_tiles", "Look-ups in four tiles", four, "a corner is"});
}

/// Speeds of this machine: they differ from run to run, and are measured where the config asks for them.
void add_costs(const ObjectSettings& settings, const ObjectTileSet& tiles, DistributionResult& result)
{
    if (!settings.has_timing) return;
    add_visited_tiles(tiles, result);
    const LookupCosts costs = lookup_costs(tiles);
    result.numbers.push_back({"timed_dimension", "Dimension of look-ups", static_cast<double>(settings.dimension),
                              "of what follows, on the host, by one thread"});
    const std::size_t first_time = result.numbers.size();
    result.numbers.push_back({"lookups_anywhere", "Look-ups a second", costs.lookups_anywhere, "at random places"});
    result.numbers.push_back({"lookups_in_rows", "Look-ups a second", costs.lookups_in_rows, "in rows of pixels"});
    result.numbers.push_back({"noise_calls_anywhere", "Calls of Perlin's noise",
                              costs.noise_anywhere / costs.lookups_anywhere,
                              "in the time of a look-up, random places"});
    result.numbers.push_back({"noise_calls_in_rows", "Calls of Perlin's noise",
                              costs.noise_in_rows / costs.lookups_in_rows, "in the time of a look-up, rows of pixels"});
    for (std::size_t i = first_time; i < result.numbers.size(); ++i) result.numbers[i].is_time = true;
}

ObjectPicture painted_part(const ObjectTileSet& tiles, const PoissonTiling& tiling, const ObjectScene& scene,
                           const DistributionPlace& place)
{
    if (place.engine == Engine::reference) return reference::draw_objects(tiles, tiling, scene, object_shapes());
    Device& device = place.device();
    check_fits("the picture of objects",
               ObjectPainter::memory(tiles, object_shapes(), std::size_t{scene.width} * scene.height), device.info());
    return ObjectPainter(device, tiles, object_shapes()).draw(tiling, scene);
}

/// The picture; of a table its cloth and its floor, each of which leaves white what the other shows.
ObjectPicture painted(const ObjectSettings& settings, const ObjectTileSet& tiles, const PoissonTiling& tiling,
                      const DistributionPlace& place)
{
    ObjectPicture picture = painted_part(tiles, tiling, scene_of(settings, tiles), place);
    if (settings.view != "table") return picture;
    ObjectSettings floor = settings;
    floor.object = "granite";
    floor.objects = 4 * settings.objects;
    floor.size = {SpreadChoice::Kind::uniform, 0.7, 1};
    floor.orientation = {SpreadChoice::Kind::uniform, 0, 2 * std::numbers::pi};
    floor.aspect = {SpreadChoice::Kind::uniform, 0.7, 1.4};
    ObjectScene scene = scene_of(floor, tiles);
    scene.view = VIEW_FLOOR;
    const ObjectPicture under = painted_part(tiles, tiling, scene, place);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        picture.pixels[i] = static_cast<std::uint8_t>(std::clamp(picture.pixels[i] + under.pixels[i] - 255, 0, 255));
    return picture;
}

DistributionResult make_objects(const ObjectSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                                DistributionFiles& files)
{
    const ObjectTileSet tiles(object_tile_set(settings.tiles, settings.dimension, place));
    const PoissonTileParameters& p = tiles.tiles().parameters;
    const PoissonTiling tiling{stream_key(seed, Purpose::tile_choice, 0)[0], settings.period};
    const ObjectPicture picture = painted(settings, tiles, tiling, place);

    DistributionResult result;
    result.facts = {fmt::format("{} objects a unit {}", settings.objects, settings.dimension == 3 ? "cube" : "square"),
                    fmt::format("{} units wide", settings.window), fmt::format("{} points per tile", p.points_per_tile),
                    fmt::format("relative radius {:.3f}", relative_radius_of(tiles.tiles().squared_min_distance, p))};
    std::vector<std::uint8_t> colors;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        if (i % 4 != 3) colors.push_back(picture.pixels[i]);
    write_png(files.add("objects.png"), {static_cast<int>(settings.pixels), static_cast<int>(settings.pixels), 3},
              [&](int first, int) { return &colors[static_cast<std::size_t>(first) * settings.pixels * 3]; });
    result.pictures.push_back(
        {"objects.png", fmt::format("Each pixel is the mean of {0} x {0} places.", settings.samples)});
    add_numbers(settings, tiles, picture, result);
    add_costs(settings, tiles, result);
    return result;
}

}

Kind object_kind()
{
    return make_kind<ObjectSettings>(
        {"distribution", "objects", "", "Objects", "The procedural object distribution function, as a picture"},
        object_keys, object_label, make_objects);
}

}
