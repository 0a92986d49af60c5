#include "host/distribution/instances/instance_view.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace poissonlab {
namespace {

constexpr int samples_a_pixel = 3;
constexpr int rows_at_once = 64; ///< of pixels

using LinearColor = std::array<double, 3>;
using Direction = std::array<double, 3>;

constexpr Direction sunlight{-0.48, 0.48, 0.7342}; ///< from the upper left
constexpr LinearColor forest_floor{0.55, 0.5, 0.42}, field_soil{0.36, 0.42, 0.2}, space{0.01, 0.01, 0.02};

LinearColor lit(const LinearColor& color, double light)
{
    return {color[0] * light, color[1] * light, color[2] * light};
}

double lambert(Direction normal, double ambient)
{
    const double length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    const double cosine =
        (normal[0] * sunlight[0] + normal[1] * sunlight[1] + normal[2] * sunlight[2]) / std::max(length, 1e-12);
    return ambient + (1 - ambient) * std::max(0.0, cosine);
}

/// The colours of the first and the last model of a scene.
std::array<LinearColor, 2> colors_of_models(const std::string& scene)
{
    if (scene == "forest") return {{{0.2, 0.42, 0.14}, {0.62, 0.55, 0.2}}};
    if (scene == "sunflowers") return {{{0.98, 0.8, 0.1}, {0.95, 0.62, 0.05}}};
    return {{{0.6, 0.56, 0.52}, {0.78, 0.66, 0.5}}};
}

/// A place on an instance: in its own coordinates, of which 1 is its radius, and turned with it.
struct BodyPlace
{
    double x = 0, y = 0; ///< in directions of the picture
    double away = 0;     ///< from the middle
    double angle = 0;    ///< from the instance's own x axis
};

/// The surface that is seen there; none where the body has a gap.
struct SeenBody
{
    LinearColor color{};
    double height = 0; ///< above its middle, in its radius
};

std::optional<SeenBody> tree_at(const Instance& tree, const InstanceSettings& settings, const BodyPlace& p)
{
    const double lobes = 5 + tree.model % 4;
    const double border = 0.88 + 0.12 * std::cos(lobes * p.angle);
    if (p.away >= border) return std::nullopt;
    const double height = std::sqrt(1 - p.away * p.away / (border * border));
    const double u = p.away * std::cos(p.angle), v = p.away * std::sin(p.angle);
    const double bump_x = 0.4 * std::sin(7 * u + 2 * std::sin(6 * v)),
                 bump_y = 0.4 * std::sin(6 * v - 3 * std::sin(5 * u));
    const LinearColor color = color_of_model(settings, tree.model);
    return SeenBody{lit(color, lambert({p.x + bump_x, p.y + bump_y, height + 0.35}, 0.3)), height};
}

std::optional<SeenBody> sunflower_at(const Instance& flower, const InstanceSettings& settings, const BodyPlace& p)
{
    constexpr double disc = 0.4;
    const double petals = 13 + flower.model % 5;
    if (p.away < disc) {
        const double seeds = 0.8 + 0.2 * std::sin(40 * p.away) * std::cos(21 * p.angle + 30 * p.away);
        return SeenBody{lit({0.36, 0.2, 0.08}, seeds * lambert({p.x, p.y, 0.9}, 0.4)), 1};
    }
    const double wave = std::abs(std::cos(petals * p.angle / 2));
    if (p.away >= 0.55 + 0.45 * std::sqrt(wave)) return std::nullopt;
    const LinearColor color = color_of_model(settings, flower.model);
    return SeenBody{lit(color, (0.75 + 0.25 * wave) * lambert({0.3 * p.x, 0.3 * p.y, 1}, 0.5)), 0.9};
}

std::optional<SeenBody> rock_at(const Instance& rock, const InstanceSettings& settings, const BodyPlace& p)
{
    const double phase = rock.model;
    const double border = 0.78 + 0.12 * std::sin(2 * p.angle + phase) + 0.08 * std::sin(5 * p.angle + 3 * phase);
    if (p.away >= border) return std::nullopt;
    const double height = std::sqrt(1 - p.away * p.away / (border * border));
    const double u = p.away * std::cos(p.angle), v = p.away * std::sin(p.angle);
    const double bump_x = 0.4 * std::sin(9 * u + phase), bump_y = 0.4 * std::sin(8 * v - 2 * phase);
    const LinearColor color = color_of_model(settings, rock.model);
    return SeenBody{lit(color, lambert({p.x + bump_x, p.y + bump_y, height + 0.1}, 0.08)), height};
}

std::optional<SeenBody> body_at(const Instance& instance, const InstanceSettings& settings, const BodyPlace& place)
{
    if (settings.scene == "forest") return tree_at(instance, settings, place);
    if (settings.scene == "sunflowers") return sunflower_at(instance, settings, place);
    return rock_at(instance, settings, place);
}

/// The ground: soil in the light of the terrain's slopes; for asteroids a planet with bands in the middle of the ring.
LinearColor ground_at(const InstanceSettings& settings, const std::optional<Terrain>& terrain, double x, double y,
                      double step)
{
    if (settings.scene == "asteroids") {
        const double planet = 0.7 * settings.ring[0], squared = (x * x + y * y) / (planet * planet);
        if (squared >= 1) return space;
        const double nx = x / planet, ny = y / planet, nz = std::sqrt(1 - squared);
        const double tilted = 0.9 * ny + 0.44 * nz;
        const double band = 0.5 + 0.3 * std::sin(19 * tilted) + 0.2 * std::sin(47 * tilted + 1);
        return lit({0.86 - 0.16 * band, 0.74 - 0.16 * band, 0.52 - 0.1 * band}, lambert({nx, ny, nz}, 0.02));
    }
    const LinearColor soil = settings.scene == "forest" ? forest_floor : field_soil;
    if (!terrain) return lit(soil, 0.8);
    const double dx = (terrain->at(x + step, y) - terrain->at(x - step, y)) / (2 * step);
    const double dy = (terrain->at(x, y + step) - terrain->at(x, y - step)) / (2 * step);
    return lit(soil, lambert({-dx, -dy, 1}, 0.25));
}

/// Rows of pixels, with places in between.
class ViewRows
{
public:
    ViewRows(const InstanceSettings& settings, int width, int first, int rows, int height, double pixel)
        : settings_(settings), width_(width * samples_a_pixel), rows_(rows * samples_a_pixel),
          step_(pixel / samples_a_pixel), left_(settings.window[0]),
          top_(settings.window[1] + height * pixel - first * pixel),
          colors_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(rows_)), heights_(colors_.size(), -1e300)
    {}

    void paint_ground(const std::optional<Terrain>& terrain)
    {
        for (int row = 0; row < rows_; ++row)
            for (int column = 0; column < width_; ++column)
                colors_[at(column, row)] = ground_at(settings_, terrain, x_of(column), y_of(row), step_);
    }

    /// Darkens the ground away from the light.
    void paint_shadow(const Instance& instance, double radius)
    {
        const double x = instance.position[0] + 0.45 * radius, y = instance.position[1] - 0.45 * radius;
        for_places(x, y, 0.9 * radius, [&](std::size_t place, double dx, double dy) {
            if (heights_[place] > -1e299 || dx * dx + dy * dy > 0.81 * radius * radius) return;
            heights_[place] = -1e299; // once
            colors_[place] = lit(colors_[place], 0.55);
        });
    }

    void paint_body(const Instance& instance, double radius)
    {
        // A tilted body leans: its top is beside its foot, within the disk.
        const double lean = instance.tilt > 1 ? 0 : 0.25 * radius * std::sin(instance.tilt);
        const double x = instance.position[0] + lean * std::cos(instance.tilt_direction);
        const double y = instance.position[1] + lean * std::sin(instance.tilt_direction);
        for_places(x, y, radius, [&](std::size_t place, double dx, double dy) {
            const BodyPlace p{dx / radius, dy / radius, std::sqrt(dx * dx + dy * dy) / radius,
                              std::atan2(dy, dx) - instance.turn};
            const auto seen = body_at(instance, settings_, p);
            if (!seen) return;
            const double height = instance.position[2] + seen->height * radius;
            if (height <= heights_[place]) return;
            heights_[place] = height;
            colors_[place] = seen->color;
        });
    }

    /// The mean of a pixel's places, as light is seen.
    void append_pixel(int column, int row, std::vector<std::uint8_t>& values) const
    {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            double sum = 0;
            for (int y = 0; y < samples_a_pixel; ++y)
                for (int x = 0; x < samples_a_pixel; ++x)
                    sum += colors_[at(column * samples_a_pixel + x, row * samples_a_pixel + y)][channel];
            const double mean = std::clamp(sum / (samples_a_pixel * samples_a_pixel), 0.0, 1.0);
            values.push_back(static_cast<std::uint8_t>(std::lround(255 * std::pow(mean, 1 / 1.6))));
        }
    }

    /// True if something at this height of the scene may be seen here.
    bool reaches(double y, double radius) const
    {
        return y + 2 * radius >= top_ - rows_ * step_ && y - 2 * radius <= top_;
    }

private:
    double x_of(int column) const { return left_ + (column + 0.5) * step_; }
    double y_of(int row) const { return top_ - (row + 0.5) * step_; }
    std::size_t at(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column);
    }

    /// Calls for all places within `reach` of (x, y) along each axis, with their distances along them.
    template <class Paint>
    void for_places(double x, double y, double reach, Paint paint)
    {
        const auto place = [](double number, int count) {
            return static_cast<int>(std::clamp(std::floor(number), 0.0, static_cast<double>(count)));
        };
        const int first = place((x - reach - left_) / step_, width_);
        const int last = place((x + reach - left_) / step_ + 1, width_);
        const int lowest = place((top_ - y + reach) / step_ + 1, rows_);
        for (int row = place((top_ - y - reach) / step_, rows_); row < lowest; ++row)
            for (int column = first; column < last; ++column) {
                const double dx = x_of(column) - x, dy = y_of(row) - y;
                if (dx * dx + dy * dy < reach * reach) paint(at(column, row), dx, dy);
            }
    }

    const InstanceSettings& settings_;
    int width_, rows_;
    double step_, left_, top_;
    std::vector<LinearColor> colors_;
    std::vector<double> heights_;
};

}

std::array<double, 3> color_of_model(const InstanceSettings& settings, std::uint32_t model)
{
    const auto [first, last] = colors_of_models(settings.scene);
    const double part = settings.models > 1 ? static_cast<double>(model) / (settings.models - 1) : 0;
    LinearColor color{};
    for (std::size_t i = 0; i < 3; ++i) color[i] = first[i] + (last[i] - first[i]) * part;
    return color;
}

PngPixels view_from_above(const std::vector<Instance>& instances, const InstanceSettings& settings, double radius)
{
    const auto width = static_cast<int>(settings.pixels);
    const double pixel = settings.window[2] / width, rows = std::max(1.0, std::round(settings.window[3] / pixel));
    if (rows > most_view_pixels)
        throw InputError(fmt::format("a view of {} x {:.0f} pixels: must be at most {} along a side", width, rows,
                                     most_view_pixels));
    PngPixels view{width, static_cast<int>(rows), 3, {}};
    const std::optional<Terrain> terrain = terrain_of(settings);
    for (int first = 0; first < view.height; first += rows_at_once) {
        stop_if_interrupted();
        const int count = std::min(rows_at_once, view.height - first);
        ViewRows band(settings, width, first, count, view.height, pixel);
        band.paint_ground(terrain);
        const auto paint = [&](auto what) {
            for (const Instance& instance : instances)
                if (band.reaches(instance.position[1], radius)) (band.*what)(instance, radius * instance.scale);
        };
        if (settings.scene != "asteroids") paint(&ViewRows::paint_shadow);
        paint(&ViewRows::paint_body);
        for (int row = 0; row < count; ++row)
            for (int column = 0; column < width; ++column) band.append_pixel(column, row, view.values);
    }
    return view;
}

}
