#include "host/distribution/object_shapes.hpp"

#include "base/random/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

namespace poissonlab {
namespace {

using namespace contract::objects;
using std::numbers::pi;

/// The places of shapes in the table.
enum ShapeNumber : std::uint32_t
{
    disk_shape,
    star_shape,
    flower_shape,
    heart_shape,
    daisy_shape,
    abstract_square_shape,
    rounded_square_shape, ///< beside the next one: section 7.6.2.3's Mondriaan shapes are both
    rounded_triangle_shape,
    starfish_shape,
    starfish_inner_shape,
    hexagon_shapes, ///< the first of them
};
constexpr std::uint32_t hexagons = 16;

/// The distance from the middle to the border of a star of five points, an ordinary pentagram.
double star_radius(double angle)
{
    const double fifth = 2 * pi / 5;
    const double from_point = std::abs(std::remainder(angle - pi / 2, fifth));
    // The edge leads from the point at distance 1 to the notch at this distance, half a fifth farther.
    const double notch = 0.381966;
    const double x = std::cos(fifth / 2) * notch, y = std::sin(fifth / 2) * notch;
    return y / (y * std::cos(from_point) + (1 - x) * std::sin(from_point));
}

/// The heart cos 5t - 5 cos t, upright: its tip is the curve's middle, from where its directions are half a turn, and
/// its cleft lies at the distance 4. Seen from a place between them, its border is found by halving.
double heart_radius(double angle)
{
    const double middle = -2.6, x = std::cos(angle + pi / 2), y = std::sin(angle + pi / 2);
    double inside = 0, outside = 6;
    for (int i = 0; i < 50; ++i) {
        const double radius = (inside + outside) / 2, px = middle + radius * x, py = radius * y;
        const double t = std::atan2(py, px);
        (std::hypot(px, py) < std::cos(5 * t) - 5 * std::cos(t) ? inside : outside) = radius;
    }
    return inside;
}

double petals(double angle, double count, double power)
{
    return 0.25 + 0.75 * std::pow(std::abs(std::cos(count * angle / 2)), power);
}

/// A convex hexagon: six borders in directions near those of a regular one, at random distances.
double hexagon_radius(std::uint32_t number, double angle)
{
    double radius = 10;
    for (std::uint32_t side = 0; side < 6; ++side) {
        const auto bits = philox({number, side, 0, 0}, {0x686578, 0});
        const double direction = 2 * pi * (side + 0.6 * (bits[0] / 0x1p32 - 0.5)) / 6;
        const double away = 0.55 + 0.35 * (bits[1] / 0x1p32);
        const double facing = std::cos(angle - direction);
        if (facing > 0) radius = std::min(radius, away / facing);
    }
    return radius;
}

std::vector<std::function<double(double)>> shape_functions()
{
    std::vector<std::function<double(double)>> shapes{
        [](double) { return 1.0; },
        star_radius,
        [](double t) { return petals(t - pi / 2, 5, 0.6); },
        heart_radius,
        [](double t) { return petals(t, 13, 0.7); },
        [](double t) { return superformula(t, 4, 8, 8); },
        [](double t) { return superformula(t, 4, 12, 12); },
        [](double t) { return superformula(t - pi / 2, 3, 6.7, 12); },
        [](double t) { return superformula(t - pi / 2, 5, 2, 7); },
        [](double t) { return superformula(t - pi / 2, 5, 2, 13); },
    };
    for (std::uint32_t i = 0; i < hexagons; ++i) shapes.emplace_back([i](double t) { return hexagon_radius(i, t); });
    return shapes;
}

/// The direction of a step: see shape_radius() in kernels/common/fields/object_looks.h.
double angle_of_step(int step)
{
    const double around = 4.0 * step / int{SHAPE_STEPS}, part = around - std::floor(around);
    const std::array<double, 2> first{1 - part, part};
    switch (static_cast<int>(around)) {
    case 0:
        return std::atan2(first[1], first[0]);
    case 1:
        return std::atan2(first[0], -first[1]);
    case 2:
        return std::atan2(-first[1], -first[0]);
    default:
        return std::atan2(-first[0], first[1]);
    }
}

void append_shape(const std::function<double(double)>& radius, std::vector<float>& radii)
{
    double largest = 0;
    for (int step = 0; step < 16 * SHAPE_STEPS; ++step)
        largest = std::max(largest, radius(2 * pi * step / (16 * SHAPE_STEPS)));
    for (int step = 0; step < SHAPE_STEPS; ++step)
        radii.push_back(static_cast<float>(radius(angle_of_step(step)) / largest));
}

struct Look
{
    std::string name;
    std::vector<Layer> layers;
    std::vector<std::uint32_t> palette; ///< the background, what its noise fades it into, and colours from 2 on
    float noise_cells = 0;
    float modulation = 0;
};

const std::vector<Look>& plane_looks()
{
    static const std::vector<Look> looks{
        {"dots", {{disk_shape, 1, 1, 2, 5}}, {0xfdf6e3, 0xfdf6e3, 0xd33682, 0x268bd2, 0x2aa198, 0xb58900, 0xcb4b16}},
        {"stars", {{star_shape, 1, 1, 2, 2}}, {0x0b1a4a, 0x1b3a8a, 0xffd84a, 0xfff3b0}, 3},
        {"flowers",
         {{flower_shape, 1, 1, 2, 3}, {disk_shape, 1, 0.3f, 5, 1}},
         {0x3f7d2c, 0x6aa84f, 0xf28cb1, 0xffffff, 0xb07ad9, 0xffd23f},
         8},
        {"hearts", {{heart_shape, 1, 1, 2, 3}}, {0xffe8ee, 0xffe8ee, 0xc2183c, 0xe8456b, 0xf06292}},
        {"daisies",
         {{daisy_shape, 1, 1, 2, 1}, {disk_shape, 1, 0.33f, 3, 2}},
         {0x2f6b2a, 0x6b9b37, 0xffffff, 0xffc400, 0xffa000},
         10},
        {"mondriaan",
         {{rounded_square_shape, 2, 1, 2, 1}, {rounded_square_shape, 2, 0.86f, 3, 4}},
         {0xf4f0e4, 0xf4f0e4, 0x101010, 0xd40920, 0x1356a2, 0xf7d842, 0xfafafa}},
        {"squares",
         {{abstract_square_shape, 1, 1, 2, 4}},
         {0x30343c, 0x30343c, 0x8ecae6, 0x219ebc, 0xffb703, 0xfb8500}},
        {"triangles",
         {{rounded_triangle_shape, 1, 1, 2, 4}},
         {0xf1f1ee, 0xf1f1ee, 0x264653, 0x2a9d8f, 0xe9c46a, 0xe76f51}},
        {"starfish",
         {{starfish_shape, 1, 1, 2, 3}, {starfish_inner_shape, 1, 0.72f, 5, 1}},
         {0xe6cf9c, 0xd2b375, 0xd1495b, 0xc8553d, 0xe07a5f, 0xf2b8a0},
         14},
        {"granite",
         {{hexagon_shapes, hexagons, 1, 2, 1}, {hexagon_shapes, hexagons, 0.87f, 3, 5}},
         {0x5b5550, 0x938b84, 0x2b2a2c, 0xb9aca0, 0xd8cec4, 0x8d7468, 0xc49a84, 0x6f6a6a},
         5,
         0.7f},
        {"frames", {}, {0xffffff, 0xffffff}},
        {"inside", {}, {0xffffff, 0xffffff}},
        {"coordinates", {}, {0xffffff, 0xffffff}},
        {"number", {}, {0xffffff, 0xffffff}},
        {"distance", {}, {0xffffff, 0xffffff}},
        {"cells",
         {{disk_shape, 1, 1, 2, 6}},
         {0xffffff, 0xffffff, 0xe41a1c, 0x377eb8, 0x4daf4a, 0x984ea3, 0xff7f00, 0xa65628}},
    };
    return looks;
}

/// Layers name bodies here: 0 a ball, 1 a cube, others stones of so many faces.
const std::vector<Look>& space_looks()
{
    static const std::vector<Look> looks{
        {"dots", {{0, 1, 1, 2, 5}}, {0xfdf6e3, 0xfdf6e3, 0xd33682, 0x268bd2, 0x2aa198, 0xb58900, 0xcb4b16}},
        {"mondriaan",
         {{1, 1, 1, 2, 1}, {1, 1, 0.84f, 3, 4}},
         {0xf4f0e4, 0xf4f0e4, 0x101010, 0xd40920, 0x1356a2, 0xf7d842, 0xfafafa}},
        {"granite",
         {{8, 1, 1, 2, 1}, {8, 1, 0.87f, 3, 5}},
         {0x5b5550, 0x938b84, 0x2b2a2c, 0xb9aca0, 0xd8cec4, 0x8d7468, 0xc49a84, 0x6f6a6a},
         5,
         0.7f},
        {"frames", {}, {0xffffff, 0xffffff}},
        {"inside", {}, {0xffffff, 0xffffff}},
        {"coordinates", {}, {0xffffff, 0xffffff}},
        {"number", {}, {0xffffff, 0xffffff}},
        {"distance", {}, {0xffffff, 0xffffff}},
        {"cells", {{0, 1, 1, 2, 6}}, {0xffffff, 0xffffff, 0xe41a1c, 0x377eb8, 0x4daf4a, 0x984ea3, 0xff7f00, 0xa65628}},
    };
    return looks;
}

const std::vector<Look>& looks_in(int dimension) { return dimension == 3 ? space_looks() : plane_looks(); }

}

double superformula(double angle, double m, double n1, double n)
{
    const double part = m * angle / 4;
    return std::pow(std::pow(std::abs(std::cos(part)), n) + std::pow(std::abs(std::sin(part)), n), -1 / n1);
}

const ObjectShapes& object_shapes()
{
    static const ObjectShapes shapes = [] {
        ObjectShapes all;
        for (const auto& radius : shape_functions()) append_shape(radius, all.radii);
        return all;
    }();
    return shapes;
}

const std::vector<std::string>& object_looks(int dimension)
{
    const auto names = [](const std::vector<Look>& looks) {
        std::vector<std::string> words;
        for (const Look& look : looks) words.push_back(look.name);
        return words;
    };
    static const std::vector<std::string> plane = names(plane_looks()), space = names(space_looks());
    return dimension == 3 ? space : plane;
}

contract::objects::Spread spread_of(const SpreadChoice& choice, double unit)
{
    return {choice.kind == SpreadChoice::Kind::constant  ? std::uint32_t{contract::objects::SPREAD_CONSTANT}
            : choice.kind == SpreadChoice::Kind::uniform ? std::uint32_t{contract::objects::SPREAD_UNIFORM}
                                                         : std::uint32_t{contract::objects::SPREAD_NORMAL},
            static_cast<float>(choice.a / unit), static_cast<float>(choice.b / unit)};
}

void set_look(ObjectScene& scene, const std::string& name, int dimension)
{
    const auto& looks = looks_in(dimension);
    const auto look = std::ranges::find(looks, name, &Look::name);
    if (look == looks.end()) throw std::logic_error("no look of objects is called " + name);
    scene.layers = static_cast<std::uint32_t>(look->layers.size());
    std::ranges::copy(look->layers, scene.layer);
    std::ranges::copy(look->palette, scene.palette);
    scene.background = look->palette[0];
    scene.ripples = look->palette[1];
    scene.noise_cells = look->noise_cells;
    scene.modulation = look->modulation;
    static const std::array<std::string, 7> shown{"", "cells", "frames", "inside", "coordinates", "number", "distance"};
    const auto place = std::ranges::find(shown, name);
    scene.shows =
        place == shown.end() ? std::uint32_t{SHOWS_LAYERS} : static_cast<std::uint32_t>(place - shown.begin());
    scene.has_bodies = dimension == 3;
}

}
