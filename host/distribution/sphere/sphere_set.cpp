#include "host/distribution/sphere/sphere_set.hpp"

#include "analysis/sphere/sphere_measures.hpp"
#include "base/errors/errors.hpp"
#include "base/random/random.hpp"
#include "host/distribution/sky_lights.hpp"

#include <boost/math/special_functions/gamma.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace poissonlab {
namespace {

constexpr double sphere_area = 4 * std::numbers::pi;

/// Triangles along each edge of an octahedron: darts on them are off the sphere by less than a thousandth.
constexpr std::uint32_t octahedron_parts = 48;

/// Legendre functions of higher degrees take long.
constexpr std::uint32_t highest_degree = 512;

/// A uniform number between 0 and 1 of two words.
double uniform_of(std::uint32_t high, std::uint32_t low)
{
    return (static_cast<double>((std::uint64_t{high} << 21) | (low >> 11)) + 0.5) / 9007199254740992.0;
}

/// An octahedron whose faces are divided, on the sphere.
SurfaceMesh triangled_sphere()
{
    TriangleMesh mesh;
    const auto corner = [&](std::array<double, 3> v) {
        const double length = std::hypot(v[0], v[1], v[2]);
        for (double& c : v) c /= length;
        mesh.vertices.push_back(v);
    };
    for (int octant = 0; octant < 8; ++octant) {
        const std::array<double, 3> signs{octant & 1 ? -1.0 : 1.0, octant & 2 ? -1.0 : 1.0, octant & 4 ? -1.0 : 1.0};
        const bool is_mirrored = signs[0] * signs[1] * signs[2] < 0;
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        constexpr std::uint32_t n = octahedron_parts;
        for (std::uint32_t y = 0; y <= n; ++y)
            for (std::uint32_t x = 0; x <= n - y; ++x) corner({signs[0] * x, signs[1] * y, signs[2] * (n - x - y)});
        const auto number = [&](std::uint32_t x, std::uint32_t y) { return first + y * (n + 1) - y * (y - 1) / 2 + x; };
        const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            mesh.triangles.push_back(is_mirrored ? MeshTriangle{a, c, b} : MeshTriangle{a, b, c});
        };
        for (std::uint32_t y = 0; y < n; ++y)
            for (std::uint32_t x = 0; x < n - y; ++x) {
                add(number(x, y), number(x + 1, y), number(x, y + 1));
                if (x + y + 1 < n) add(number(x + 1, y), number(x + 1, y + 1), number(x, y + 1));
            }
    }
    mesh.faces.resize(mesh.triangles.size());
    std::iota(mesh.faces.begin(), mesh.faces.end(), 0U);
    FixedSurface surface = fixed_surface(mesh);
    return {std::move(mesh), std::move(surface)};
}

std::vector<UnitVector> dart_directions(std::size_t points, std::uint64_t seed)
{
    const auto mesh = std::make_shared<const SurfaceMesh>(triangled_sphere());
    const PointSet places = points_of(mesh->surface, points_by_method("darts", points, mesh, {}, seed));
    std::vector<UnitVector> directions;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto place = places[i];
        const double length = std::sqrt(place[0] * place[0] + place[1] * place[1] + place[2] * place[2]);
        directions.push_back({place[0] / length, place[1] / length, place[2] / length});
    }
    return directions;
}

std::vector<UnitVector> directions_of(const std::vector<SpherePlace>& places)
{
    std::vector<UnitVector> directions;
    for (const SpherePlace& place : places) directions.push_back(direction_of(place));
    return directions;
}

/// A set's measures, its curve and its discrepancy.
struct MeasuredSet
{
    MeshSetMeasures measures;
    std::vector<RadialBin> curve;
    double cap_discrepancy = 0;
};

MeasuredSet measured(const std::vector<UnitVector>& points, std::uint32_t degrees)
{
    const std::vector<double> powers = harmonic_powers(points, degrees), eigenvalues = harmonic_eigenvalues(degrees);
    const auto rings = [&](double width) {
        return eigenfunction_rings(eigenvalues, powers, sphere_area, eigenvalues.back(), width);
    };
    MeasuredSet set;
    set.measures.rings = rings(1);
    set.curve = rings(curve_width(points.size()));
    const SpherePairs pairs = sphere_pairs(points);
    set.measures.least = pairs.least;
    set.measures.mean_nearest = pairs.mean_nearest;
    std::vector<std::array<double, 2>> places;
    for (const UnitVector& v : points)
        places.push_back({place_of_direction(v).turns, std::clamp((v[2] + 1) / 2, 0.0, 1.0)});
    set.measures.counts = counts_in_square(places);
    complete_measures(set.measures, points.size(), sphere_area,
                      frequency_of(eigenvalues.back()) * std::sqrt(sphere_area / static_cast<double>(points.size())));
    set.cap_discrepancy = pairs.cap_discrepancy;
    return set;
}

}

SphereLight::SphereLight(const std::string& text, SeenFrom seen_from)
    : seen_from_(seen_from), density_(sky_density(sky_map(text), text))
{
    below_.push_back(0);
    const auto rows = static_cast<std::size_t>(density_.height), columns = static_cast<std::size_t>(density_.width);
    for (std::size_t row = 0; row <= rows; ++row)
        borders_.push_back(border_cosine(density_.height - static_cast<int>(row), density_.height));
    for (std::size_t row = 0; row < rows; ++row) {
        double sum = 0;
        for (std::size_t column = 0; column < columns; ++column) sum += static_cast<double>(weight(row, column));
        below_.push_back(below_.back() + sum);
    }
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = 0; column < columns; ++column)
            most_ = std::max(most_, static_cast<double>(weight(row, column)) / (borders_[row + 1] - borders_[row]));
    most_ *= 2 * static_cast<double>(columns) / below_.back();
}

SphereLight::PixelPlace SphereLight::pixel_place(const SpherePlace& place) const
{
    const auto above = std::ranges::upper_bound(borders_, place.z) - borders_.begin();
    PixelPlace pixel;
    pixel.row = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above - 1, 0, density_.height - 1));
    pixel.height =
        std::clamp((place.z - borders_[pixel.row]) / (borders_[pixel.row + 1] - borders_[pixel.row]), 0.0, 1.0);
    double turns = place.turns;
    if (seen_from_ == SeenFrom::inside) turns = turns > 0.5 ? 1.5 - turns : 0.5 - turns;
    pixel.column = std::min(turns * density_.width, std::nextafter(static_cast<double>(density_.width), 0.0));
    return pixel;
}

double SphereLight::at(const SpherePlace& place) const
{
    const PixelPlace pixel = pixel_place(place);
    return static_cast<double>(weight(pixel.row, static_cast<std::size_t>(pixel.column))) /
           (borders_[pixel.row + 1] - borders_[pixel.row]) * 2 * density_.width / below_.back();
}

std::array<double, 2> SphereLight::evened(const SpherePlace& place) const
{
    const PixelPlace pixel = pixel_place(place);
    const auto column = static_cast<std::size_t>(pixel.column);
    const double in_row = below_[pixel.row + 1] - below_[pixel.row];
    double left = 0;
    for (std::size_t c = 0; c < column; ++c) left += static_cast<double>(weight(pixel.row, c));
    left += static_cast<double>(weight(pixel.row, column)) * (pixel.column - static_cast<double>(column));
    return {in_row > 0 ? std::min(1.0, left / in_row) : 0.5,
            (below_[pixel.row] + in_row * pixel.height) / below_.back()};
}

double sphere_values(const SphereSettings& settings)
{
    const auto points = static_cast<double>(settings.points);
    return settings.light ? std::ceil(points * settings.light->most()) : points;
}

std::vector<SpherePlace> random_sphere_points(std::size_t points, std::uint64_t seed)
{
    const StreamKey key = stream_key(seed, Purpose::surface_candidates, 2);
    std::vector<SpherePlace> set;
    for (std::size_t i = 0; i < points; ++i) {
        const auto words = philox({static_cast<std::uint32_t>(i), 0, 0, 0}, key);
        const double z = 2 * uniform_of(words[0], words[1]) - 1;
        set.push_back({z, std::sqrt((1 - z) * (1 + z)), uniform_of(words[2], words[3])});
    }
    return set;
}

std::vector<SpherePlace> fibonacci_sphere_points(std::size_t points)
{
    std::vector<SpherePlace> set;
    for (std::size_t i = 0; i < points; ++i) {
        const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(points);
        const double turns = static_cast<double>(i) / std::numbers::phi;
        set.push_back({z, std::sqrt((1 - z) * (1 + z)), turns - std::floor(turns)});
    }
    return set;
}

CountsOverParts counts_in_square(const std::vector<std::array<double, 2>>& places)
{
    const auto rows =
        static_cast<std::size_t>(std::min(16.0, std::floor(std::sqrt(static_cast<double>(places.size()) / 20))));
    CountsOverParts counts;
    if (rows == 0) return counts;
    std::vector<double> cells(2 * rows * rows);
    const auto cell = [](double part, std::size_t parts) {
        return std::min(parts - 1, static_cast<std::size_t>(part * static_cast<double>(parts)));
    };
    for (const auto& [x, y] : places) ++cells[cell(y, rows) * 2 * rows + cell(x, 2 * rows)];
    counts.parts = cells.size();
    const double expected = static_cast<double>(places.size()) / static_cast<double>(cells.size());
    for (const double count : cells) counts.chi_square += (count - expected) * (count - expected) / expected;
    counts.p_value = boost::math::gamma_q(0.5 * static_cast<double>(counts.parts - 1), 0.5 * counts.chi_square);
    return counts;
}

SphereSpectra measure_sphere(const std::vector<SpherePlace>& points, std::uint64_t seed,
                             const std::function<void(const std::string& what)>& on_step)
{
    const auto say = [&](const char* what) {
        if (on_step) on_step(what);
    };
    const auto count = static_cast<double>(points.size());
    // The frequency of a degree is nearly l / 2 pi.
    const auto degrees = std::clamp<std::uint32_t>(
        static_cast<std::uint32_t>(farthest_spectrum * std::sqrt(count * std::numbers::pi)), 2, highest_degree);
    say("spectrum of the points on the sphere");
    MeasuredSet set = measured(directions_of(points), degrees);
    say("spectra of the lattice and of random points");
    MeasuredSet lattice = measured(directions_of(fibonacci_sphere_points(points.size())), degrees);
    MeasuredSet random = measured(directions_of(random_sphere_points(points.size(), seed)), degrees);
    say("dart throwing on the sphere, to compare with");
    MeasuredSet darts = measured(dart_directions(points.size(), seed), degrees);
    SphereSpectra spectra;
    spectra.of.area = sphere_area;
    spectra.of.reach = frequency_of(static_cast<double>(degrees) * (degrees + 1.0)) * std::sqrt(sphere_area / count);
    spectra.of.eigenfunctions = (degrees + 1) * (degrees + 1) - 1;
    spectra.of.set = std::move(set.measures);
    spectra.of.random = std::move(random.measures);
    spectra.of.darts = std::move(darts.measures);
    spectra.of.set_curve = std::move(set.curve);
    spectra.of.random_curve = std::move(random.curve);
    spectra.of.darts_curve = std::move(darts.curve);
    spectra.of.methods.push_back({"Fibonacci lattice", std::move(lattice.measures), std::move(lattice.curve)});
    spectra.cap_discrepancies = {set.cap_discrepancy, lattice.cap_discrepancy, random.cap_discrepancy,
                                 darts.cap_discrepancy};
    return spectra;
}

}
