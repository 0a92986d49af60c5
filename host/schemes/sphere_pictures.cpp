#include "host/schemes/sphere_pictures.hpp"

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

/// Finds what is seen at a place of the globes' picture, in pixels from its lower left corner: to the right, up and
/// towards the viewer on the unit sphere. There is nothing outside of it.
std::optional<UnitVector> seen_on_globe(double x, double y)
{
    const double u = (x - (x < picture_width / 2.0 ? 0.25 : 0.75) * picture_width) / globe_radius,
                 v = (y - picture_height / 2.0) / globe_radius, squared = u * u + v * v;
    if (squared >= 1) return std::nullopt;
    return UnitVector{u, v, std::sqrt(1 - squared)};
}

std::optional<SpherePlace> globe_place(double x, double y)
{
    const auto seen = seen_on_globe(x, y);
    if (!seen) return std::nullopt;
    const auto axes = view_axes();
    const double side = x < picture_width / 2.0 ? 1 : -1;
    UnitVector direction{};
    for (std::size_t k = 0; k < 3; ++k)
        direction[k] = side * (*seen)[0] * axes[0][k] + (*seen)[1] * axes[1][k] + side * (*seen)[2] * axes[2][k];
    return place_of_direction(direction);
}

/// The part of its colour that a place of the globes has in light from the upper left.
double light_on_globe(double x, double y)
{
    constexpr UnitVector light{-0.48, 0.6, 0.64};
    const auto seen = seen_on_globe(x, y);
    return seen ? 0.35 + 0.7 * std::max(0.0, (*seen)[0] * light[0] + (*seen)[1] * light[1] + (*seen)[2] * light[2]) : 1;
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

std::optional<SpherePlace> place_at(SphereProjection projection, double x, double y)
{
    if (projection == SphereProjection::globe) return globe_place(x, y);
    if (projection == SphereProjection::mollweide) return map_place(x, y);
    const double turns = x / picture_width - 0.5, latitude = (y / picture_height - 0.5) * std::numbers::pi;
    return SpherePlace{std::sin(latitude), std::cos(latitude), turns < 0 ? turns + 1 : turns};
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

PngPixels sphere_ground(SphereProjection projection, const std::function<GroundPlace(const SpherePlace& place)>& ground,
                        bool is_lit)
{
    constexpr int samples = 2; // of a pixel, along each axis
    const bool is_lit_globe = is_lit && projection == SphereProjection::globe;
    PngPixels picture{picture_width, picture_height, 3, {}};
    picture.values.assign(std::size_t{3} * picture_width * picture_height, 255);
    const auto row_of_samples = [&](int row) {
        std::vector<std::optional<GroundPlace>> all;
        const double y = picture_height - (row + 0.5) / samples;
        for (int column = 0; column <= samples * picture_width; ++column) {
            const auto place = place_at(projection, (column + 0.5) / samples, y);
            all.push_back(place ? std::optional(ground(*place)) : std::nullopt);
        }
        return all;
    };
    tbb::parallel_for(0, picture_height, [&](int row) {
        std::array<std::vector<std::optional<GroundPlace>>, samples + 1> rows;
        for (int i = 0; i <= samples; ++i) rows[static_cast<std::size_t>(i)] = row_of_samples(samples * row + i);
        for (int column = 0; column < picture_width; ++column) {
            std::array<double, 3> sums{};
            for (int i = 0; i < samples * samples; ++i) {
                const auto x = static_cast<std::size_t>(samples * column + i % samples),
                           y = static_cast<std::size_t>(i / samples);
                const auto &here = rows[y][x], &right = rows[y][x + 1], &below = rows[y + 1][x];
                const bool is_line =
                    here && ((right && right->part != here->part) || (below && below->part != here->part));
                const double light = is_lit_globe ? light_on_globe((static_cast<double>(x) + 0.5) / samples,
                                                                   picture_height - row - (i / samples + 0.5) / samples)
                                                  : 1;
                for (std::size_t k = 0; k < 3; ++k) {
                    const int color = !here ? 255 : is_line ? here->color[k] / (is_lit ? 5 : 2) : here->color[k];
                    sums[k] += std::min(255.0, light * color);
                }
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
