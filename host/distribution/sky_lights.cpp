#include "host/distribution/sky_lights.hpp"

#include "base/densities/density_text.hpp"
#include "base/errors/errors.hpp"
#include "base/files/file_kind.hpp"
#include "base/geometry/circle_point.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

constexpr double place_units = 4294967296.0; // of a pixel

/// The colour of a pixel, as bright as that.
std::vector<double> pixel_power(const LinearPicture& map, int column, int row, double luminance_of_light)
{
    constexpr std::array<double, 3> shares{0.2126, 0.7152, 0.0722}; // of luminance
    const std::size_t colors = map.channels.size() - (map.alpha ? 1 : 0) < 3 ? 1 : 3;
    std::vector<double> power;
    double whole = 0;
    for (std::size_t c = 0; c < colors; ++c) {
        power.push_back(std::max(0.0, static_cast<double>(map.at(column, row, c))));
        whole += power.back() * (colors == 1 ? 1 : shares.at(c));
    }
    for (double& of_color : power) of_color *= luminance_of_light / whole;
    return power;
}

/// The cosine of the polar angle at a height of the map.
double height_cosine(std::uint64_t place, int height)
{
    const auto from_bottom = static_cast<int>(place >> 32);
    const double in_row = static_cast<double>(place & 0xffffffff) / place_units;
    const double above = border_cosine(height - 1 - from_bottom, height);
    const double below = border_cosine(height - from_bottom, height);
    return below + (above - below) * in_row;
}

}

LinearPicture sky_map(const std::string& text)
{
    if (is_file_name(text)) return read_linear_picture(text);
    const Density density = density_of_text(text, "light", 2, 1);
    LinearPicture map{density.width, density.height, {"Y"}, {}, {}};
    for (int row = map.height; row-- > 0;)
        for (int column = 0; column < map.width; ++column)
            map.values.push_back(static_cast<float>(
                static_cast<double>(
                    density.weights[static_cast<std::size_t>(row) * static_cast<std::size_t>(map.width) +
                                    static_cast<std::size_t>(column)]) /
                static_cast<double>(full_weight)));
    return map;
}

double border_cosine(int row, int height) { return circle_point(row / (2.0 * height))[0]; }

double solid_angle(int row, int width, int height)
{
    return 2 * std::numbers::pi / width * (border_cosine(row, height) - border_cosine(row + 1, height));
}

Density sky_density(const LinearPicture& map, const std::string& name)
{
    if (map.width != 2 * map.height)
        throw InputError(fmt::format("{}: {} x {} pixels: an environment map must be twice as wide as high (longitude "
                                     "to the right, the pole at the top)",
                                     name, map.width, map.height));
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height));
    for (int row = map.height; row-- > 0;) {
        const double angle = solid_angle(row, map.width, map.height);
        for (int column = 0; column < map.width; ++column) values.push_back(luminance(map, column, row) * angle);
    }
    return density_of_values(map.width, map.height, values, name);
}

double sky_luminance(const LinearPicture& map)
{
    double sum = 0;
    for (int row = 0; row < map.height; ++row) {
        double in_row = 0;
        for (int column = 0; column < map.width; ++column) in_row += std::max(0.0, luminance(map, column, row));
        sum += in_row * solid_angle(row, map.width, map.height);
    }
    return sum;
}

std::vector<SkyLight> sky_lights(const LinearPicture& map, std::span<const std::uint64_t> places, SeenFrom seen_from)
{
    const double each = sky_luminance(map) / (static_cast<double>(places.size()) / 2);
    std::vector<SkyLight> lights;
    lights.reserve(places.size() / 2);
    for (std::size_t i = 0; i < places.size(); i += 2) {
        const double z = height_cosine(places[i + 1], map.height);
        const double away = std::sqrt(std::max(0.0, 1 - z * z));
        const auto [cosine, sine] = circle_point(static_cast<double>(places[i]) / place_units / map.width);
        const auto column = static_cast<int>(places[i] >> 32);
        const int row = map.height - 1 - static_cast<int>(places[i + 1] >> 32);
        // From inside, the angle is half a turn less the other one.
        const double x = seen_from == SeenFrom::inside ? -cosine : cosine;
        lights.push_back({{away * x, away * sine, z}, pixel_power(map, column, row, each)});
    }
    return lights;
}

std::string lights_text(const std::vector<SkyLight>& lights)
{
    std::string text = lights.front().power.size() == 3 ? "x,y,z,red,green,blue\n" : "x,y,z,power\n";
    for (const SkyLight& light : lights)
        text += fmt::format("{},{}\n", fmt::join(light.direction, ","), fmt::join(light.power, ","));
    return text;
}

}
