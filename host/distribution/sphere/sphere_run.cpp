// kind = "sphere": points on the sphere, even or following an environment map, by polyominoes over HEALPix.
//
// Class notes of SIGGRAPH 2008, part IV (Ostromoukhov); see tiles/sphere/polyomino_sphere.hpp.
#include "base/files/whole_file.hpp"
#include "base/points/point_file.hpp"
#include "base/programs/cache_folder.hpp"
#include "base/text/noun.hpp"
#include "host/distribution/sphere/sphere_set.hpp"
#include "host/distribution/surface_spectra/mesh_set_charts.hpp"
#include "host/kinds/kinds.hpp"
#include "host/schemes/sphere_pictures.hpp"
#include "host/tile_sampling/polyominoes/polyomino_sampler.hpp"
#include "results/curve_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

constexpr double degrees = 180 / std::numbers::pi;

/// Pictures have the first points, which are even as well.
constexpr std::size_t most_dots = 20'000;

/// Points that the whole sphere may have with the density of the densest place.
constexpr std::int64_t most_sphere_values = 1 << 24;

void sphere_keys(Keys& keys, SphereSettings& s)
{
    keys.integer("points", s.points, 1, most_sphere_values,
                 "the number of points: exactly so many where they are even, about so many of an environment")
        .required();
    keys.word("variant", s.variant, polyominoes,
              "the polyomino: a pentomino that is divided into 4, or a hexomino that is divided into 81");
    keys.picture_or_formula("environment", s.environment, s.environment_from,
                            "an environment map whose light the points follow: a picture twice as wide as high, or a "
                            "formula in the longitude x, from -1 to 1, and the latitude y, from -1/2 to 1/2")
        .otherwise("none: the points are even");
    keys.word("seen_from", s.seen_from, seen_from_names, "which way round the environment map goes");
    if (keys.is_given("seen_from") && s.environment.empty())
        throw keys.invalid("seen_from", "needs " + keys.name_of("environment"));
    if (keys.is_given("environment_from") && s.environment_from != "light")
        throw keys.invalid("environment_from", "must be \"light\"");
    if (!keys.is_read()) return;
    if (!s.environment.empty())
        keys.check("environment", [&] { s.light = std::make_shared<const SphereLight>(s.environment, s.seen_from); });
    if (const double values = sphere_values(s); values > static_cast<double>(most_sphere_values))
        throw keys.invalid("points",
                           fmt::format("would be {:.0f} over the whole sphere with the density of the densest "
                                       "place: must be at most {:.0f}",
                                       values, static_cast<double>(most_sphere_values)));
}

std::string sphere_label(const SphereSettings& s)
{
    return s.environment.empty() ? fmt::format("{} {} on the sphere", s.points, noun(s.points, "point"))
                                 : fmt::format("Points on the sphere by {}", name_of_input(s.environment));
}

/// Pale colours of squares, and the tiles before divisions; or the light, as bright as it is seen.
GroundPlace ground_at(const SpherePlace& place, const PolyominoSphere& sphere, const SphereLight* light)
{
    if (light) {
        const auto grey = static_cast<std::uint8_t>(255 * std::sqrt(std::min(1.0, light->at(place) / light->most())));
        return {{grey, grey, grey}, 0};
    }
    constexpr std::array<std::array<std::uint8_t, 3>, 3> colors{{{222, 235, 247}, {229, 245, 224}, {254, 237, 222}}};
    const HealpixPlace at = healpix_place(place);
    const auto parts = static_cast<std::uint32_t>(sphere.first_tiles().size() / sphere.counts().roots);
    return {colors.at((at.square / 4 + at.square % 2) % 3), sphere.first_tile_at(at) / parts};
}

void add_pictures(const std::vector<SpherePlace>& points, const PolyominoSphere& sphere, const SphereLight* light,
                  DistributionFiles& files, DistributionResult& result)
{
    const std::vector<SpherePlace> shown(
        points.begin(), points.begin() + static_cast<std::ptrdiff_t>(std::min(points.size(), most_dots)));
    const double radius =
        (light ? 0.5 : 1) * std::min(0.02, 0.7 / std::sqrt(std::max<double>(1, static_cast<double>(shown.size()))));
    const std::string of =
        light ? "the light" : "the squares of HEALPix and the first tiles, which go on across borders";
    const std::string first =
        shown.size() < points.size() ? fmt::format("The first {} points", most_dots) : "The points";
    const auto add = [&](SphereProjection projection, const std::string& name, const std::string& way) {
        write_png(files.add(name + ".png"),
                  sphere_ground(projection, [&](const SpherePlace& place) { return ground_at(place, sphere, light); }));
        files.add_marks(name + ".json",
                        sphere_dots(projection, shown, radius, light ? "#e02020" : "#101820", name + ".png"),
                        fmt::format("{} over {}, {}.", first, of, way), result);
    };
    add(SphereProjection::globe, "globe",
        "seen from outside: left from the front above, right from the other side below");
    add(SphereProjection::mollweide, "map", "in Mollweide's projection of equal areas, longitude 0 in the middle");
}

void add_even_measures(const std::vector<SpherePlace>& points, const PolyominoSphere& sphere, std::uint64_t seed,
                       const DistributionPlace& place, DistributionFiles& files, DistributionResult& result)
{
    const std::size_t count = points.size();
    const SphereSpectra spectra = measure_sphere(points, seed, place.on_step);
    const MeshSetMeasures& set = spectra.of.set;
    result.facts.insert(result.facts.begin(), set.verdict.words());
    result.numbers = {{"least_angle", "Least angle", set.least * degrees, "of two points, in degrees"},
                      {"proven_angle", "Proven angle",
                       proven_distance(sphere, count) * least_healpix_stretch() * degrees,
                       "in degrees: points are no nearer, but around the eight vertices where three squares meet"}};
    const auto add = [&](const char* key, const char* title, const std::optional<double>& value) {
        if (value && std::isfinite(*value)) result.numbers.push_back({key, title, *value, "", {}, true});
    };
    add("relative_radius", "Relative radius", set.relative_radius);
    add("mean_nearest_distance", "Mean nearest distance, relative", set.nearest_ratio);
    add("low_frequency_mean", "Mean power at low frequencies", set.low_frequency_mean);
    add("effective_nyquist", "Effective Nyquist frequency", set.effective_nyquist);
    add("anisotropy_above_chance", "Peaks above chance", set.above_chance);
    if (set.counts.parts > 0) add("counts_p_value", "Evenness of counts", set.counts.p_value);
    add("cap_discrepancy", "Cap discrepancy", spectra.cap_discrepancies.front());
    DistributionTable table = comparison_of(spectra.of, "polyominoes", "on the sphere");
    std::vector<std::string> row{"Mean square discrepancy of spherical caps: random points have 1"};
    for (const double value : spectra.cap_discrepancies) row.push_back(fmt::format("{:.3g}", value));
    table.rows.push_back(std::move(row));
    result.tables = {std::move(table)};
    files.add_curves("power",
                     spectrum_chart(spectra.of, "polyominoes", count, {"power", 0, 4, 0.5}, 1, &RadialBin::power),
                     "Angular power spectrum: the mean power of spherical harmonics of the degree l, at the frequency "
                     "l / 2π. Random "
                     "points have 1, and blue noise has little on the left.",
                     result);
    write_whole_file(files.add("radial.csv", result), radial_csv(set.rings));
}

/// Counts over cells that have equal light say how well the points follow it.
void add_light_measures(const std::vector<SpherePlace>& points, const SphereLight& light, DistributionResult& result)
{
    std::vector<std::array<double, 2>> places;
    for (const SpherePlace& point : points) places.push_back(light.evened(point));
    const CountsOverParts counts = counts_in_square(places);
    if (counts.parts == 0) return;
    result.numbers = {
        {"light_cells", "Cells of equal light", static_cast<double>(counts.parts), "in which points are counted"},
        {"counts_dispersion", "Dispersion of counts", counts.chi_square / (static_cast<double>(counts.parts) - 1),
         "variance over mean of the counts: 1 on average for random points that follow the light, less for even ones"},
        {"counts_p_value", "Evenness of counts", counts.p_value,
         "the probability that counts of random points vary as much"}};
}

DistributionResult make_sphere(const SphereSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                               DistributionFiles& files)
{
    const PolyominoTable table = cached_polyomino_table(settings.variant, cache_folder(), place.on_step).built;
    const PolyominoSphere sphere(table, seed, 0);
    const SphereLight* light = settings.light.get();
    const auto wanted = [&](const SpherePlace& at) { return static_cast<double>(settings.points) * light->at(at); };
    const std::vector<SpherePlace> points =
        light ? polyomino_points(sphere, static_cast<std::uint64_t>(sphere_values(settings)), wanted)
              : polyomino_points(sphere, settings.points);
    DistributionResult result;
    result.facts = {
        fmt::format("{} {}", points.size(), noun(points.size(), "point")),
        fmt::format("{} polyominoes before divisions, over the 12 squares of HEALPix", sphere.counts().roots)};
    if (light) {
        result.facts.push_back("seen from " + std::string(seen_from_names[settings.seen_from]));
        if (!light->note().empty()) result.facts.push_back(light->note());
        add_light_measures(points, *light, result);
    } else if (points.size() > most_measured_points) {
        result.facts.push_back(fmt::format("Sets of more than {} points are not measured", most_measured_points));
    } else if (points.size() > 1) {
        add_even_measures(points, sphere, seed, place, files, result);
    }
    add_pictures(points, sphere, light, files, result);
    PointSet directions{3, {}};
    for (const SpherePlace& point : points)
        for (const double c : direction_of(point)) directions.coordinates.push_back(c);
    for (const char* name : {"points.csv", "points.ply", "points.npy"})
        write_points(files.add(name, result), directions);
    return result;
}

}

Kind sphere_kind()
{
    return make_kind<SphereSettings>({"distribution", "sphere", "", "Points on the sphere",
                                      "Make points on the unit sphere by polyominoes, even or following an environment "
                                      "map",
                                      false},
                                     sphere_keys, sphere_label, make_sphere);
}

}
