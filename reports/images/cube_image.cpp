#include "reports/images/cube_image.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace poissonlab {

namespace {

using Vector = std::array<double, 3>;

/// The view: the cube is [-1, 1]^3, the viewer far away along (1, 1, 1).
const double across = 1 / std::numbers::sqrt2;
const double up = 1 / std::sqrt(6.0);
const double width = 2 * std::numbers::sqrt2; // of the projected cube
const double height = 4 * std::sqrt(2.0 / 3.0);

/// The place of the cube's surface that is seen at a place of the picture, and the axis that it is perpendicular to.
struct Hit
{
    Vector position{};
    std::size_t axis = 0;
};

/// The position on the line of sight, moved along (1, 1, 1).
Vector moved(const Vector& position, double distance)
{
    return {position[0] + distance, position[1] + distance, position[2] + distance};
}

/// A line of sight meets the cube at the face that it comes to last of the three, going away from the viewer;
/// in the missing eighth it goes on to the first of the coordinate planes.
std::optional<Hit> first_hit(const Vector& line)
{
    const auto highest = std::ranges::max_element(line), lowest = std::ranges::min_element(line);
    const double entry = 1 - *highest, exit = -1 - *lowest;
    if (entry < exit) return std::nullopt;
    Hit hit{moved(line, entry), static_cast<std::size_t>(highest - line.begin())};
    if (std::ranges::all_of(hit.position, [](double x) { return x > 0; }))
        hit = {moved(line, -*lowest), static_cast<std::size_t>(lowest - line.begin())};
    return hit;
}

/// Power at a hit: of the coordinate plane or the outer face that is perpendicular to its axis.
double power_at(const std::vector<Spectrum>& planes, const Hit& hit)
{
    const bool outer = hit.position[hit.axis] > 0.5;
    const Spectrum& plane = planes.at(2 - hit.axis + (outer ? 3 : 0));
    const int half = plane.size / 2;
    const auto frequency = [&](std::size_t axis) {
        const double sign = outer ? -1 : 1; // the face at -M/2 is the one at M/2 upside down
        return std::clamp(static_cast<int>(std::lround(sign * hit.position[axis] * half)), -half, half - 1);
    };
    const int x = frequency(hit.axis == 0 ? 1 : 0), y = frequency(hit.axis == 2 ? 1 : 2);
    return x == 0 && y == 0 && !outer ? 0 : plane.at(x, y); // DC is left out
}

}

GreyImage draw_spectrum_cube(const std::vector<Spectrum>& planes, const ToneMapping& tone_mapping, double scale)
{
    const double pixels = scale * planes.front().size / 2; // of a unit length
    GreyImage image(static_cast<int>(std::ceil(width * pixels)) + 2, static_cast<int>(std::ceil(height * pixels)) + 2,
                    255);
    // Surfaces of neighbouring pixels: where they differ, there is an edge.
    const int nothing = 6;
    const auto surface_of = [&](const std::optional<Hit>& hit) {
        return hit ? static_cast<int>(hit->axis) + (hit->position[hit->axis] > 0.5 ? 3 : 0) : nothing;
    };
    const auto hit_at = [&](int column, int row) {
        const double a = (column + 0.5 - 0.5 * image.width) / pixels, b = (0.5 * image.height - row - 0.5) / pixels;
        return first_hit({-across * a - up * b, across * a - up * b, 2 * up * b});
    };
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width; ++column) {
            const auto hit = hit_at(column, row);
            const int surface = surface_of(hit);
            const bool edge =
                surface != surface_of(hit_at(column + 1, row)) || surface != surface_of(hit_at(column, row + 1));
            if (edge)
                image.at(column, row) = 0;
            else if (hit)
                image.at(column, row) = tone_mapping.grey(power_at(planes, *hit));
        }
    return image;
}

}
