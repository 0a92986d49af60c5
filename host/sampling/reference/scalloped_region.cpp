#include "host/sampling/reference/scalloped_region.hpp"

#include "kernels/common/sectors/sector_darts.h"

#include <algorithm>
#include <cmath>

namespace poissonlab::reference {
namespace {

using contract::directions::direction_of;
using contract::directions::HALF_TURN;
using contract::directions::unit_vector;
using contract::directions::UnitVector;
using contract::sector_darts::LEAST_ANGLE;
using contract::sector_darts::LEAST_AREA;

constexpr double turn = 2 * HALF_TURN;

/// Adds whole turns to a direction, so that it lies in the range of a turn that begins at `begin`.
double wrapped_from(double begin, double direction)
{
    const double turns = std::floor((direction - begin) / turn);
    return direction - turns * turn;
}

}

/// Rounding must not take roots of negative numbers where a ray touches a circle.
double ScallopedRegion::Arc::at(const UnitVector& direction) const
{
    const double beside = across(direction);
    const double half = std::sqrt(std::max(0.0, radius * radius - beside * beside));
    return x * direction.x + y * direction.y + (is_far ? half : -half);
}

/// Half the integral of the squared distance.
double ScallopedRegion::Arc::swept(double angle, const UnitVector& direction) const
{
    if (x == 0 && y == 0) return radius * radius * angle / 2;
    const double beside = std::clamp(across(direction), -radius, radius);
    const double half = std::sqrt(std::max(0.0, radius * radius - beside * beside));
    const double part = beside * half + radius * radius * direction_of(half, beside);
    const double along = x * direction.x + y * direction.y;
    return (radius * radius * angle + beside * along + (is_far ? part : -part)) / 2;
}

double ScallopedRegion::Sector::swept(double angle) const
{
    const UnitVector direction = unit_vector(angle);
    return outer.swept(angle, direction) - inner.swept(angle, direction);
}

ScallopedRegion::ScallopedRegion(double radius) : radius_(radius)
{
    area_ = 3 * HALF_TURN * radius * radius;
    sectors_.push_back({0, turn, {0, 0, radius, true}, {0, 0, 2 * radius, true}, area_});
}

/// The directions in which two circles meet.
void ScallopedRegion::add_crossings(const Arc& a, const Arc& b, std::vector<double>& directions)
{
    const double bx = b.x - a.x, by = b.y - a.y;
    const double squared = bx * bx + by * by;
    if (squared == 0) return;
    const double along = (squared + a.radius * a.radius - b.radius * b.radius) / (2 * squared);
    const double across = a.radius * a.radius / squared - along * along;
    if (across < 0) return;
    for (const double side : {std::sqrt(across), -std::sqrt(across)})
        directions.push_back(direction_of(a.x + along * bx - side * by, a.y + along * by + side * bx));
}

void ScallopedRegion::keep(Sector sector, std::vector<Sector>& result) const
{
    sector.area = sector.swept(sector.end) - sector.swept(sector.begin);
    if (sector.end - sector.begin > LEAST_ANGLE && sector.area > LEAST_AREA * radius_ * radius_)
        result.push_back(sector);
}

/// Cuts a sector in all of whose directions the disk lies alike, between its arcs `near` and the far one.
void ScallopedRegion::cut(const Sector& sector, const Arc& near, std::vector<Sector>& result) const
{
    Arc far = near;
    far.is_far = true;
    const UnitVector middle = unit_vector((sector.begin + sector.end) / 2);
    const double inner = sector.inner.at(middle), outer = sector.outer.at(middle);
    const double nearest = near.at(middle), farthest = far.at(middle);
    const bool is_hit = std::abs(near.across(middle)) < near.radius;
    if (!is_hit || farthest <= inner || nearest >= outer) {
        keep(sector, result);
        return;
    }
    if (nearest > inner) keep({sector.begin, sector.end, sector.inner, near, 0}, result);
    if (farthest < outer) keep({sector.begin, sector.end, far, sector.outer, 0}, result);
}

void ScallopedRegion::subtract(double x, double y, double radius)
{
    const double squared = x * x + y * y, out = radius + 2 * radius_;
    if (squared >= out * out) return;
    const Arc near{x, y, radius, false};
    const double root = std::sqrt(std::max(0.0, squared - radius * radius)), angle = direction_of(x, y);
    const double half = squared > radius * radius ? direction_of(root, radius) : turn; // of its directions
    std::vector<Sector> result;
    std::vector<double> directions, ends;
    for (const Sector& sector : sectors_) {
        if (half < turn) {
            const double first = wrapped_from(sector.begin, angle - half);
            if (first >= sector.end && first + 2 * half - turn <= sector.begin) {
                result.push_back(sector);
                continue;
            }
        }
        directions.clear();
        if (half < turn) directions = {angle - half, angle + half}; // tangents
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
    left += sector.swept(begin);
    for (double middle = (begin + end) / 2; begin < middle && middle < end; middle = (begin + end) / 2)
        (sector.swept(middle) < left ? begin : end) = middle;
    const UnitVector direction = unit_vector(end);
    const double inner = sector.inner.at(direction), outer = sector.outer.at(direction);
    return {end, std::sqrt(inner * inner + v * (outer * outer - inner * inner))};
}

}
