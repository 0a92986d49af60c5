#include "host/distribution/sphere/sphere_pictures.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace poissonlab {
namespace {

constexpr int picture_height = 800, picture_width = 1600;
constexpr double globe_radius = 385, map_radius = 277; ///< of the unit sphere, in pixels

// The globe is seen from this longitude and latitude, and from the other side.
const double view_turn = std::numbers::pi / 6, view_height = std::numbers::pi / 7;

/// Axes to the right, up, and towards the viewer, of the left globe; the other one has the first and last reversed.
std::array<UnitVector, 3> view_axes()
{
    const double c = std::cos(view_turn), s = std::sin(view_turn), ch = std::cos(view_height),
                 sh = std::sin(view_height);
    return {{{-s, c, 0}, {-sh * c, -sh * s, ch}, {ch * c, ch * s, sh}}};
}

/// The direction at a place of the picture, in pixels from its lower left corner; none outside of the sphere.
std::optional<SpherePlace> globe_place(double x, double y)
{
    const bool is_left = x < picture_width / 2.0;
    const double u = (x - (is_left ? 0.25 : 0.75) * picture_width) / globe_radius,
                 v = (y - picture_height / 2.0) / globe_radius, squared = u * u + v * v;
    if (squared >= 1) return std::nullopt;
    const auto axes = view_axes();
    const double side = is_left ? 1 : -1, back = std::sqrt(1 - squared);
    UnitVector direction{};
    for (std::size_t k = 0; k < 3; ++k)
        direction[k] = side * u * axes[0][k] + v * axes[1][k] + side * back * axes[2][k];
    return place_of_direction(direction);
}

std::optional<SpherePlace> map_place(double x, double y)
{
    const double u = (x - picture_width / 2.0) / map_radius, v = (y - picture_height / 2.0) / map_radius;
    const double sine = v / std::numbers::sqrt2;
    if (std::abs(sine) >= 1) return std::nullopt;
    const double cosine = std::sqrt(1 - sine * sine), angle = std::asin(sine);
    const double turns = u / (4 * std::numbers::sqrt2 * cosine);
    if (std::abs(turns) >= 0.5) return std::nullopt;
    const double z = std::clamp((2 * angle + 2 * sine * cosine) / std::numbers::pi, -1.0, 1.0);
    return SpherePlace{z, std::sqrt((1 - z) * (1 + z)), turns < 0 ? turns + 1 : turns};
}

std::array<double, 2> on_globe(const UnitVector& direction)
{
    const auto axes = view_axes();
    const auto along = [&](std::size_t axis) {
        return direction[0] * axes[axis][0] + direction[1] * axes[axis][1] + direction[2] * axes[axis][2];
    };
    const double side = along(2) >= 0 ? 1 : -1;
    // On the other side up is what it was: the third axis is turned about the upright of the picture.
    return {picture_width * (side > 0 ? 0.25 : 0.75) + side * along(0) * globe_radius,
            picture_height / 2.0 + along(1) * globe_radius};
}

std::array<double, 2> on_map(const SpherePlace& place)
{
    // The angle a with 2 a + sin 2 a = pi z, by bisection.
    double low = -std::numbers::pi / 2, high = std::numbers::pi / 2;
    for (int i = 0; i < 50; ++i) {
        const double middle = (low + high) / 2;
        (2 * middle + std::sin(2 * middle) < std::numbers::pi * place.z ? low : high) = middle;
    }
    const double turns = place.turns > 0.5 ? place.turns - 1 : place.turns;
    return {picture_width / 2.0 + 4 * std::numbers::sqrt2 * turns * std::cos(low) * map_radius,
            picture_height / 2.0 + std::numbers::sqrt2 * std::sin(low) * map_radius};
}

}

PngPixels sphere_ground(SphereProjection projection, const std::function<GroundPlace(const SpherePlace& place)>& ground)
{
    constexpr int samples = 2; // of a pixel, along each axis
    PngPixels picture{picture_width, picture_height, 3, {}};
    picture.values.assign(std::size_t{3} * picture_width * picture_height, 255);
    const auto sample = [&](int column, int row) -> std::optional<GroundPlace> {
        const double x = (column + 0.5) / samples, y = picture_height - (row + 0.5) / samples;
        const auto place = projection == SphereProjection::globe ? globe_place(x, y) : map_place(x, y);
        return place ? std::optional(ground(*place)) : std::nullopt;
    };
    tbb::parallel_for(0, picture_height, [&](int row) {
        for (int column = 0; column < picture_width; ++column) {
            std::array<int, 3> sums{};
            for (int i = 0; i < samples * samples; ++i) {
                const int x = samples * column + i % samples, y = samples * row + i / samples;
                const auto here = sample(x, y), right = sample(x + 1, y), below = sample(x, y + 1);
                const bool is_line =
                    here && ((right && right->part != here->part) || (below && below->part != here->part));
                for (std::size_t k = 0; k < 3; ++k)
                    sums[k] += !here ? 255 : is_line ? here->color[k] / 2 : here->color[k];
            }
            for (int k = 0; k < 3; ++k)
                picture.values[picture.at(column, row, k)] =
                    static_cast<std::uint8_t>(sums[static_cast<std::size_t>(k)] / (samples * samples));
        }
    });
    return picture;
}

MarkPicture sphere_dots(SphereProjection projection, const std::vector<SpherePlace>& points, double radius,
                        const std::string& color, const std::string& ground)
{
    MarkPicture picture{picture_width, picture_height, picture_width, ground};
    MarkGroup dots{color};
    for (const SpherePlace& place : points) {
        const bool is_globe = projection == SphereProjection::globe;
        const auto [x, y] = is_globe ? on_globe(direction_of(place)) : on_map(place);
        dots.disks.push_back({x, y, std::max(0.7, radius * (is_globe ? globe_radius : map_radius))});
    }
    picture.groups.push_back(std::move(dots));
    return picture;
}

}
