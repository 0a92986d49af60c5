// poissonlab distribute warp: even points through the inverse cumulative distribution of a picture or a formula.
#include "app/commands/kind_options.hpp"
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "host/distribution/distribution_run.hpp"
#include "host/distribution/place_file.hpp"
#include "host/distribution/runs/run_numbers.hpp"
#include "host/distribution/sky_lights.hpp"
#include "host/kinds/kinds.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
namespace {

constexpr auto distribute_warp_notes =
    R"help(Even points, of a tiling or of any method, are moved such that their density follows a picture or a formula: rows of
pixels by y, pixels of a row by x, in exact integers. Coordinates are in units of the longest side, y upwards.
Formulas are over a square; "gauss-and-waves" is that of the dissertation's figure 4.44. Methods other than tiles make
their points for a square, and those in the picture's proportions are taken.
With --environment the picture is an environment map, twice as wide as high, or the formula one of longitude x, -1 at
the left border to 1, and latitude y, -1/2 to 1/2: densities are luminance times solid angle.
--lights writes the lights at the points, `x y z` of the direction (z up), then the power of each colour: all have the
same luminance, together that of the map. --seen-from says which way round a map goes:
  inside       from the middle of the sphere, as photographs are, and as Blender takes them: columns to the right turn
               clockwise seen from +z; the middle column is +x, a quarter to the left of it +y
  outside      as a globe, and as pbrt-v3 takes them: columns to the right turn counterclockwise seen from +z; the left
               border is +x, a quarter to the right of it +y
Pixels that a file's rounding left below 0 (lossy DWA in .exr) are taken as 0, and a note says how many: down to a tenth
of the mean below it, all together at most a thousandth of the light. Pictures with more below 0 are refused.
  poissonlab distribute warp --density photo.jpg --density-from ink --points 13000 --out dots.ply
  poissonlab distribute warp --density gauss-and-waves --points 2048 --out blob.npy
  poissonlab distribute warp --density sky.exr --environment --points 288 --lights lights.csv --out places.txt)help";

struct WarpOptions : KindOptions
{
    using KindOptions::KindOptions;
    std::filesystem::path lights;
};

void warp(const WarpOptions& o)
{
    const auto settings = o.read<WarpSettings>();
    if (!settings.is_environment && !o.lights.empty()) throw InputError("--lights: needs --environment");
    std::filesystem::path lights;
    if (!o.lights.empty()) lights = checked_output(o.command(), "--lights", o.lights, {{".csv", ".txt"}, false, true});
    std::optional<LinearPicture> map;
    if (settings.is_environment) map = sky_map(settings.density.text);
    const Density density = map ? sky_density(*map, settings.density.text) : chosen_density(settings.density);
    o.say_note(density.note);
    const SquarePoints points = even_points(chosen_method(settings.method), settings.points, density.width,
                                            density.height, o.seed(), o.place(), map ? Seam::closed : Seam::open);
    const PixelPlaces places = warp_points(density, points, o.place());
    if (!lights.empty()) write_whole_file(lights, lights_text(sky_lights(*map, places, settings.seen_from)));
    for (const std::filesystem::path& out : o.outs.files())
        write_places(
            out, places, static_cast<std::uint32_t>(std::max(density.width, density.height)),
            o.command_comment(fmt::format("{} points in units of the longest side of {} x {} pixels, y upwards",
                                          places.size() / 2, density.width, density.height)));
    if (o.prints_json()) print_numbers(warp_numbers(map, density, places, points));
}

}

Command distribute_warp_command()
{
    const auto o = std::make_shared<WarpOptions>(*find_kind("distribution", "warp"), OutputFiles{point_formats()});
    return kind_command(
        o, {o->outs.option(), {"--lights", &o->lights, "With --environment: lights, directions and powers", "FILE"}},
        distribute_warp_notes, warp);
}

}
