#include "host/sampling/classics/scalloped_region.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr double least_angle = 1e-9;
constexpr double least_area = 1e-12; ///< of the square of the radius

/// The same direction in a range of a turn that begins at `begin`.
double wrapped_from(double begin, double direction)
{
    const double turns = std::floor((direction - begin) / turn);
    return direction - turns * turn;
}

}

/// Rounding must not take roots of negative numbers where a ray touches a circle.
double ScallopedRegion::Arc::at(double direction) const
{
    const double x = direction - angle, across = distance * std::sin(x);
    const double half = std::sqrt(std::max(0.0, radius * radius - across * across));
    return distance * std::cos(x) + (is_far ? half : -half);
}

/// Half the integral of the squared distance.
double ScallopedRegion::Arc::swept(double direction) const
{
    const double x = direction - angle, across = std::clamp(distance * std::sin(x), -radius, radius);
    const double half = std::sqrt(std::max(0.0, radius * radius - across * across));
    const double part = across * half + radius * radius * std::asin(across / radius);
    return (radius * radius * x + distance * across * std::cos(x) + (is_far ? part : -part)) / 2;
}

double ScallopedRegion::Sector::area_to(double direction) const
{
    return outer.swept(direction) - outer.swept(begin) - (inner.swept(direction) - inner.swept(begin));
}

ScallopedRegion::ScallopedRegion(double radius) : radius_(radius)
{
    area_ = 3 * std::numbers::pi * radius * radius;
    sectors_.push_back({0, turn, {0, 0, radius, true}, {0, 0, 2 * radius, true}, area_});
}

/// The directions in which two circles meet.
void ScallopedRegion::add_crossings(const Arc& a, const Arc& b, std::vector<double>& directions)
{
    const double ax = a.distance * std::cos(a.angle), ay = a.distance * std::sin(a.angle);
    const double bx = b.distance * std::cos(b.angle) - ax, by = b.distance * std::sin(b.angle) - ay;
    const double squared = bx * bx + by * by;
    if (squared == 0) return;
    const double along = (squared + a.radius * a.radius - b.radius * b.radius) / (2 * squared);
    const double across = a.radius * a.radius / squared - along * along;
    if (across < 0) return;
    for (const double side : {std::sqrt(across), -std::sqrt(across)})
        directions.push_back(std::atan2(ay + along * by + side * bx, ax + along * bx - side * by));
}

void ScallopedRegion::keep(Sector sector, std::vector<Sector>& result) const
{
    sector.area = sector.area_to(sector.end);
    if (sector.end - sector.begin > least_angle && sector.area > least_area * radius_ * radius_)
        result.push_back(sector);
}

/// Cuts a sector in all of whose directions the disk lies alike, between its arcs `near` and the far one.
void ScallopedRegion::cut(const Sector& sector, const Arc& near, std::vector<Sector>& result) const
{
    Arc far = near;
    far.is_far = true;
    const double middle = (sector.begin + sector.end) / 2;
    const double across = near.distance * std::sin(middle - near.angle);
    const double inner = sector.inner.at(middle), outer = sector.outer.at(middle);
    const bool is_hit = std::abs(across) < near.radius;
    if (!is_hit || far.at(middle) <= inner || near.at(middle) >= outer) {
        keep(sector, result);
        return;
    }
    if (near.at(middle) > inner) keep({sector.begin, sector.end, sector.inner, near, 0}, result);
    if (far.at(middle) < outer) keep({sector.begin, sector.end, far, sector.outer, 0}, result);
}

void ScallopedRegion::subtract(const PolarPlace& centre, double radius)
{
    if (centre.distance - radius >= 2 * radius_) return;
    const Arc near{centre.distance, centre.angle, radius, false};
    const double half = centre.distance > radius ? std::asin(radius / centre.distance) : turn; // of its directions
    std::vector<Sector> result;
    std::vector<double> directions, ends;
    for (const Sector& sector : sectors_) {
        if (half < turn) {
            const double first = wrapped_from(sector.begin, centre.angle - half);
            if (first >= sector.end && first + 2 * half - turn <= sector.begin) {
                result.push_back(sector);
                continue;
            }
        }
        directions.clear();
        if (half < turn) directions = {centre.angle - half, centre.angle + half}; // tangents
        add_crossings(near, sector.inner, directions);
        add_crossings(near, sector.outer, directions);
        ends.assign(1, sector.begin);
        for (const double direction : directions)
            if (const double d = wrapped_from(sector.begin, direction); d < sector.end) ends.push_back(d);
        ends.push_back(sector.end);
        std::ranges::sort(ends);
        for (std::size_t i = 1; i < ends.size(); ++i)
            if (ends[i] > ends[i - 1]) cut({ends[i - 1], ends[i], sector.inner, sector.outer, 0}, near, result);
    }
    sectors_ = std::move(result);
    area_ = 0;
    for (const Sector& sector : sectors_) area_ += sector.area;
}

PolarPlace ScallopedRegion::sample(double u, double v) const
{
    double left = u * area_;
    std::size_t i = 0;
    while (i + 1 < sectors_.size() && left >= sectors_[i].area) left -= sectors_[i++].area;
    const Sector& sector = sectors_[i];
    double begin = sector.begin, end = sector.end;
    for (double middle = (begin + end) / 2; begin < middle && middle < end; middle = (begin + end) / 2)
        (sector.area_to(middle) < left ? begin : end) = middle;
    const double inner = sector.inner.at(end), outer = sector.outer.at(end);
    return {end, std::sqrt(inner * inner + v * (outer * outer - inner * inner))};
}

}
