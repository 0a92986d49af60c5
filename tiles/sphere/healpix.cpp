#include "tiles/sphere/healpix.hpp"

#include "base/geometry/circle_point.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

/// Twice the parts of latitude between the north pole and a square's southern vertex, and eighths of turns at its
/// middle.
constexpr std::array<int, healpix_squares> rows{2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4};
constexpr std::array<int, healpix_squares> eighths{1, 3, 5, 7, 0, 2, 4, 6, 1, 3, 5, 7};

/// A place of a polar cap; `part` is 0 at the pole and 1 at the cap's border, `along` eighths of turns.
SpherePlace cap_place(double part, bool is_north, double along)
{
    const double missing = part * part / 3;
    return {is_north ? 1 - missing : missing - 1, std::sqrt(missing * (2 - missing)), along / 8};
}

/// The square across a side: its number, and the pose that moves places to it. Three sides of a square of the polar
/// rings are those of neighbours that are turned by a quarter.
SeenSquare across(std::uint32_t square, bool is_x, bool is_beyond)
{
    const std::uint32_t i = square % 4, next = (i + 1) % 4, last = (i + 3) % 4;
    switch (square / 4) {
    case 0:
        if (is_beyond) return is_x ? SeenSquare{next, {{0, 2}, 3}} : SeenSquare{last, {{2, 0}, 1}};
        return is_x ? SeenSquare{4 + i, {{1, 0}, 0}} : SeenSquare{4 + next, {{0, 1}, 0}};
    case 1:
        if (is_beyond) return is_x ? SeenSquare{i, {{-1, 0}, 0}} : SeenSquare{last, {{0, -1}, 0}};
        return is_x ? SeenSquare{8 + last, {{1, 0}, 0}} : SeenSquare{8 + i, {{0, 1}, 0}};
    default:
        if (is_beyond) return is_x ? SeenSquare{4 + next, {{-1, 0}, 0}} : SeenSquare{4 + i, {{0, -1}, 0}};
        return is_x ? SeenSquare{8 + last, {{0, 0}, 3}} : SeenSquare{8 + next, {{0, 0}, 1}};
    }
}

}

SpherePlace sphere_place(const HealpixPlace& place)
{
    const double down = rows.at(place.square) - place.x - place.y; // 0 at the north pole, 4 at the south pole
    const double part = std::min({1.0, down, 4 - down});
    if (part <= 0) return {down < 2 ? 1.0 : -1.0, 0, 0};
    double along = eighths.at(place.square) + (place.x - place.y) / part;
    if (along < 0) along += 8;
    if (along >= 8) along -= 8;
    if (part < 1) return cap_place(part, down < 2, along);
    const double z = (2 - down) * 2 / 3;
    return {z, std::sqrt((1 - z) * (1 + z)), along / 8};
}

HealpixPlace healpix_place(const SpherePlace& place)
{
    const double quarters = 4 * place.turns;
    if (3 * std::abs(place.z) <= 2) {
        const double falling = 0.5 + quarters - 0.75 * place.z, rising = 0.5 + quarters + 0.75 * place.z;
        const double below = std::floor(falling), left = std::floor(rising);
        const auto i = static_cast<std::uint32_t>(std::min(below, left)) % 4;
        // Squares of the caps lie between lines of different numbers; those of the equator have both the same.
        const std::uint32_t square = below == left ? 4 + i : below < left ? i : 8 + i;
        return {square, rising - left, 1 - (falling - below)};
    }
    const double quarter = std::min(3.0, std::floor(quarters)), part = quarters - quarter;
    const double from_pole = place.away * std::sqrt(3 / (1 + std::abs(place.z)));
    const double x = std::min(1.0, part * from_pole), y = std::min(1.0, (1 - part) * from_pole);
    const auto i = static_cast<std::uint32_t>(quarter);
    if (place.z > 0) return {i, 1 - y, 1 - x};
    return {8 + i, x, y};
}

UnitVector direction_of(const SpherePlace& place)
{
    const auto [cosine, sine] = circle_point(place.turns);
    return {place.away * cosine, place.away * sine, place.z};
}

SpherePlace place_of_direction(const UnitVector& direction)
{
    const auto [x, y, z] = direction;
    double turns = std::atan2(y, x) / (2 * std::numbers::pi);
    if (turns < 0) turns += 1;
    if (turns >= 1) turns = 0;
    return {z, std::sqrt(x * x + y * y), turns};
}

double least_healpix_stretch()
{
    // At the poles, with the longitude u from the middle of a square, lengths along the parallel are w (dx + 4 u / pi
    // dy), those along the meridian 8 / (3 pi w) dy, w^2 = 2 / 3, in the plane where the squares' sides are pi /
    // sqrt 8. Elsewhere, and for u < pi / 4, the two singular values are nearer to each other.
    constexpr double pi = std::numbers::pi;
    const double area = 8 / (3 * pi), squares = 2 * 2.0 / 3 + area * area * 3 / 2;
    return pi / std::sqrt(8) * std::sqrt((squares - std::sqrt(squares * squares - 4 * area * area)) / 2);
}

SeenSquare square_around(std::uint32_t from, LatticePlace place, std::int64_t side, bool x_first)
{
    SeenSquare seen{from, {}};
    const auto is_outside = [side](std::int64_t c) { return c < 0 || c > side; };
    while (is_outside(place.x) || is_outside(place.y)) {
        const bool is_x = is_outside(place.x) && (x_first || !is_outside(place.y));
        const SeenSquare next = across(seen.square, is_x, (is_x ? place.x : place.y) > side);
        place = turned(next.pose.turn, place) + side * next.pose.shift;
        seen = {next.square, composed(next.pose, seen.pose)};
    }
    return seen;
}

}
